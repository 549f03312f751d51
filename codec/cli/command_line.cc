// The only file that knows the argument parser.
#include "codec/cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>

#include "codec/cli/commands.h"
#include "codec/cli/files.h"
#include "codec/cli/foreign.h"
#include "codec/cli/precision.h"
#include "codec/cli/printable.h"
#include "codec/cli/words.h"
#include "topology/modeling/multi_triangulation.h"
#include <clers/version.h>

namespace clers::cli {
namespace {

constexpr char exit_statuses[] =
    "Exit status: 0 done; 1 verify found a difference; 2 usage, or an output exists;\n"
    "3 an input cannot be read or is not accepted; 4 a limit was hit; 5 writing\n"
    "failed; 6 verify could not decide.";

constexpr unsigned most_levels = MultiTriangulation::max_level;

/// What other programs call our commands.
const std::map<std::string, std::string> other_names = {
    {"compress", "encode"},     {"pack", "encode"},
    {"zip", "encode"},          {"decompress", "decode"},
    {"uncompress", "decode"},   {"unpack", "decode"},
    {"extract", "decode"},      {"restore", "decode"},
    {"list", "info"},           {"show", "info"},
    {"inspect", "info"},        {"stat", "info"},
    {"test", "verify"},         {"compare", "verify"},
    {"diff", "verify"},         {"measure", "check"},
    {"validate", "check"},      {"refine", "adapt"},
    {"decimate", "simplify"},   {"reduce", "simplify"},
    {"surface", "reconstruct"}, {"triangulate", "reconstruct"},
    {"pivot", "reconstruct"}};

std::string in_quotes(const std::string& text) {
  return "'" + printable(text) + "'";
}

/// All of the text as a number.
template <class T>
bool parse(std::string_view text, T& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

/// A number of bytes, plain or with k, M, G or T and perhaps B or iB behind it: powers of 1024.
bool parse_size(std::string_view text, std::uint64_t& size) {
  for (const std::string_view bytes : {"iB", "B"})
    if (text.ends_with(bytes)) {
      text.remove_suffix(bytes.size());
      if (bytes == "iB" && (text.empty() || std::isdigit(static_cast<unsigned char>(text.back()))))
        return false;
      break;
    }
  const std::size_t power =
      text.empty() ? 0 : std::string_view("kKmMgGtT").find(text.back()) / 2 + 1;
  const bool has_unit = power >= 1 && power <= 4;
  if (has_unit) text.remove_suffix(1);
  const unsigned shift = has_unit ? 10 * static_cast<unsigned>(power) : 0;
  if (!parse(text, size) || size > ~std::uint64_t{0} >> shift) return false;
  size <<= shift;
  return true;
}

/// Help that fits 80 columns.
class Help : public CLI::Formatter {
 public:
  Help() {
    column_width(left);
    label("SUBCOMMAND", "COMMAND");
    label("Positionals", "Arguments");
  }
  std::string make_option(const CLI::Option* option, bool positional) const override {
    return row(make_option_name(option, positional) + make_option_opts(option),
               make_option_desc(option));
  }
  std::string make_subcommand(const CLI::App* sub) const override {
    return row(sub->get_display_name(true), sub->get_description());
  }
  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string& text = option->get_option_text();
    return text.empty() ? "" : " " + text;
  }
  std::string make_option_name(const CLI::Option* option, bool positional) const override {
    return option->check_name("-1") ? "-1 .. -9" : Formatter::make_option_name(option, positional);
  }

 private:
  static constexpr std::size_t left = 26, all = 79;

  /// The name, and what it means from column `left` on.
  static std::string row(const std::string& name, const std::string& what) {
    std::string out, line = "  " + name;
    if (line.size() + 2 > left) {
      out = line + "\n";
      line.clear();
    }
    line.resize(left, ' ');
    std::string_view rest = what;
    while (rest.size() > all - left) {
      const std::size_t space = rest.rfind(' ', all - left);
      if (space == std::string_view::npos) break;
      out.append(line).append(rest.substr(0, space)).append("\n");
      line.assign(left, ' ');
      rest.remove_prefix(space + 1);
    }
    return out.append(line).append(rest).append("\n");
  }
};

class CommandLine {
 public:
  CommandLine() {
    app_.formatter(std::make_shared<Help>());
    app_.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    app_.require_subcommand(0, 1);  // none: run() says so better
    app_.set_help_flag("-h,--help", "print this help and exit");
    app_.set_version_flag("-V,--version", std::string("clers ") + version, "print the version");
    app_.footer(
        std::string("Examples:\n"
                    "  clers encode bunny.ply               makes bunny.clers\n"
                    "  clers decode bunny.clers -o bunny.obj\n"
                    "  clers verify bunny.ply bunny.clers\n"
                    "  clers encode scans/*.ply -o packed/\n"
                    "`clers help COMMAND` has more. A file `-` is standard input or output.\n\n") +
        exit_statuses);
    add_encode();
    add_decode();
    add_info();
    add_verify();
    add_check();
    add_subdivide();
    add_adapt();
    add_simplify();
    add_reconstruct();
    CLI::App* help = app_.add_subcommand("help", "Explain a command")->group("Commands");
    help->footer("Examples:\n  clers help encode");
    help->add_option("COMMAND", topic_, "what to explain; none: the program")->option_text(" ");
    help->callback([this] { help_ = true; });
  }

  Exit run(int argc, char** argv) {
    dashes_ = std::find(argv, argv + argc, std::string_view("--")) != argv + argc;
    const std::span<char* const> words(argv, static_cast<std::size_t>(argc));
    if (const auto wrong = level_of_two_digits(words); wrong && !dashes_) return usage(*wrong);
    try {
      app_.parse(argc, argv);
    } catch (const CLI::CallForVersion& asked) {
      return say(std::string(asked.what()) + "\n");
    } catch (const CLI::Success&) {  // --help, of the program or of a command
      return say(app_.help());
    } catch (const CLI::ParseError& error) {
      if (const auto unknown = unknown_argument()) return usage(*unknown);
      return usage(error.what());
    }
    if (help_) {
      if (const auto unknown = unknown_argument()) return usage(*unknown);
      return explain();
    }
    if (command_ == nullptr) return usage("a command is needed: " + list(command_names(), "or"));
    if (!digit_.empty()) options_.encode.level = digit_[0] - '0';
    options_.inputs = many_;
    if (!original_.empty()) options_.inputs.push_back(original_);
    if (!one_.empty()) options_.inputs.push_back(one_);
    if (const auto unknown = unknown_argument()) return usage(*unknown);
    if (const auto wrong = mistaken_input()) return usage(*wrong);
    return command_(options_);
  }

 private:
  using Command = Exit (*)(const Options&);

  // ---- Commands

  void add_encode() {
    CLI::App& encode =
        add("encode", cli::encode, "Compress mesh files",
            missing_decoders() +
                "Without -o, a.ply becomes a.clers beside it, and standard input goes to standard\n"
                "output.\n\n"
                "Examples:\n"
                "  clers encode bunny.ply\n"
                "  clers encode -9 a.obj b.off c.stl -o packed/\n"
                "  clers encode --positions q14 --attribute normal=q10 scan.ply\n"
                "  clers encode scene.glb -o small.glb     a glTF with an extension\n"
                "  clers encode old.drc -o new.clers\n"
                "  curl -s https://example.org/m.ply | clers encode --from ply - >m.clers");
    inputs(encode, "mesh files: ply, obj, off, stl, drc; scenes: glb, gltf");
    output(
        encode,
        "the .clers file, or a .glb or .gltf with .clers files in it; or a directory for several");
    from(encode);
    CLI::Option* digits = encode.add_flag("-1{1},-2{2},-3{3},-4{4},-5{5},-6{6},-7{7},-8{8},-9{9}",
                                          digit_, "the level, as --level");
    number(encode, "--level", options_.encode.level, min_level, max_level,
           "1 is fastest, 9 is smallest; 5 is the default")
        .excludes(digits);
    choice(encode, "--order", options_.encode.order, {{"free", Order::free}, {"keep", Order::keep}},
           "keep: the order of vertices and faces comes back too; free is the default")
        .option_text("free|keep");
    encode
        .add_option(
            "--pieces",
            [this](const CLI::results_t& values) {
              return parse_pieces(values.back(), options_.encode.piece_faces);
            },
            fmt::format(
                "split meshes of more than N faces into pieces of about N that decode alone; "
                "default: {}, if there are more than {}",
                default_piece_faces, most_faces_whole))
        ->option_text("N|never");
    encode
        .add_option(
            "--positions",
            [this](const CLI::results_t& values) {
              add_precision("--positions", position_name, values.back());
              return true;
            },
            "how exact they come back: lossless, the default; q<bits>, 1 to 30, for the longest "
            "side; step<size>; error<size>, the largest; grid:<origin>:<step>, as grid:0,0,0:0.01")
        ->option_text("HOW");
    encode
        .add_option(
            "--attribute",
            [this](const CLI::results_t& values) {
              for (const std::string& value : values) {
                const std::size_t equals = value.rfind('=');
                if (equals == value.npos)
                  refuse("--attribute", "a name and how exact, such as normal=q10", value);
                add_precision("--attribute", value.substr(0, equals), value.substr(equals + 1));
              }
              return true;
            },
            "the same of another attribute, such as normal=q10; may be given for several. q<bits> "
            "of "
            "unit vectors, 2 to 20, is oct<bits>: directions, off by an angle, whatever their "
            "length; "
            "recompute<degrees>: normals that follow from positions and faces, to within an angle")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->option_text("NAME=HOW");
    threads(encode);
    policy(encode, "--on-nonmanifold", options_.encode.on_nonmanifold,
           "reject: refuse edges of more than two faces, vertices of several fans, one-sided "
           "surfaces");
    policy(encode, "--on-degenerate", options_.encode.on_degenerate,
           "reject: refuse faces that use a vertex twice, or have fewer than three corners");
    policy(encode, "--on-duplicate", options_.encode.on_duplicate,
           "reject: refuse faces on the same vertices as another");
    encode.add_flag("--strict", options_.strict,
                    "refuse a file of which something cannot be carried, such as materials");
    keep_or_remove(encode);
    force(encode);
    quiet(encode);
  }

  void add_decode() {
    CLI::App& decode =
        add("decode", cli::decode, "Restore mesh files",
            "Without -o, a.clers becomes a file beside it in the format that was encoded, and\n"
            "standard input goes to standard output.\n\n"
            "Examples:\n"
            "  clers decode bunny.clers\n"
            "  clers decode packed/*.clers --to obj -o restored/\n"
            "  clers decode bunny.clers --to off -c | head");
    inputs(decode, ".clers files");
    output(decode, "the mesh file, or a directory for several");
    to(decode, "format of the output; default: by its name, else as encoded, else ply");
    text(decode);
    decode
        .add_option(
            "--piece",
            [this](const CLI::results_t& values) {
              if (!parse(values.back(), options_.piece.emplace()))
                refuse("--piece", "the number of a piece, from 0", values.back());
              return true;
            },
            "only piece K, counted from 0 through all meshes; clers info says how many there are")
        ->option_text("K");
    threads(decode);
    limits(decode);
    keep_or_remove(decode);
    force(decode);
    quiet(decode);
  }

  void add_info() {
    CLI::App& info = add("info", cli::info, "Describe .clers files: their meshes and their cost",
                         "Several files: a line each.\n\n"
                         "Examples:\n"
                         "  clers info bunny.clers\n"
                         "  clers info packed/*.clers\n"
                         "  clers info --json bunny.clers | jq .connectivity_bits_per_triangle");
    inputs(info, ".clers files");
    json(info);
    limits(info);
  }

  void add_verify() {
    CLI::App& verify =
        add("verify", cli::verify, "Decode a file and compare it with its original",
            "Faces and vertices may be in another order; all else must be equal bit for bit.\n"
            "What a mesh file has that is not carried is named, and is a difference only\n"
            "with --strict. Exit status 1: they differ; 6: this could not be decided.\n\n"
            "Examples:\n"
            "  clers verify bunny.ply bunny.clers");
    verify.add_option("ORIGINAL", original_, "the mesh file that was encoded")
        ->required()
        ->option_text(" ");
    verify.add_option("FILE", one_, "the .clers file")->required()->option_text(" ");
    from(verify);
    verify.add_flag("--strict", options_.strict, "what is not carried is a difference too");
    threads(verify);
    limits(verify);
    quiet(verify);
  }

  void add_check() {
    CLI::App& check = add("check", cli::check, "Measure mesh files: their shape and their defects",
                          "Several files: a line each.\n\n"
                          "Examples:\n"
                          "  clers check bunny.ply\n"
                          "  clers check scans/*.ply\n"
                          "  clers check --json bunny.ply | jq .genus");
    inputs(check, "mesh files: ply, obj, off, stl, drc; scenes: glb, gltf");
    from(check);
    json(check);
    quiet(check);
  }

  void add_subdivide() {
    CLI::App& subdivide =
        add("subdivide", cli::subdivide, "Subdivide mesh files towards a smooth surface",
            "loop makes 4 triangles of one, sqrt3 makes 3; 4-8 first pairs triangles and\n"
            "halves them, and then makes 2 of one. The number of components, boundary curves\n"
            "and handles stays. Polygons and non-manifold meshes are refused.\n\n"
            "Examples:\n"
            "  clers subdivide bunny.ply -o smooth.ply --scheme loop\n"
            "  clers subdivide bunny.ply -o finer.obj --scheme sqrt3 --times 2\n"
            "  clers subdivide a.obj b.off --scheme 4-8 --times 4 --to ply -o finer/");
    inputs(subdivide, "mesh files: ply, obj, off, stl, drc");
    output(subdivide, "the mesh file, or a directory for several");
    choice(subdivide, "--scheme", options_.subdivision.scheme,
           {{"sqrt3", Scheme::sqrt3}, {"loop", Scheme::loop}, {"4-8", Scheme::four_eight}},
           "how; required")
        .required()
        ->option_text("sqrt3|loop|4-8");
    number(subdivide, "--times", options_.subdivision.times, 1u, 30u,
           "how many steps, 1 to 30; 1 is the default");
    formats(subdivide);
  }

  void add_adapt() {
    Adaptation& how = options_.adaptation;
    CLI::App& adapt =
        add("adapt", cli::adapt, "Triangulate surfaces anew, as finely as is asked for where",
            "The surface of the input is kept; a mesh with coarse and fine parts follows it,\n"
            "made by splits of its edges. Faces are split where any of --level, --edge-length\n"
            "and --error asks for it, those first that are farthest from it. LENGTH is in the\n"
            "units of the file, or with % of the diagonal of its bounding box. Components,\n"
            "boundary curves and handles stay. Quadrilaterals are split as they are.\n\n"
            "Examples:\n"
            "  clers adapt bunny.ply -o light.ply --error 0.1%\n"
            "  clers adapt bunny.ply -o light.ply --error 0.01% --max-faces 20000\n"
            "  clers adapt bunny.ply -o eye.ply --near 0.1,0.2,0,0.05 --level 12\n"
            "  clers adapt cage.obj -o finer.obj --base input --level 4\n"
            "  clers adapt a.ply -o b.ply --near 0,0,0,1 --near 9,0,0,1 --level 9 --frames d");
    inputs(adapt, "mesh files: ply, obj, off, stl");
    output(adapt, "the mesh file, or a directory for several");
    adapt
        .add_option(
            "--level",
            [&how](const CLI::results_t& values) {
              if (!parse(values.back(), how.level.emplace()) || *how.level > most_levels)
                refuse("--level", fmt::format("a number from 0 to {}", most_levels), values.back());
              return true;
            },
            "split the faces of the base N times, which two by two halves their edges: near "
            "what --near says, else everywhere")
        ->option_text("N");
    adapt
        .add_option(
            "--near",
            [&how](const CLI::results_t& values) {
              for (const std::string& value : values) how.near.push_back(parse_ball(value));
              return true;
            },
            "where --level counts: in the ball around x, y, z of radius r; elsewhere it falls by "
            "one from face to face. May be given several times")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->option_text("x,y,z,r");
    extent(adapt, "--edge-length", how.edge_length, "split edges that are longer");
    extent(adapt, "--error", how.error,
           "split where the surface is farther than this from the middle of an edge");
    number(adapt, "--max-faces", how.faces, 1u, max_faces,
           "split no further than that; 10000000 is the default");
    adapt
        .add_option(
            "--base",
            [&how](const CLI::results_t& values) {
              how.base.reset();
              if (values.back() != "input" &&
                  (!parse(values.back(), how.base.emplace()) || how.base == 0))
                refuse("--base", "a number of faces or input", values.back());
              return true;
            },
            "make an input of more than N faces coarser first, to N or so; input: it is the base "
            "itself. 2000 is the default")
        ->option_text("N|input");
    adapt
        .add_option_function<std::string>(
            "--frames",
            [this](const std::string& directory) {
              options_.frames = directory;
              options_.adaptation.frames = true;
            },
            "write a sequence, frame-0001 and so on: the mesh after each level; or, with --near "
            "given more than once, as the ball goes from the first place to the last")
        ->option_text("DIR");
    json(adapt);
    formats(adapt);
  }

  void add_simplify() {
    Fewer& how = options_.fewer;
    CLI::App& simplify =
        add("simplify", cli::simplify, "Make meshes of fewer faces near the same surfaces",
            "Contracts one edge after the other, the cheapest first, until so few faces are\n"
            "left, or until each other would take the surface farther than the error; without\n"
            "either, to half the faces. Components, boundary curves and handles stay, and so\n"
            "do seams of textures, normals and materials. Values of vertices, corners and\n"
            "faces go along. Polygons become triangles; what is no manifold is cut, which is\n"
            "said.\n\n"
            "Examples:\n"
            "  clers simplify scan.ply -o half.ply\n"
            "  clers simplify scan.ply -o light.ply --faces 20000\n"
            "  clers simplify scans/*.ply -o light/ --faces 10%\n"
            "  clers simplify part.stl -o part.obj --error 0.05%");
    inputs(simplify, "mesh files: ply, obj, off, stl, drc");
    output(simplify, "the mesh file, or a directory for several");
    simplify
        .add_option(
            "--faces",
            [&how](const CLI::results_t& values) {
              how.faces = parse_faces(values.back());
              return true;
            },
            "how many to leave of a mesh, or which share; 0: as few as there can be. Without "
            "--error, 50% is the default")
        ->option_text("N|P%");
    extent(simplify, "--error", how.error,
           "how far the surface may move, in the units of the file, or with % of the diagonal of "
           "its bounding box",
           true);
    json(simplify);
    formats(simplify);
  }

  void add_reconstruct() {
    CLI::App& reconstruct =
        add("reconstruct", cli::reconstruct, "Make surfaces of points",
            "The points are the vertices of the input, whose faces do not count; its normals\n"
            "of vertices, if it has any, say which side is outside. The surface grows over\n"
            "the points triangle by triangle and is always an oriented manifold. It needs no\n"
            "option; with --radius it goes where balls of these radii rest on three points,\n"
            "and leaves gaps open that they fall through. A radius somewhat larger than the\n"
            "distance of neighbours is a good first one.\n\n"
            "Examples:\n"
            "  clers reconstruct scan.ply -o mesh.ply\n"
            "  clers reconstruct scan.ply -o mesh.ply --radius 0.5,1,2\n"
            "  clers reconstruct scan.obj -o mesh.obj --radius 0.2% --radius 1%");
    inputs(reconstruct, "points, or meshes: ply, obj, off, stl");
    output(reconstruct, "the mesh file, or a directory for several");
    reconstruct
        .add_option(
            "--radius",
            [this](const CLI::results_t& values) {
              for (const std::string& value : values)
                for (std::size_t at = 0; at <= value.size();) {
                  const std::size_t comma = std::min(value.find(',', at), value.size());
                  options_.reconstruction.radii.push_back(
                      parse_extent("--radius", value.substr(at, comma - at)));
                  at = comma + 1;
                }
              return true;
            },
            "of a ball that rolls over the points, in the units of the file, or with % of the "
            "diagonal of their bounding box. Several, small to large: each goes on where the one "
            "before is stuck")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->option_text("R,...");
    json(reconstruct);
    formats(reconstruct);
  }

  /// What all commands have that make meshes of meshes.
  void formats(CLI::App& sub) {
    from(sub);
    to(sub, "format of the output; default: by its name, else that of the input");
    text(sub);
    force(sub);
    quiet(sub);
  }

  CLI::App& add(const char* name, Command command, const char* what, const std::string& footer) {
    CLI::App* sub = app_.add_subcommand(name, what)->group("Commands");
    sub->footer(footer);
    sub->callback([this, command] { command_ = command; });
    return *sub;
  }

  // ---- Options

  void inputs(CLI::App& sub, const char* what) {
    sub.add_option("FILE", many_, what)
        ->required()
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->option_text("...");
  }
  void output(CLI::App& sub, const char* what) {
    CLI::Option* to = sub.add_option("-o,--output", options_.output, what)->option_text("OUT");
    sub.add_flag_callback(
           "-c,--stdout", [this] { options_.output = "-"; }, "write to standard output")
        ->excludes(to);
  }
  void from(CLI::App& sub) {
    format(sub, "--from", options_.from, "format of the input; default: by its name")
        .option_text("ply|obj|off|stl|glb|gltf|drc");
  }
  void to(CLI::App& sub, const char* what) {
    format(sub, "--to", options_.to, what).option_text("ply|obj|off|stl|glb|gltf");
  }
  CLI::Option& format(CLI::App& sub, const char* name, std::optional<Format>& target,
                      const char* what) {
    const bool written = &target == &options_.to;
    return *sub.add_option(
        name,
        [&target, name, written](const CLI::results_t& values) {
          target = format_of(values.back());
          if (!target || (written && is_read_only(*target)))
            refuse(name, written ? written_names : read_names, values.back());
          return true;
        },
        what);
  }
  void text(CLI::App& sub) {
    sub.add_flag("--text", options_.text, "text instead of binary, for ply and stl");
  }
  void policy(CLI::App& sub, const char* name, DefectPolicy& target, const char* what) {
    choice(sub, name, target, {{"keep", DefectPolicy::keep}, {"reject", DefectPolicy::reject}},
           what)
        .option_text("keep|reject");
  }
  void force(CLI::App& sub) {
    sub.add_flag("-f,--force", options_.force, "overwrite the output; write to a terminal");
  }
  void quiet(CLI::App& sub) {
    sub.add_flag("-q,--quiet", options_.quiet, "errors only: no result, notes or progress");
  }
  void json(CLI::App& sub) { sub.add_flag("--json", options_.json, "JSON, for programs"); }
  void keep_or_remove(CLI::App& sub) {
    CLI::Option* remove =
        sub.add_flag("--rm", options_.remove_inputs,
                     "remove an input once its output is written, if nothing is lost");
    sub.add_flag_callback(
           "-k,--keep", [this] { options_.remove_inputs = false; }, "keep the inputs (default)")
        ->excludes(remove);
  }
  void threads(CLI::App& sub) {
    options_.encode.threads = options_.decode.threads = 0;
    sub.add_option(
           "-T,--threads",
           [this](const CLI::results_t& values) {
             unsigned n = 0;
             if (!parse(values.back(), n) || n > 1024)
               refuse("--threads", "a number from 0 to 1024", values.back());
             options_.encode.threads = options_.decode.threads = n;
             return true;
           },
           "that work at the same time; 0, the default, is all cores. They make no difference to "
           "the result")
        ->option_text("N");
  }
  void limits(CLI::App& sub) {
    Limits& limits = options_.decode.limits;
    sub.add_option(
           "--max-memory",
           [&limits](const CLI::results_t& values) {
             if (!parse_size(values.back(), limits.memory.emplace()))
               refuse("--max-memory", "a size such as 64M or 2G", values.back());
             return true;
           },
           "most memory that decoding may use; default: 1G or 4096 times the file, whichever is "
           "more")
        ->option_text("SIZE");
    constexpr std::uint64_t most = ~std::uint64_t{0};
    number(sub, "--max-vertices", limits.vertices, std::uint64_t{0}, most,
           "most that a mesh may have");
    number(sub, "--max-faces", limits.faces, std::uint64_t{0}, most, "most that a mesh may have");
    number(sub, "--max-meshes", limits.meshes, std::uint64_t{0}, most, "that a file may have");
  }

  // ---- Values

  [[noreturn]] static void refuse(const char* option, const std::string& expected,
                                  const std::string& found) {
    throw CLI::ValidationError(option,
                               fmt::format("expected {}, found {}", expected, in_quotes(found)));
  }

  template <class T>
  CLI::Option& choice(CLI::App& sub, const char* name, T& target,
                      std::vector<std::pair<std::string, T>> values, const char* what) {
    return *sub.add_option(
        name,
        [&target, name, values = std::move(values)](const CLI::results_t& given) {
          std::vector<std::string> words;
          for (const auto& value : values) {
            words.push_back(value.first);
            if (value.first != given.back()) continue;
            target = value.second;
            return true;
          }
          refuse(name, list(words, "or"), given.back());
        },
        what);
  }

  template <class T>
  CLI::Option& number(CLI::App& sub, const char* name, T& target, T least, T most,
                      const char* what) {
    return *sub.add_option(
                   name,
                   [&target, name, least, most](const CLI::results_t& given) {
                     if (parse(given.back(), target) && target >= least && target <= most)
                       return true;
                     refuse(name,
                            most == ~T{0} ? "a whole number"
                                          : fmt::format("a number from {} to {}", least, most),
                            given.back());
                   },
                   what)
                ->option_text("N");
  }

  /// What is no length throws.
  static Brush parse_ball(const std::string& text) {
    std::array<double, 4> numbers{};
    std::string_view rest = text;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t comma = i < 3 ? std::min(rest.find(','), rest.size()) : rest.size();
      if (!parse(rest.substr(0, comma), numbers[i]) || !(std::abs(numbers[i]) < 1e100))
        refuse("--near", "four numbers x,y,z,r", text);
      rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    if (!(numbers[3] > 0)) refuse("--near", "a radius above 0", text);
    return {{numbers[0], numbers[1], numbers[2]}, numbers[3]};
  }

  /// "5000" or "10%".
  static FaceCount parse_faces(std::string_view text) {
    FaceCount faces;
    const bool share = text.ends_with('%');
    if (share ? !parse(text.substr(0, text.size() - 1), faces.share.emplace()) ||
                    !(*faces.share >= 0 && *faces.share <= 100)
              : !parse(text, faces.count) || faces.count < 0)
      refuse("--faces", "a number of faces, or a share from 0% to 100%", std::string(text));
    if (share) *faces.share /= 100;
    return faces;
  }

  /// "0.5" or "0.1%"; above 0, or 0 too.
  static Extent parse_extent(const char* option, const std::string& given, bool zero = false) {
    std::string_view text = given;
    Extent extent;
    extent.of_diagonal = text.ends_with('%');
    if (extent.of_diagonal) text.remove_suffix(1);
    if (!parse(text, extent.value) || !(extent.value < 1e100) ||
        !(extent.value > 0 || (zero && extent.value == 0)))
      refuse(option,
             zero ? "a length such as 0.5 or 0.1%" : "a length above 0, such as 0.5 or 0.1%",
             given);
    if (extent.of_diagonal) extent.value /= 100;
    return extent;
  }

  void extent(CLI::App& sub, const char* name, std::optional<Extent>& target, const char* what,
              bool zero = false) {
    sub.add_option(
           name,
           [&target, name, zero](const CLI::results_t& values) {
             target = parse_extent(name, values.back(), zero);
             return true;
           },
           what)
        ->option_text("LENGTH");
  }

  static bool parse_pieces(const std::string& text, std::optional<std::uint32_t>& faces) {
    if (text == "never")
      faces = never_in_pieces;
    else if (!parse(text, faces.emplace()) || faces == 0)
      refuse("--pieces", "a number of faces or never", text);
    return true;
  }

  void add_precision(const char* option, const std::string& name, const std::string& text) {
    const auto precision = parse_precision(text);
    const bool directions = precision && (precision->kind == Precision::Kind::directions ||
                                          precision->kind == Precision::Kind::recomputed);
    if (!precision || (directions && name == position_name))
      refuse(option, name == position_name ? precision_words : attribute_precision_words, text);
    for (const AttributePrecision& other : options_.encode.precisions)
      if (other.name == name)
        throw CLI::ValidationError(option, fmt::format("{} is given twice", in_quotes(name)));
    options_.encode.precisions.push_back({name, *precision, {}});
    options_.encode.precisions.back().precision.or_directions =
        precision->kind == Precision::Kind::bits && name != position_name;
  }

  // ---- What is wrong

  std::vector<std::string> command_names() const {
    std::vector<std::string> names;
    for (const CLI::App* sub : app_.get_subcommands([](const CLI::App*) { return true; }))
      names.push_back(sub->get_name());
    return names;
  }

  std::string unknown_command(const std::string& word) const {
    const std::string what = "unknown command " + in_quotes(word);
    if (format_of(word) && word.find('.') != std::string::npos)
      return fmt::format("a command is needed, such as: clers encode {}", printable(word));
    if (word.ends_with(".clers"))
      return fmt::format("a command is needed, such as: clers decode {}", printable(word));
    const auto other = other_names.find(word);
    const auto meant =
        other != other_names.end() ? std::optional(other->second) : closest(word, command_names());
    return meant ? fmt::format("{}; did you mean {}?", what, *meant)
                 : fmt::format("{}; expected {}", what, list(command_names(), "or"));
  }

  /// CLI11 takes -19 as -1 -9, and gives no warning.
  static std::optional<std::string> level_of_two_digits(std::span<char* const> words) {
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::string_view word = words[i];
      const bool digits =
          word.size() > 2 && word[0] == '-' && word.find_first_not_of("0123456789", 1) == word.npos;
      const bool is_value = std::string_view(words[i - 1]).starts_with("--");
      if (digits && !is_value)
        return "unknown option " + in_quotes(std::string(word)) + "; levels are -1 to -9";
    }
    return std::nullopt;
  }

  static std::string unknown_option(const CLI::App& app, std::string word) {
    word = word.substr(0, word.find('='));
    std::vector<std::string> known;
    for (const CLI::Option* option : app.get_options())
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    const auto meant = word.starts_with("--") ? closest(word, known) : std::nullopt;
    return "unknown option " + in_quotes(word) +
           (meant ? fmt::format("; did you mean {}?", *meant) : "");
  }

  /// The first argument that nothing knows.
  std::optional<std::string> unknown_argument() const {
    const auto commands = app_.get_subcommands();
    if (const auto words = app_.remaining(); !words.empty())
      return words[0].starts_with('-')
                 ? unknown_option(app_, words[0]) + "; options follow a command, such as encode"
                 : unknown_command(words[0]);
    if (commands.empty()) return std::nullopt;
    const CLI::App& sub = *commands.front();
    // The parser takes what looks like a negative number for a file.
    for (const CLI::Option* option : sub.get_options())
      if (option->get_positional() && !dashes_)
        for (const std::string& file : option->results())
          if (file.size() > 1 && file[0] == '-') return unknown_option(sub, file);
    if (const auto words = sub.remaining(); !words.empty())
      return words[0].starts_with('-') ? unknown_option(sub, words[0])
                                       : in_quotes(words[0]) + " is one argument too many";
    return std::nullopt;
  }

  /// Inputs that look like something else.
  std::optional<std::string> mistaken_input() const {
    if (options_.inputs.size() == 2) {
      const std::string &first = options_.inputs[0], &last = options_.inputs[1];
      const auto is_mesh = [](const std::string& name) {
        return name.find('.') != std::string::npos && format_of(name);
      };
      const bool swapped = first.ends_with(".clers") && is_mesh(last);
      if (command_ == &cli::verify && swapped)
        return fmt::format("the original comes first; did you mean clers verify {} {}?",
                           printable(last), printable(first));
      const bool output =
          (command_ == &cli::encode && is_mesh(first) && last.ends_with(".clers")) ||
          (command_ == &cli::decode && swapped);
      if (output && !options_.output)
        return fmt::format("{} is no input; did you mean -o {}?", printable(last), printable(last));
    }
    if (command_ == static_cast<Command>(&cli::adapt))
      if (const auto wrong = mistaken_adaptation()) return wrong;
    if (options_.json && options_.output == "-")
      return "--json and the mesh cannot both go to standard output";
    if (options_.piece && options_.remove_inputs)
      return "--rm and --piece: a piece is not all of its file";
    return std::nullopt;
  }

  std::optional<std::string> mistaken_adaptation() const {
    const Adaptation& how = options_.adaptation;
    if (!how.near.empty() && !how.level) return "--near needs --level";
    if (!how.level && !how.edge_length && !how.error)
      return "--level, --edge-length or --error is required";
    if (options_.frames && options_.inputs.size() > 1) return "--frames needs a single input";
    return std::nullopt;
  }

  Exit usage(const std::string& what) const {
    const auto commands = app_.get_subcommands();
    const std::string of = commands.empty() ? "" : commands.front()->get_name() + " ";
    complain(fmt::format("{}{} see clers {}--help", what, what.ends_with('?') ? "" : ";", of));
    return Exit::usage;
  }

  Exit explain() {
    if (topic_.empty()) return say(CommandLine().app_.help());  // of one that parsed no command
    const auto subs =
        app_.get_subcommands([this](const CLI::App* sub) { return sub->get_name() == topic_; });
    return subs.empty() ? usage(unknown_command(topic_)) : say(subs.front()->help("clers"));
  }

  Exit say(const std::string& text) {
    const Outcome<Done> printed = print(text);
    if (printed) return Exit::done;
    complain(printed.error().line);
    return printed.error().exit;
  }

  CLI::App app_{"Compresses meshes without losing a bit of them.", "clers"};
  Options options_;
  std::vector<std::string> many_;
  std::string digit_, original_, one_, topic_;
  bool help_ = false, dashes_ = false;  ///< help is asked for; "--" comes before files
  Command command_ = nullptr;
};

}  // namespace

Exit run(int argc, char** argv) {
  return CommandLine().run(argc, argv);
}

}  // namespace clers::cli

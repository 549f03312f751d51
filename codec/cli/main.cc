// The command line of clers. The only file that knows the argument parser.
#include <fmt/format.h>
#include <signal.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <map>
#include <thread>

#include "codec/cli/commands.h"
#include "codec/cli/files.h"
#include "codec/version.h"

namespace clers::cli {
namespace {

constexpr char exit_codes[] =
    "Exit status: 0 done; 1 verify found a difference; 2 usage; 3 an input cannot be read\n"
    "or is not accepted; 4 a limit was hit; 5 writing failed; 6 verify could not decide.";

/// A number of bytes, plain or with K, M, G or T (powers of 1024).
bool parse_size(const std::string& text, std::uint64_t& size) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  const std::size_t power = unit.empty() ? 0 : std::string_view("KMGT").find(unit[0]) + 1;
  if (error != std::errc() || unit.size() > 1 || (!unit.empty() && power == 0) || power > 4 ||
      size > ~std::uint64_t{0} >> (10 * power))
    return false;
  size <<= 10 * power;
  return true;
}

/// A number of faces, 0 for the default rule, or "never".
bool parse_pieces(const std::string& text, std::uint32_t& faces) {
  if (text == "never") {
    faces = never_in_pieces;
    return true;
  }
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), faces);
  return error == std::errc() && end == text.data() + text.size();
}

class CommandLine {
 public:
  CommandLine() {
    app_.require_subcommand(0, 1);  // none: run() says so better
    app_.set_version_flag("--version", std::string("clers ") + version);
    app_.footer(std::string("Examples:\n"
                            "  clers encode bunny.ply -o bunny.clers\n"
                            "  clers decode bunny.clers -o bunny.obj\n"
                            "  clers verify bunny.ply bunny.clers\n"
                            "  clers encode scans/*.ply -o packed/\n"
                            "`clers COMMAND --help` has more. ") +
                "A file `-` is standard input or output.\n\n" + exit_codes);

    CLI::App& encode =
        add("encode", cli::encode, "Compress mesh files",
            "Examples:\n"
            "  clers encode bunny.ply -o bunny.clers\n"
            "  clers encode --level 9 a.obj b.off c.stl -o packed/\n"
            "  curl -s https://example.org/m.ply | clers encode --from ply - -o m.clers");
    inputs(encode, "IN", "mesh files: ply, obj, off, stl");
    output(encode, "the .clers file, or a directory for several");
    from(encode);
    encode.add_option("--level", options_.encode.level, "1 is fastest, 9 is smallest")
        ->check(CLI::Range(min_level, max_level))
        ->option_text("1..9 (default 5)");
    encode
        .add_option("--order", options_.encode.order,
                    "whether the order of vertices and faces comes back too")
        ->transform(CLI::Transformer(
            std::map<std::string, Order>{{"free", Order::free}, {"keep", Order::keep}}))
        ->option_text("free|keep (default free)");
    encode
        .add_option(
            "--pieces",
            [this](const std::vector<std::string>& values) {
              return parse_pieces(values.back(), options_.encode.piece_faces);
            },
            "code meshes of more faces in pieces of about so many, which decode alone")
        ->type_name("N|never")
        ->option_text(fmt::format("N|never (default {}, for meshes of more than {})",
                                  default_piece_faces, most_faces_whole));
    threads(encode);
    oddity(encode, "--on-nonmanifold", options_.encode.on_nonmanifold,
           "edges of more than two faces, vertices of several fans, one-sided surfaces");
    oddity(encode, "--on-degenerate", options_.encode.on_degenerate,
           "faces that use a vertex twice, or have fewer than three corners");
    oddity(encode, "--on-duplicate", options_.encode.on_duplicate,
           "faces on the same vertices as another");
    force(encode);
    quiet(encode);

    CLI::App& decode = add("decode", cli::decode, "Restore mesh files",
                           "Examples:\n"
                           "  clers decode bunny.clers -o bunny.ply\n"
                           "  clers decode packed/*.clers --to obj -o restored/\n"
                           "  clers decode bunny.clers --to off -o - | head");
    inputs(decode, "IN", ".clers files");
    output(decode, "the mesh file, or a directory for several");
    format(decode, "--to", options_.to, "format of the output; default: by its name");
    decode.add_flag("--text", options_.text, "text instead of binary, for ply and stl");
    decode
        .add_option("--piece", options_.piece,
                    "only this piece of all meshes', from 0; clers info says how many there are")
        ->type_name("K");
    threads(decode);
    force(decode);
    limits(decode);
    quiet(decode);

    CLI::App& info = add("info", cli::info, "Describe a .clers file: its meshes and their cost",
                         "Examples:\n"
                         "  clers info bunny.clers\n"
                         "  clers info --json bunny.clers | jq .connectivity_bits_per_triangle");
    one_input(info, "IN", "a .clers file");
    json(info);

    CLI::App& verify =
        add("verify", cli::verify, "Decode a file and compare it with its original",
            "Faces and vertices may be in another order; all else must be equal bit\n"
            "for bit. Exit status 1 when it is not, 6 when neither could be shown.\n"
            "Examples:\n"
            "  clers verify bunny.ply bunny.clers");
    verify.add_option("ORIGINAL", original_, "the mesh file that was encoded")
        ->required()
        ->type_name("FILE");
    one_input(verify, "IN", "the .clers file");
    from(verify);
    threads(verify);
    limits(verify);
    quiet(verify);

    CLI::App& check = add("check", cli::check, "Measure a mesh file: its shape and its defects",
                          "Examples:\n"
                          "  clers check bunny.ply\n"
                          "  clers check --json bunny.ply | jq .genus");
    one_input(check, "IN", "a mesh file: ply, obj, off, stl");
    from(check);
    json(check);
    quiet(check);

    CLI::App& subdivide =
        add("subdivide", cli::subdivide, "Subdivide mesh files towards a smooth surface",
            "loop makes 4 triangles of one, sqrt3 makes 3; 4-8 first pairs triangles and halves\n"
            "them, and then makes 2 of one. The number of components, boundary curves and handles\n"
            "stays. Polygons and non-manifold meshes are refused.\n"
            "Examples:\n"
            "  clers subdivide bunny.ply -o smooth.ply --scheme loop\n"
            "  clers subdivide bunny.ply -o finer.obj --scheme sqrt3 --times 2\n"
            "  clers subdivide a.obj b.off --scheme 4-8 --times 4 --to ply -o finer/");
    inputs(subdivide, "IN", "mesh files: ply, obj, off, stl");
    output(subdivide, "the mesh file, or a directory for several");
    subdivide.add_option("--scheme", options_.subdivision.scheme, "how")
        ->transform(CLI::Transformer(std::map<std::string, Scheme>{
            {"sqrt3", Scheme::sqrt3}, {"loop", Scheme::loop}, {"4-8", Scheme::four_eight}}))
        ->required()
        ->option_text("sqrt3|loop|4-8 REQUIRED");
    subdivide.add_option("--times", options_.subdivision.times, "how many steps")
        ->check(CLI::Range(1u, 30u))
        ->option_text("1..30 (default 1)");
    from(subdivide);
    format(subdivide, "--to", options_.to, "format of the output; default: by its name");
    subdivide.add_flag("--text", options_.text, "text instead of binary, for ply and stl");
    force(subdivide);
    quiet(subdivide);
  }

  Exit run(int argc, char** argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::CallForVersion& asked) {
      return say(std::string(asked.what()) + "\n");
    } catch (const CLI::Success&) {  // --help, of the program or of a command
      return say(app_.help());
    } catch (const CLI::ParseError& error) {
      const auto commands = app_.get_subcommands();
      complain(std::string(error.what()) + "; see clers " +
               (commands.empty() ? "" : commands.front()->get_name() + " ") + "--help");
      return Exit::usage;
    }
    if (command_ == nullptr) {
      complain(
          "a command is needed: encode, decode, info, verify, check or subdivide; see clers "
          "--help");
      return Exit::usage;
    }
    options_.inputs = many_;
    if (!original_.empty()) options_.inputs.push_back(original_);
    if (!one_.empty()) options_.inputs.push_back(one_);
    return command_(options_);
  }

 private:
  using Command = Exit (*)(const Options&);

  CLI::App& add(const char* name, Command command, const char* what, const char* examples) {
    CLI::App* sub = app_.add_subcommand(name, what);
    sub->footer(examples);
    sub->callback([this, command] { command_ = command; });
    return *sub;
  }
  void inputs(CLI::App& sub, const char* name, const char* what) {
    sub.add_option(name, many_, what)->required()->type_name("FILE");
  }
  void one_input(CLI::App& sub, const char* name, const char* what) {
    sub.add_option(name, one_, what)->required()->type_name("FILE");
  }
  void output(CLI::App& sub, const char* what) {
    sub.add_option("-o,--output", options_.output, what)->required()->type_name("FILE");
  }
  void from(CLI::App& sub) {
    format(sub, "--from", options_.from, "format of the input; default: by its name");
  }
  void format(CLI::App& sub, const char* name, std::optional<io::Format>& target,
              const char* what) {
    sub.add_option(
           name,
           [&target](const std::vector<std::string>& values) {
             target = io::format_of(values.back());
             return target.has_value();
           },
           what)
        ->type_name("ply|obj|off|stl");
  }
  void oddity(CLI::App& sub, const char* name, OnOddity& target, const char* what) {
    sub.add_option(name, target, what)
        ->transform(CLI::Transformer(
            std::map<std::string, OnOddity>{{"keep", OnOddity::keep}, {"error", OnOddity::error}}))
        ->option_text("keep|error (default keep)");
  }
  void force(CLI::App& sub) { sub.add_flag("-f,--force", options_.force, "overwrite the output"); }
  void quiet(CLI::App& sub) {
    sub.add_flag("-q,--quiet", options_.quiet, "no notes, no progress; errors only");
  }
  void json(CLI::App& sub) { sub.add_flag("--json", options_.json, "JSON, for programs"); }
  void threads(CLI::App& sub) {
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    options_.encode.threads = options_.decode.threads = cores;
    sub.add_option_function<unsigned>(
           "--threads",
           [this](unsigned n) { options_.encode.threads = options_.decode.threads = n; },
           "that work at the same time; they make no difference to the result")
        ->check(CLI::Range(1, 1024))
        ->option_text(fmt::format("N (default {}, the cores there are)", cores));
  }
  void limits(CLI::App& sub) {
    sub.add_option(
           "--max-memory",
           [this](const std::vector<std::string>& values) {
             return parse_size(values.back(), options_.decode.limits.memory.emplace());
           },
           "what the decoded meshes may take")
        ->type_name("SIZE");
    sub.add_option("--max-vertices", options_.decode.limits.vertices, "that a mesh may have");
    sub.add_option("--max-faces", options_.decode.limits.faces, "that a mesh may have");
    sub.add_option("--max-meshes", options_.decode.limits.meshes, "that a file may have");
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
  std::string original_, one_;
  Command command_ = nullptr;
};

}  // namespace
}  // namespace clers::cli

int main(int argc, char** argv) {
  ::signal(SIGPIPE, SIG_IGN);  // a reader that leaves is a failed write, not a silent death
  return static_cast<int>(clers::cli::CommandLine().run(argc, argv));
}

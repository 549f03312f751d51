#include "codec/cli/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <new>

#include "codec/cli/files.h"
#include "codec/cli/progress.h"
#include "codec/cli/report.h"
#include "codec/compare.h"

namespace clers::cli {
namespace {

namespace fs = std::filesystem;

const char* extension(io::Format format) {
  switch (format) {
    case io::Format::ply: return ".ply";
    case io::Format::obj: return ".obj";
    case io::Format::off: return ".off";
    case io::Format::stl: return ".stl";
  }
  return "";
}

Outcome<io::Format> format_for(const std::string& path, std::optional<io::Format> given,
                               const char* option) {
  if (given) return *given;
  if (path != "-")
    if (const auto format = io::format_of(fs::path(path).extension().string())) return *format;
  return stop(Exit::usage, fmt::format("{}: its name does not tell its format; {} ply, obj, off or "
                                       "stl does",
                                       path == "-" ? "-" : path, option));
}

void note(const Options& options, const std::string& file, const io::Notes& notes) {
  if (options.quiet) return;
  for (const io::Note& note : notes) fmt::print(stderr, "clers: {}: note: {}\n", file, note.text);
}

Outcome<std::vector<Mesh>> read_meshes(const Options& options, const std::string& path,
                                       Progress& progress) {
  const Outcome<io::Format> format = format_for(path, options.from, "--from");
  if (!format) return Failure{format.error()};
  progress.show("reading", 0);
  const Outcome<Bytes> bytes = read_file(path);
  if (!bytes) return Failure{bytes.error()};
  progress.show("reading", 0.5);
  Expected<io::ReadResult> read = io::read(*bytes, *format);
  if (!read) return stop(input_name(path), read.error());
  progress.clear();
  note(options, input_name(path), read->notes);
  return std::move(read->meshes);
}

Outcome<std::vector<Mesh>> read_clers(const Options& options, const std::string& path,
                                      Progress& progress) {
  progress.show("reading", 0);
  const Outcome<Bytes> bytes = read_file(path);
  if (!bytes) return Failure{bytes.error()};
  DecodeOptions how = options.decode;
  how.progress = progress.callback();
  if (options.piece) {
    Expected<Piece> piece = clers::decode_piece(*bytes, *options.piece, how);
    if (!piece)
      return piece.error().code == ErrorCode::bad_option
                 ? stop(Exit::usage, input_name(path) + ": " + piece.error().what)
                 : stop(input_name(path), piece.error());
    std::vector<Mesh> one;
    one.push_back(std::move(piece->mesh));
    return one;
  }
  Expected<std::vector<Mesh>> meshes = clers::decode(*bytes, how);
  if (!meshes) return stop(input_name(path), meshes.error());
  return std::move(*meshes);
}

/// Runs one piece of work and prints why it stops, running out of memory included.
template <class Work>
Exit attempt(const std::string& file, Work work) {
  Stop why{Exit::limit, input_name(file) + ": not enough memory"};
  try {
    const Outcome<Exit> outcome = work();
    if (outcome) return *outcome;
    why = outcome.error();
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {  // a container asked for more than there can be
  }
  complain(why.line);
  return why.exit;
}

/// Where each input goes. Several go into a directory, which is made if it is missing.
Outcome<std::vector<std::string>> outputs_for(const Options& options, const char* suffix) {
  const auto& inputs = options.inputs;
  const bool into_directory = options.output.ends_with('/') || fs::is_directory(options.output);
  if (!into_directory) {
    if (inputs.size() > 1)
      return stop(Exit::usage, "several inputs need a directory: -o " + options.output + "/");
    return std::vector{options.output};
  }
  if (suffix == nullptr)
    return stop(Exit::usage, "output into a directory needs --to ply, obj, off or stl");
  std::vector<std::string> outputs;
  std::map<std::string, std::string> taken;
  for (const std::string& input : inputs) {
    if (input == "-") return stop(Exit::usage, "standard input has no name to give to an output");
    fs::path name = fs::path(input).filename();
    name.replace_extension(suffix);
    const std::string output = (fs::path(options.output) / name).string();
    const auto [other, is_new] = taken.emplace(output, input);
    if (!is_new)
      return stop(Exit::usage,
                  fmt::format("{} and {} would both become {}", other->second, input, output));
    outputs.push_back(output);
  }
  std::error_code error;
  fs::create_directories(options.output, error);
  if (error) return stop(Exit::output, options.output + ": " + error.message());
  return outputs;
}

/// Runs encode or decode on every input. One that fails does not keep the others from being done;
/// the first failure decides the status.
template <class Work>
Exit for_each_input(const Options& options, const char* suffix, Work work) {
  const Outcome<std::vector<std::string>> outputs = outputs_for(options, suffix);
  if (!outputs) {
    complain(outputs.error().line);
    return outputs.error().exit;
  }
  Exit all = Exit::done;
  for (std::size_t i = 0; i < options.inputs.size(); ++i) {
    const std::string &input = options.inputs[i], &output = (*outputs)[i];
    const Exit one = attempt(input, [&]() -> Outcome<Exit> {
      if (const auto checked = check_output(output, options.force); !checked)
        return Failure{checked.error()};
      Progress progress(input_name(input), !options.quiet);
      return work(input, output, progress);
    });
    if (all == Exit::done) all = one;
  }
  return all;
}

Outcome<Exit> exit_after(const Outcome<Done>& written) {
  if (!written) return Failure{written.error()};
  return Exit::done;
}

/// Equal as arrays: no vertex, face or first corner is another.
bool in_one_order(const Mesh& a, const Mesh& b) {
  return a.corners == b.corners && a.face_sizes == b.face_sizes &&
         std::equal(a.attributes.begin(), a.attributes.end(), b.attributes.begin(),
                    b.attributes.end(), [](const Attribute& x, const Attribute& y) {
                      return x.name == y.name && x.data == y.data;
                    });
}

}  // namespace

void complain(const std::string& line) {
  fmt::print(stderr, "clers: {}\n", line);
}

Exit encode(const Options& options) {
  return for_each_input(options, ".clers",
                        [&](const std::string& input, const std::string& output,
                            Progress& progress) -> Outcome<Exit> {
                          const auto meshes = read_meshes(options, input, progress);
                          if (!meshes) return Failure{meshes.error()};
                          EncodeOptions how = options.encode;
                          how.progress = progress.callback();
                          const auto encoded = clers::encode(*meshes, how);
                          if (!encoded) return stop(input_name(input), encoded.error());
                          return exit_after(write_file(output, encoded->bytes, options.force));
                        });
}

Exit decode(const Options& options) {
  return for_each_input(options, options.to ? extension(*options.to) : nullptr,
                        [&](const std::string& input, const std::string& output,
                            Progress& progress) -> Outcome<Exit> {
                          const auto format = format_for(output, options.to, "--to");
                          if (!format) return Failure{format.error()};
                          const auto meshes = read_clers(options, input, progress);
                          if (!meshes) return Failure{meshes.error()};
                          progress.show("writing", 1);
                          const auto encoding =
                              options.text ? std::optional(io::Encoding::text) : std::nullopt;
                          const auto written = io::write(*meshes, *format, encoding);
                          if (!written) return stop(input_name(input), written.error());
                          progress.clear();
                          note(options, output, written->notes);
                          return exit_after(write_file(output, written->bytes, options.force));
                        });
}

Exit info(const Options& options) {
  const std::string& file = options.inputs.front();
  return attempt(file, [&]() -> Outcome<Exit> {
    const auto bytes = read_file(file);
    if (!bytes) return Failure{bytes.error()};
    const auto described = inspect(*bytes);
    if (!described) {
      if (described.error().code == ErrorCode::not_clers && format_for(file, {}, ""))
        return stop(Exit::input, file + ": is no .clers file; `clers check` measures mesh files");
      return stop(input_name(file), described.error());
    }
    return exit_after(print(options.json ? info_json(input_name(file), *described)
                                         : info_text(input_name(file), *described)));
  });
}

Exit verify(const Options& options) {
  const std::string &original = options.inputs[0], &file = options.inputs[1];
  return attempt(file, [&]() -> Outcome<Exit> {
    if (original == "-" && file == "-")
      return stop(Exit::usage, "only one of the two files can be standard input");
    Progress progress(input_name(file), !options.quiet);
    const auto expected = read_meshes(options, original, progress);
    if (!expected) return Failure{expected.error()};
    const auto found = read_clers(options, file, progress);
    if (!found) return Failure{found.error()};

    const std::string name = input_name(file);
    if (expected->size() != found->size()) {
      complain(fmt::format("{}: differs: {} meshes, the original has {}", name, found->size(),
                           expected->size()));
      return Exit::different;
    }
    for (std::size_t i = 0; i < found->size(); ++i) {
      progress.show("comparing", static_cast<double>(i) / static_cast<double>(found->size()));
      const auto result = compare((*expected)[i], (*found)[i]);
      if (!result) return stop(name, result.error());
      if (result->verdict == Verdict::same) continue;
      progress.clear();
      const bool differs = result->verdict == Verdict::different;
      complain(fmt::format("{}: {}: {}{}", name,
                           differs ? "differs" : "neither equal nor different could be shown",
                           found->size() > 1 ? fmt::format("mesh {}: ", i) : "", result->what));
      return differs ? Exit::different : Exit::undecided;
    }
    progress.clear();
    if (options.quiet) return Exit::done;
    std::size_t faces = 0;
    for (const Mesh& mesh : *found) faces += mesh.face_count();
    return exit_after(print(
        fmt::format("{}: same as {}: {} mesh{}, {} faces, every value bit for bit{}\n", name,
                    input_name(original), found->size(), found->size() == 1 ? "" : "es", faces,
                    std::equal(found->begin(), found->end(), expected->begin(), in_one_order)
                        ? ", in the same order"
                        : "")));
  });
}

Exit check(const Options& options) {
  const std::string& file = options.inputs.front();
  return attempt(file, [&]() -> Outcome<Exit> {
    Progress progress(input_name(file), !options.quiet);
    const auto meshes = read_meshes(options, file, progress);
    if (!meshes) return Failure{meshes.error()};
    std::vector<Measured> measured;
    for (const Mesh& mesh : *meshes) {
      const auto shape = measure(mesh);
      if (!shape) return stop(input_name(file), shape.error());
      measured.push_back({mesh.name, *shape});
    }
    progress.clear();
    return exit_after(print(options.json ? check_json(input_name(file), measured)
                                         : check_text(input_name(file), measured)));
  });
}

Exit subdivide(const Options& options) {
  return for_each_input(
      options, options.to ? extension(*options.to) : nullptr,
      [&](const std::string& input, const std::string& output,
          Progress& progress) -> Outcome<Exit> {
        const auto format = format_for(output, options.to, "--to");
        if (!format) return Failure{format.error()};
        auto meshes = read_meshes(options, input, progress);
        if (!meshes) return Failure{meshes.error()};
        std::string report;
        for (Mesh& mesh : *meshes) {
          auto done = subdivide(mesh, options.subdivision,
                                [&](double share) { progress.show("subdividing", share); });
          if (!done) return stop(input_name(input), done.error());
          progress.clear();
          io::Notes notes;
          for (const std::string& line : done->notes)
            notes.push_back({io::Note::Kind::loss, 1, line, line});
          note(options, input_name(input), notes);
          report += fmt::format("{}: {}\n", mesh.name.empty() ? input_name(input) : mesh.name,
                                describe(options.subdivision, *done));
          mesh = std::move(done->mesh);
        }
        progress.show("writing", 1);
        const auto encoding = options.text ? std::optional(io::Encoding::text) : std::nullopt;
        const auto written = io::write(*meshes, *format, encoding);
        if (!written) return stop(input_name(input), written.error());
        progress.clear();
        note(options, output, written->notes);
        const auto saved = write_file(output, written->bytes, options.force);
        if (!saved || options.quiet || output == "-") return exit_after(saved);
        return exit_after(print(report));
      });
}

}  // namespace clers::cli

// One input on its way through a command.
#include "codec/cli/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "codec/cli/printable.h"
#include "codec/cli/report.h"
#include "codec/cli/words.h"
#include "codec/decoder.h"

namespace clers::cli {
namespace {

void put_line(const std::string& line) {
  fmt::print(stderr, "{}\n", printable(line));
}

}  // namespace

void complain(const std::string& line) {
  if (!line.empty()) put_line("clers: " + line);
}

Outcome<Format> format_for(const std::string& path, std::optional<Format> given,
                           const char* option) {
  if (given) return *given;
  if (const auto format = format_of_path(path)) return *format;
  const char* names = std::string_view(option) == "--to" ? written_names : read_names;
  return stop(
      Exit::usage,
      path == "-"
          ? fmt::format("standard input: has no name to tell its format; {} {} does", option, names)
          : fmt::format("{}: its name tells no format; {} {} does", path, option, names));
}

Losses losses(const io::Notes& notes) {
  std::vector<std::string> lost;
  std::uint64_t count = 0;
  for (const io::Note& note : notes)
    if (note.kind == io::Note::Kind::loss) {
      lost.push_back(note.what);
      count += note.count;
    }
  return {list(lost, "and"), count == 1 ? "is" : "are"};
}

Outcome<Bytes> Job::read(const std::string& path) {
  progress_.next();
  auto bytes = read_file(path);
  if (bytes) bytes_read_ += bytes->size();
  return bytes;
}

Outcome<Format> Job::mesh_format(const std::string& path) const {
  std::error_code error;  // of a path that cannot be looked at, which reading it reports
  if (std::filesystem::is_directory(path, error))
    return stop(Exit::input, path + ": is a directory; name the files in it");
  const auto format = format_for(path, options_.from, "--from");
  if (!format && path != "-")
    if (const auto kind = io::foreign_kind(path))
      return stop(Exit::input, fmt::format("{}: this is {}", path, *kind));
  return format;
}

Outcome<SceneFile> Job::read_scene(const std::string& path) {
  const auto format = mesh_format(path);
  if (!format) return Failure{format.error()};
  const Outcome<Bytes> bytes = read(path);
  if (!bytes) return Failure{bytes.error()};
  progress_.next();
  return parse_scene(path, *bytes, *format);
}

Outcome<Scene> Job::decode(std::span<const std::byte> bytes) {
  progress_.next();
  DecodeOptions how = options_.decode;
  how.progress = progress_.callback();
  if (!options_.piece) {
    Expected<Scene> scene = clers::decode_scene(bytes, how);
    if (!scene) return not_accepted(scene.error());
    return std::move(*scene);
  }
  const Expected<Decoder> file = Decoder::open(bytes, how);
  if (!file) return not_accepted(file.error());
  Expected<Piece> piece = file->decode_piece(*options_.piece);
  if (!piece)
    return piece.error().code == ErrorCode::bad_option
               ? stop(Exit::usage,
                      fmt::format("{}: {}, counted from 0", name(), piece.error().what))
               : not_accepted(piece.error());
  Scene one;
  one.meshes.push_back(std::move(piece->mesh));
  return one;
}

Failure<Stop> Job::not_accepted(const Error& error) const {
  const bool mesh = format_of_path(input_).has_value();
  if (error.code == ErrorCode::not_clers && mesh)
    return stop(Exit::input, name() +
                                 ": is no .clers file but a mesh file; clers encode compresses "
                                 "it, clers check measures it");
  return stop(name(), error);
}

void Job::note(const std::string& file, const io::Notes& notes) {
  for (const io::Note& one : notes) note(file, one.text, one.kind == io::Note::Kind::loss);
}

void Job::note(const std::string& file, const std::string& text, bool is_loss) {
  whole_ = whole_ && !is_loss;
  if (options_.quiet) return;
  progress_.hide();
  complain(fmt::format("{}: note: {}", file, text));
}

std::string Job::sizes_and_time(const std::string& output, std::size_t size) const {
  const auto [less, more] = std::minmax(bytes_read_, size);
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  return fmt::format(
      "{} -> {}: {} -> {} bytes, {:.2f} times {}, {:.2f} s", name(), output_name(output),
      grouped(bytes_read_), grouped(size),
      static_cast<double>(more) / static_cast<double>(std::max<std::size_t>(1, less)),
      size < bytes_read_ ? "smaller" : "larger", seconds);
}

Outcome<Done> Job::save(const std::string& output, std::span<const std::byte> bytes,
                        const std::vector<std::string>& results) {
  progress_.next();
  if (auto written = write_file(output, bytes, options_.force); !written) return written;
  progress_.hide();
  const bool in_a_pipe = input_ == "-" && output == "-";
  if (!options_.quiet && !in_a_pipe) {
    if (results.empty()) put_line(sizes_and_time(output, bytes.size()));
    for (const std::string& result : results) put_line(result);
  }
  if (!options_.remove_inputs || input_ == "-" || output == "-") return Done{};
  if (whole_) return remove_input(input_);
  if (!options_.quiet) complain(name() + ": note: is kept, since not all of it is in " + output);
  return Done{};
}

}  // namespace clers::cli

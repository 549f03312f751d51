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

Outcome<io::Format> format_for(const std::string& path, std::optional<io::Format> given,
                               const char* option) {
  if (given) return *given;
  const std::size_t dot = path.rfind('.');
  if (dot != std::string::npos)
    if (const auto format = io::format_of(path.substr(dot))) return *format;
  return stop(
      Exit::usage,
      path == "-"
          ? fmt::format("standard input: has no name to tell its format; {} ply, obj, off or "
                        "stl does",
                        option)
          : fmt::format("{}: its name tells no format; {} ply, obj, off or stl does", path,
                        option));
}

const char* extension(io::Format format) {
  switch (format) {
    case io::Format::ply: return ".ply";
    case io::Format::obj: return ".obj";
    case io::Format::off: return ".off";
    case io::Format::stl: return ".stl";
  }
  return "";
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

Outcome<io::Format> Job::mesh_format(const std::string& path) const {
  std::error_code error;  // of a path that cannot be looked at, which reading it reports
  if (std::filesystem::is_directory(path, error))
    return stop(Exit::input, path + ": is a directory; name the files in it");
  const auto format = format_for(path, options_.from, "--from");
  if (!format && path != "-")
    if (const auto kind = io::foreign_kind(path))
      return stop(Exit::input, fmt::format("{}: this is {}", path, *kind));
  return format;
}

Outcome<MeshFile> Job::read_meshes(const std::string& path) {
  const auto format = mesh_format(path);
  if (!format) return Failure{format.error()};
  const Outcome<Bytes> bytes = read(path);
  if (!bytes) return Failure{bytes.error()};
  progress_.next();
  Expected<io::ReadResult> read = io::read(*bytes, *format);
  if (!read) return stop(input_name(path), read.error());
  return MeshFile{std::move(read->meshes), std::move(read->notes)};
}

Outcome<std::vector<Mesh>> Job::decode(std::span<const std::byte> bytes) {
  progress_.next();
  DecodeOptions how = options_.decode;
  how.progress = progress_.callback();
  if (!options_.piece) {
    Expected<std::vector<Mesh>> meshes = clers::decode(bytes, how);
    if (!meshes) return not_accepted(meshes.error());
    return std::move(*meshes);
  }
  const Expected<Decoder> file = Decoder::open(bytes, how);
  if (!file) return not_accepted(file.error());
  Expected<Piece> piece = file->decode_piece(*options_.piece);
  if (!piece)
    return piece.error().code == ErrorCode::bad_option
               ? stop(Exit::usage,
                      fmt::format("{}: {}, counted from 0", name(), piece.error().what))
               : not_accepted(piece.error());
  std::vector<Mesh> one;
  one.push_back(std::move(piece->mesh));
  return one;
}

Failure<Stop> Job::not_accepted(const Error& error) const {
  const bool mesh = input_.find('.') != std::string::npos && io::format_of(input_);
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

#include "codec/cli/frames.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace clers::cli {

Outcome<Done> Frames::open() {
  if (!options_.frames) return Done{};
  std::error_code error;
  std::filesystem::create_directories(*options_.frames, error);
  if (error == std::errc::file_exists) error = std::make_error_code(std::errc::not_a_directory);
  if (error) return stop(Exit::output, *options_.frames + ": " + error.message());
  return Done{};
}

bool Frames::add(const Mesh& mesh) {
  if (auto done = write(mesh); !done) failure_ = done.error();
  return !failure_;
}

Outcome<Done> Frames::write(const Mesh& mesh) {
  const auto name = fmt::format("frame-{:04}{}", ++count_, extension(format_));
  const std::string path = (std::filesystem::path(*options_.frames) / name).string();
  if (auto ok = check_output(path, options_.force, inputs_); !ok) return ok;
  const auto written = io::write({&mesh, 1}, format_, encoding_);
  if (!written) return stop(path, written.error());
  return write_file(path, written->bytes, options_.force);
}

}  // namespace clers::cli

// Where outputs go: beside inputs, to a file, into a folder, to standard output.
#include "codec/cli/destination.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <system_error>

namespace clers::cli {

namespace fs = std::filesystem;

Outcome<Destination> Destination::find(const Options& options, const char* suffix) {
  const auto& inputs = options.inputs;
  const auto& output = options.output;
  std::error_code error;  // what is wrong with an output is reported when it is made
  const bool directory = output && (output->ends_with('/') || fs::is_directory(*output, error));
  if (output && !directory && inputs.size() > 1)
    return stop(Exit::usage, *output == "-"
                                 ? "several inputs cannot go to standard output"
                                 : fmt::format("several inputs need a directory: -o {}/", *output));
  const Destination to(options, directory ? Kind::directory : output ? Kind::given : Kind::beside);
  if (to.kind_ == Kind::given) return to;
  std::map<std::string, std::string> taken;
  for (const std::string& input : inputs) {
    if (input == "-" && directory)
      return stop(Exit::usage, "standard input has no name to give to an output in a directory");
    // Where suffixes are not known yet, names without them must differ.
    const std::string path = to.path(input, suffix == nullptr ? "" : suffix);
    const auto [other, is_new] = taken.emplace(path, input);
    if (!is_new)
      return stop(Exit::usage,
                  fmt::format("{} and {} would both become {}", other->second, input, path));
  }
  if (directory) fs::create_directories(*output, error);
  if (error == std::errc::file_exists) error = std::make_error_code(std::errc::not_a_directory);
  if (directory && error) return stop(Exit::output, *output + ": " + error.message());
  return to;
}

Outcome<std::string> Destination::of(const std::string& input, const char* suffix,
                                     io::Encoding encoding) const {
  std::string output = path(input, suffix);
  if (output == "-" && encoding == io::Encoding::binary && !force_ && ::isatty(STDOUT_FILENO))
    return stop(Exit::usage, "standard output: is a terminal; redirect it, or -f writes to it");
  if (const auto ok = check_output(output, force_, inputs_); !ok) return Failure{ok.error()};
  return output;
}

std::string Destination::path(const std::string& input, const char* suffix) const {
  if (const auto name = given(input)) return *name;
  fs::path path(input);
  path.replace_extension(suffix);
  return kind_ == Kind::directory ? (fs::path(where_) / path.filename()).string() : path.string();
}

std::optional<std::string> Destination::given(const std::string& input) const {
  if (kind_ == Kind::given) return where_;
  if (kind_ == Kind::beside && input == "-") return "-";
  return std::nullopt;
}

}  // namespace clers::cli

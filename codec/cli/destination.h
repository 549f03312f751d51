// Where the output of each input goes.
#ifndef CLERS_CODEC_CLI_DESTINATION_H
#define CLERS_CODEC_CLI_DESTINATION_H

#include <optional>
#include <string>
#include <vector>

#include "codec/cli/outcome.h"

namespace clers::cli {

/// One file or standard output, a directory, or beside each input.
class Destination {
 public:
  /// `output`: what -o says, if anything; a directory if it is one or ends in '/', and then made if
  /// it is missing. Without, standard input goes to standard output and a file beside itself.
  /// `suffix`: of the outputs' names, if it is known. Refuses what would put two outputs at one
  /// place.
  static Outcome<Destination> find(const std::vector<std::string>& inputs,
                                   const std::optional<std::string>& output, const char* suffix);

  /// The output of an input. `suffix`, such as ".ply", is of names that are made.
  std::string path(const std::string& input, const char* suffix) const;

  /// The name that was given for the output, or "-": not one made from the input's.
  std::optional<std::string> given(const std::string& input) const;

 private:
  enum class Kind { given, directory, beside };

  Destination(Kind kind, std::string where) : kind_(kind), where_(std::move(where)) {}

  Kind kind_;
  std::string where_;
};

}  // namespace clers::cli

#endif

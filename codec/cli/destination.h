// Where the output of each input goes.
#ifndef CLERS_CODEC_CLI_DESTINATION_H
#define CLERS_CODEC_CLI_DESTINATION_H

#include <optional>
#include <string>

#include "codec/cli/commands.h"
#include "codec/cli/files.h"
#include "codec/cli/outcome.h"

namespace clers::cli {

/// One file or standard output, a directory, or beside each input.
class Destination {
 public:
  /// What -o says: a directory if it is one or ends in '/', and then made if it is missing.
  /// Without, standard input goes to standard output and a file beside itself. `suffix`: of the
  /// names that are made, if it is known yet. Refuses what would put two outputs at one place.
  static Outcome<Destination> find(const Options& options, const char* suffix);

  /// The output of an input: a name that is made has this suffix, such as ".ply". Fails if nothing
  /// such can or may be written there.
  Outcome<std::string> of(const std::string& input, const char* suffix,
                          io::Encoding encoding) const;

  /// The name that was given for the output, or "-"; none if it is made from the input's.
  std::optional<std::string> given(const std::string& input) const;

 private:
  enum class Kind { given, directory, beside };

  Destination(const Options& options, Kind kind)
      : kind_(kind),
        where_(options.output.value_or("")),
        force_(options.force),
        inputs_(ids_of(options.inputs)) {}
  std::string path(const std::string& input, const char* suffix) const;

  Kind kind_;
  std::string where_;
  bool force_;
  FileIds inputs_;
};

}  // namespace clers::cli

#endif

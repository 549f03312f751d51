// The commands of the program, after the command line is understood.
#ifndef CLERS_CODEC_CLI_COMMANDS_H
#define CLERS_CODEC_CLI_COMMANDS_H

#include <optional>
#include <string>
#include <vector>

#include "codec/cli/adapt.h"
#include "codec/cli/formats.h"
#include "codec/cli/outcome.h"
#include "codec/cli/reconstruct.h"
#include "codec/cli/simplify.h"
#include "codec/cli/subdivide.h"
#include "codec/decode.h"
#include "codec/encode.h"

namespace clers::cli {

struct Options {
  std::vector<std::string> inputs;
  std::optional<std::string> output;  ///< of commands that write; as Destination takes it
  std::optional<Format> from;         ///< of mesh files read
  std::optional<Format> to;           ///< of mesh files written
  bool text = false;                  ///< text is written where the format offers both
  bool strict = false;                ///< what cannot be carried is an error
  bool remove_inputs = false;
  bool force = false;
  bool quiet = false;
  bool json = false;
  EncodeOptions encode;
  Subdivision subdivision;
  Adaptation adaptation;
  Fewer fewer;
  Reconstructing reconstruction;
  std::optional<std::string> frames;  ///< the directory that adapt writes a sequence into
  DecodeOptions decode;
  std::optional<std::size_t> piece;  ///< decode only this one
};

/// Each prints its own errors and returns the exit status.
Exit encode(const Options& options);
Exit decode(const Options& options);
Exit info(const Options& options);
Exit verify(const Options& options);  ///< inputs: the original, the .clers file
Exit check(const Options& options);
Exit subdivide(const Options& options);
Exit adapt(const Options& options);
Exit simplify(const Options& options);
Exit reconstruct(const Options& options);

/// One line on stderr, after the program's name.
void complain(const std::string& line);

}  // namespace clers::cli

#endif

// The command line of clers.
#ifndef CLERS_CODEC_CLI_COMMAND_LINE_H
#define CLERS_CODEC_CLI_COMMAND_LINE_H

#include "codec/cli/outcome.h"

namespace clers::cli {

/// Understands the arguments and runs the command they name. Prints its own errors.
Exit run(int argc, char** argv);

}  // namespace clers::cli

#endif

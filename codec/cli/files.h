// Whole files in and out. "-" is stdin and stdout.
#ifndef CLERS_CODEC_CLI_FILES_H
#define CLERS_CODEC_CLI_FILES_H

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "codec/cli/outcome.h"

namespace clers::cli {

using Bytes = std::vector<std::byte>;

/// What messages call a file: its name, or "standard input" for "-".
std::string input_name(const std::string& path);

Outcome<Bytes> read_file(const std::string& path);

/// What write_file would refuse before any work is done: an output that exists (without
/// `overwrite`), a directory, a terminal.
Outcome<Done> check_output(const std::string& path, bool overwrite);

/// Writes a file so that its name leads to the old content or to all of the new, whatever happens.
/// What is not a regular file (a pipe, a device) is written as it goes.
Outcome<Done> write_file(const std::string& path, std::span<const std::byte> bytes, bool overwrite);

/// Text for stdout: the report of a command.
Outcome<Done> print(std::string_view text);

}  // namespace clers::cli

#endif

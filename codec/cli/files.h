// Whole files in and out. "-" is stdin and stdout.
#ifndef CLERS_CODEC_CLI_FILES_H
#define CLERS_CODEC_CLI_FILES_H

#include <sys/types.h>

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "codec/cli/outcome.h"

namespace clers::cli {

using Bytes = std::vector<std::byte>;

/// What messages call a file: its name, or "standard input" for "-".
std::string input_name(const std::string& path);

/// The same of an output.
std::string output_name(const std::string& path);

Outcome<Bytes> read_file(const std::string& path);

/// Regular files by device and inode: what they are, whatever they are called.
using FileIds = std::set<std::pair<dev_t, ino_t>>;
FileIds ids_of(std::span<const std::string> paths);

/// Of an input that is not wanted any more.
Outcome<Done> remove_input(const std::string& path);

/// What write_file would refuse before any work is done: an output that exists (without
/// `overwrite`), one that is an input, a directory.
Outcome<Done> check_output(const std::string& path, bool overwrite, const FileIds& inputs);

/// Writes a file so that its name leads to the old content or to all of the new, whatever happens.
/// What is not a regular file (a pipe, a device) is written as it goes.
Outcome<Done> write_file(const std::string& path, std::span<const std::byte> bytes, bool overwrite);

/// Text for stdout: the report of a command.
Outcome<Done> print(std::string_view text);

}  // namespace clers::cli

#endif

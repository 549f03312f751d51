// How a run of the program ends.
#ifndef CLERS_CODEC_CLI_OUTCOME_H
#define CLERS_CODEC_CLI_OUTCOME_H

#include <cstdint>
#include <string>

#include "codec/error.h"

namespace clers::cli {

/// The program's exit status. Part of its interface.
enum class Exit : int {
  done = 0,
  different = 1,  ///< verify found a difference
  usage = 2,      ///< the command line is wrong, or an output exists and -f is not given
  input = 3,      ///< an input cannot be read or is not accepted
  limit = 4,      ///< a limit was hit, memory included
  output = 5,     ///< writing failed
  undecided = 6,  ///< verify could not decide within the work allowed
};

/// Why a run stops: the status and one line for stderr, without the program's name.
struct Stop {
  Exit exit = Exit::input;
  std::string line;
};

template <class T>
using Outcome = Result<T, Stop>;

inline Failure<Stop> stop(Exit exit, std::string line) {
  return {Stop{exit, std::move(line)}};
}

/// For a limit that was hit: "; --max-faces 200 or more allows it".
inline std::string what_would_do(const Error& error) {
  constexpr const char* options[] = {"", "--max-meshes", "--max-vertices", "--max-faces",
                                     "--max-memory"};
  if (error.limited == Limited::nothing) return "";
  std::string needed = std::to_string(error.needed);
  constexpr std::uint64_t mebi = 1u << 20;
  if (error.limited == Limited::memory && error.needed >= mebi)
    needed = std::to_string((error.needed + mebi - 1) / mebi) + "M";
  return std::string("; ") + options[static_cast<unsigned>(error.limited)] + " " + needed +
         " or more allows it";
}

/// An error of the library about a file.
inline Failure<Stop> stop(const std::string& file, const Error& error) {
  Exit exit = Exit::input;
  if (error.code == ErrorCode::limit || error.code == ErrorCode::out_of_memory ||
      error.code == ErrorCode::too_large)
    exit = Exit::limit;
  if (error.code == ErrorCode::io_failed) exit = Exit::output;
  return stop(exit, file + ": " + describe(error) + what_would_do(error));
}

}  // namespace clers::cli

#endif

// What somebody meant who typed something else.
#ifndef CLERS_CODEC_CLI_WORDS_H
#define CLERS_CODEC_CLI_WORDS_H

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace clers::cli {

/// The one of `words` that takes the fewest letters inserted, removed, replaced or swapped with
/// their neighbour, if that is at most a third of it.
std::optional<std::string> closest(std::string_view typed, std::span<const std::string> words);

/// "a, b or c", with that word before the last; "" of none.
std::string list(std::span<const std::string> words, const char* last);

}  // namespace clers::cli

#endif

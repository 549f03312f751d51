// Text from strangers' files, made safe to show: a terminal obeys what a name hides in it.
#ifndef CLERS_CODEC_CLI_PRINTABLE_H
#define CLERS_CODEC_CLI_PRINTABLE_H

#include <cstddef>
#include <string>
#include <string_view>

namespace clers::cli {

/// Text as one line: control characters, marks that turn the direction of writing, and bytes that
/// are no UTF-8 become escapes such as \x1b; all else stays.
std::string printable(std::string_view text);

/// The beginning of printable text that takes at most so many columns of a terminal. What is not
/// ASCII is taken to be two wide.
std::string_view fitting(std::string_view text, std::size_t columns);

}  // namespace clers::cli

#endif

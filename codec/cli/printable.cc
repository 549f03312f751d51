// Bytes of strangers as text that a terminal can show.
#include "codec/cli/printable.h"

#include <fmt/format.h>

#include <cstdint>

namespace clers::cli {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;  ///< 0: the text does not begin with a character of UTF-8
};

/// The first character: RFC 3629, so neither overlong nor a surrogate.
Character first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const std::size_t bytes = lead < 0x80            ? 1
                            : lead >> 5 == 0b110   ? 2
                            : lead >> 4 == 0b1110  ? 3
                            : lead >> 3 == 0b11110 ? 4
                                                   : 0;
  if (bytes == 0 || bytes > text.size()) return {};
  std::uint32_t code = bytes == 1 ? lead : lead & (0x7fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if (byte(i) >> 6 != 0b10) return {};
    code = code << 6 | (byte(i) & 0x3f);
  }
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < least[bytes] || code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff)) return {};
  return {code, bytes};
}

bool shows(std::uint32_t code) {
  const bool control = code < 0x20 || (code >= 0x7f && code < 0xa0);
  const bool line_end = code == 0x2028 || code == 0x2029;
  const bool direction = code == 0x61c || code == 0x200e || code == 0x200f ||
                         (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return !control && !line_end && !direction;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const Character first = first_of(text);
    const std::size_t bytes = first.bytes == 0 ? 1 : first.bytes;
    if (first.bytes != 0 && shows(first.code))
      out += text.substr(0, bytes);
    else if (first.code == '\n')
      out += "\\n";
    else
      for (const char c : text.substr(0, bytes))
        out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    text.remove_prefix(bytes);
  }
  return out;
}

std::string_view fitting(std::string_view text, std::size_t columns) {
  std::size_t end = 0;
  while (end < text.size()) {
    const Character first = first_of(text.substr(end));
    const std::size_t width = first.bytes > 1 ? 2 : 1;
    if (width > columns) break;
    columns -= width;
    end += first.bytes == 0 ? 1 : first.bytes;
  }
  return text.substr(0, end);
}

}  // namespace clers::cli

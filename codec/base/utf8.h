// Is it UTF-8 (RFC 3629)? Names in files are.
#ifndef CLERS_CODEC_BASE_UTF8_H
#define CLERS_CODEC_BASE_UTF8_H

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace clers::internal {

/// The place of the first byte that is no part of a character; text.size() if there is none.
/// Overlong forms, surrogates and what is above U+10FFFF are no characters.
inline std::size_t first_not_utf8(std::string_view text) {
  const auto byte = [&](std::size_t i) -> std::uint32_t {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
  };
  std::size_t i = 0;
  while (i < text.size()) {
    const std::uint32_t lead = byte(i);
    const std::size_t more = lead < 0x80 ? 0 : lead < 0xe0 ? 1 : lead < 0xf0 ? 2 : 3;
    if (more > 0 && (lead < 0xc2 || lead > 0xf4)) return i;
    for (std::size_t k = 1; k <= more; ++k) {
      const std::uint32_t low = k > 1 ? 0x80 : lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
      const std::uint32_t high = k > 1 ? 0xbf : lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
      if (byte(i + k) < low || byte(i + k) > high) return i;
    }
    i += more + 1;
  }
  return i;
}

inline bool is_utf8(std::string_view text) {
  return first_not_utf8(text) == text.size();
}

}  // namespace clers::internal

#endif

// As RFC 3986 and RFC 4648 have it.
#include "codec/gltf/uri.h"

#include <array>
#include <cstdint>

#include "codec/base/utf8.h"

namespace clers::gltf {
namespace {

constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::array<std::uint8_t, 256> make_values() {
  std::array<std::uint8_t, 256> values;
  values.fill(64);
  for (std::uint8_t i = 0; i < 64; ++i) values[static_cast<unsigned char>(digits[i])] = i;
  return values;
}

int hexadecimal(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = static_cast<char>(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

}  // namespace

std::optional<std::string_view> data_head(std::string_view uri) {
  constexpr std::string_view scheme = "data:", mark = ";base64";
  if (!uri.starts_with(scheme)) return std::nullopt;
  const std::size_t comma = uri.find(',');
  if (comma == uri.npos || !uri.substr(0, comma).ends_with(mark)) return std::nullopt;
  return uri.substr(0, comma + 1);
}

std::optional<std::vector<std::byte>> data_bytes(std::string_view uri) {
  const auto head = data_head(uri);
  if (!head) return std::nullopt;
  static const std::array<std::uint8_t, 256> values = make_values();
  std::string_view text = uri.substr(head->size());
  for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  unsigned have = 0;
  for (const char c : text) {
    const std::uint32_t value = values[static_cast<unsigned char>(c)];
    if (value == 64) return std::nullopt;
    bits = bits << 6 | value;
    if ((have += 6) < 8) continue;
    have -= 8;
    bytes.push_back(static_cast<std::byte>(bits >> have & 0xff));
  }
  return bytes;
}

std::string base64(std::span<const std::byte> bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
    for (unsigned k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

std::optional<std::string> relative_path(std::string_view uri) {
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == ':' && path.find('/') == path.npos) return std::nullopt;  // a scheme
    if (uri[i] == '?' || uri[i] == '#') return std::nullopt;
    if (uri[i] == '%' && i + 2 < uri.size() && hexadecimal(uri[i + 1]) >= 0 &&
        hexadecimal(uri[i + 2]) >= 0) {
      path += static_cast<char>(16 * hexadecimal(uri[i + 1]) + hexadecimal(uri[i + 2]));
      i += 2;
    } else {
      path += uri[i];
    }
  }
  if (path.empty() || path.starts_with('/') || path.find('\0') != path.npos ||
      !clers::internal::is_utf8(path))
    return std::nullopt;
  return path;
}

bool leads_down(std::string_view path) {
  if (path.empty() || path.ends_with('/') || path.find_first_of("\\:") != path.npos) return false;
  for (std::size_t at = 0; at <= path.size();) {
    const std::size_t slash = std::min(path.find('/', at), path.size());
    const std::string_view part = path.substr(at, slash - at);
    if (part.empty() || part == "." || part == "..") return false;
    at = slash + 1;
  }
  return true;
}

}  // namespace clers::gltf

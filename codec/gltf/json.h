// JSON as a tree that loses nothing but white space: numbers stay text, members their order.
#ifndef CLERS_CODEC_GLTF_JSON_H
#define CLERS_CODEC_GLTF_JSON_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <clers/error.h>

namespace clers::gltf {

struct Json {
  enum class Kind : std::uint8_t { null, boolean, number, string, array, object };

  Kind kind = Kind::null;
  std::string text = {};               ///< of numbers as they are written, "true", "false", strings
  std::vector<Json> items = {};        ///< of an array; of an object its values,
  std::vector<std::string> keys = {};  ///< one of these each

  bool is(Kind k) const { return kind == k; }
  /// The member of that name, the last if there are several; nullptr if there is none.
  const Json* find(std::string_view key) const {
    for (std::size_t i = keys.size(); i-- > 0;)
      if (keys[i] == key) return &items[i];
    return nullptr;
  }
  Json* find(std::string_view key) {
    return const_cast<Json*>(static_cast<const Json*>(this)->find(key));
  }
  void add(std::string key, Json value) {
    keys.push_back(std::move(key));
    items.push_back(std::move(value));
  }
  void remove(std::string_view key);

  static Json number(std::string text) { return {Kind::number, std::move(text)}; }
  static Json number(std::uint64_t n) { return number(std::to_string(n)); }
  static Json string(std::string text) { return {Kind::string, std::move(text)}; }
};

/// No deeper than this.
inline constexpr unsigned most_depth = 256;

/// Parses RFC 8259's JSON in UTF-8. Errors: malformed, with the byte.
Expected<Json> parse(std::string_view text);

/// Without white space.
std::string print(const Json& json);

/// A number that is an integer, however it is written; none if it is no such.
std::optional<std::uint64_t> integer(const Json& json);
/// A number as a double.
std::optional<double> real(const Json& json);

}  // namespace clers::gltf

#endif

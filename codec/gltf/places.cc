// One walk for both directions: it guesses a number from those before it.
#include "codec/gltf/places.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace clers::gltf {
namespace {

struct View {
  std::uint64_t stride = 0;
  std::uint64_t next = 0;    ///< where the next accessor may be
  std::uint64_t length = 0;  ///< that its accessors need
};

std::vector<Json>* list(Json& document, const char* key) {
  Json* found = document.find(key);
  return found == nullptr || !found->is(Json::Kind::array) ? nullptr : &found->items;
}

std::uint64_t number(const Json& object, const char* key) {
  const Json* json = object.find(key);
  return json == nullptr ? 0 : integer(*json).value_or(0);
}

/// Bytes of an element, and of a component.
struct Size {
  std::uint64_t element, component;
};
Size size_of(const Json& accessor) {
  const std::uint64_t type = number(accessor, "componentType");
  const std::uint64_t component = type <= 5121 ? 1 : type <= 5123 ? 2 : type <= 5126 ? 4 : 8;
  const Json* name = accessor.find("type");
  const std::string text = name == nullptr ? "" : name->text;
  const std::uint64_t n = text == "SCALAR" ? 1
                          : text.empty()   ? 0
                                           : static_cast<std::uint64_t>(text.back()) & 15;
  if (!text.starts_with("MAT")) return {n * component, component};
  return {n * ((n * component + 3) / 4 * 4), component};
}

std::uint64_t aligned(std::uint64_t place, std::uint64_t to) {
  return to == 0 ? place : (place + to - 1) / to * to;
}

/// Calls guess(field, number) for each place and size that is said, or null, in an order in which
/// numbers depend on those before; it returns the number that there is.
template <class Guess>
void walk(Json& document, Guess guess) {
  const auto field = [&](Json& object, const char* key, std::uint64_t number) {
    Json* json = object.find(key);
    return json == nullptr ? 0 : guess(*json, number);
  };
  std::vector<View> views;
  std::vector<std::uint64_t> buffers;
  std::vector<Json>* all_views = list(document, "bufferViews");
  if (all_views != nullptr)
    for (const Json& view : *all_views) views.push_back({number(view, "byteStride")});
  if (std::vector<Json>* accessors = list(document, "accessors"))
    for (Json& accessor : *accessors) {
      const std::uint64_t index = number(accessor, "bufferView"), count = number(accessor, "count");
      if (index >= views.size() || accessor.find("bufferView") == nullptr) continue;
      View& view = views[static_cast<std::size_t>(index)];
      const auto [size, component] = size_of(accessor);
      const std::uint64_t at = field(accessor, "byteOffset", aligned(view.next, component));
      const std::uint64_t stride = view.stride == 0 ? size : view.stride,
                          behind = stride == 0 ? 0 : at % stride + size,
                          start = stride == 0 ? at : at - at % stride;
      // Beside this one, while there is room in the stride; else behind it.
      view.next = behind < stride ? at + size : start + stride * count;
      view.length = std::max(view.length, start + stride * count);
    }
  if (std::vector<Json>* all = list(document, "buffers")) buffers.resize(all->size());
  std::vector<std::uint64_t> ends = buffers;
  if (all_views != nullptr)
    for (std::size_t i = 0; i < all_views->size(); ++i) {
      Json& view = (*all_views)[i];
      const std::uint64_t index = number(view, "buffer");
      if (index >= buffers.size()) continue;
      std::uint64_t& next = buffers[static_cast<std::size_t>(index)];
      std::uint64_t& end = ends[static_cast<std::size_t>(index)];
      const std::uint64_t length = field(view, "byteLength", views[i].length);
      const std::uint64_t at = field(view, "byteOffset", aligned(next, 4));
      next = at + length;
      end = std::max(end, next);
    }
  if (std::vector<Json>* all = list(document, "buffers"))
    for (std::size_t i = 0; i < all->size(); ++i) field((*all)[i], "byteLength", ends[i]);
}

}  // namespace

void shorten_places(Json& document) {
  walk(document, [](Json& field, std::uint64_t guessed) {
    const std::uint64_t n = integer(field).value_or(0);
    if (n == guessed && field.text == std::to_string(n)) field = {};
    return n;
  });
}

void restore_places(Json& document) {
  walk(document, [](Json& field, std::uint64_t guessed) {
    if (!field.is(Json::Kind::null)) return integer(field).value_or(0);
    field = Json::number(guessed);
    return guessed;
  });
}

}  // namespace clers::gltf

// The words of the extension, and how extensions come and go.
#ifndef CLERS_CODEC_GLTF_EXTENSION_FORMAT_H
#define CLERS_CODEC_GLTF_EXTENSION_FORMAT_H

#include <algorithm>
#include <cstdint>
#include <utility>

#include "codec/gltf/extension.h"
#include "codec/gltf/json.h"

namespace clers::gltf {

inline constexpr std::uint64_t target_vertices = 34962, target_indices = 34963;
inline constexpr char view_key[] = "bufferView", attributes_key[] = "attributes",
                      targets_key[] = "targets", list_key[] = "list", in_turn_key[] = "inTurn",
                      same_key[] = "same";

/// Adds a word to a list, or takes it off; the list goes when it is empty.
inline void add_word(Json& document, const char* key, const char* word) {
  if (document.find(key) == nullptr) document.add(key, Json{Json::Kind::array});
  document.find(key)->items.push_back(Json::string(word));
}
inline void remove_word(Json& document, const char* key, const char* word) {
  Json* list = document.find(key);
  if (list == nullptr) return;
  std::erase_if(list->items, [&](const Json& item) { return item.text == word; });
  if (list->items.empty()) document.remove(key);
}

inline Json& extensions_of(Json& object) {
  if (object.find("extensions") == nullptr) object.add("extensions", Json{Json::Kind::object});
  return *object.find("extensions");
}
inline void remove_extension(Json& object, const char* name = extension_name) {
  Json* extensions = object.find("extensions");
  if (extensions == nullptr) return;
  extensions->remove(name);
  if (extensions->items.empty()) object.remove("extensions");
}

}  // namespace clers::gltf

#endif

// Buffers are made anew of the views that stay and those that come.
#include "codec/gltf/views.h"

#include <algorithm>
#include <string>
#include <utility>

namespace clers::gltf {
namespace {

void set(Json& object, const char* key, std::uint64_t n) {
  if (Json* json = object.find(key))
    *json = Json::number(n);
  else
    object.add(key, Json::number(n));
}

Json& list(Json& document, const char* key) {
  if (document.find(key) == nullptr) document.add(key, Json{Json::Kind::array});
  return *document.find(key);
}

/// The place of bytes that are added to a buffer.
std::size_t append(std::vector<std::byte>& buffer, std::span<const std::byte> bytes) {
  buffer.resize((buffer.size() + 3) / 4 * 4);
  const std::size_t at = buffer.size();
  buffer.insert(buffer.end(), bytes.begin(), bytes.end());
  return at;
}

}  // namespace

std::vector<std::size_t> exchange_views(const Layout& layout, std::vector<std::size_t> places,
                                        std::vector<NewView> views, Json& document,
                                        Buffers& buffers) {
  std::vector<std::size_t> numbers;
  if (views.empty()) return numbers;
  Json& all = list(document, "bufferViews");
  Json& all_buffers = list(document, "buffers");
  std::size_t home = 0;  // of what is new: the first buffer with bytes
  while (home < buffers.size() && buffers[home].empty()) ++home;
  if (home == buffers.size()) {
    all_buffers.items.push_back(Json{Json::Kind::object});
    buffers.emplace_back();
  }
  std::sort(places.begin(), places.end());
  Buffers made(buffers.size());
  for (std::size_t i = 0; i < layout.views.size(); ++i) {
    const View& view = layout.views[i];
    if (std::binary_search(places.begin(), places.end(), i) || buffers[view.buffer].empty())
      continue;
    const auto from =
        std::span(buffers[view.buffer])
            .subspan(static_cast<std::size_t>(view.offset), static_cast<std::size_t>(view.length));
    set(all.items[i], "byteOffset", append(made[view.buffer], from));
  }
  std::size_t at = 0;
  for (std::size_t k = 0; k < std::max(views.size(), places.size()); ++k) {
    if (k >= places.size()) all.items.push_back(Json{Json::Kind::object});
    const std::size_t number = k < places.size() ? places[k] : all.items.size() - 1;
    if (k < views.size()) {
      numbers.push_back(number);
      at = append(made[home], views[k].bytes);
    }
    const NewView& view = views[std::min(k, views.size() - 1)];
    Json& json = all.items[number];
    json.remove("byteStride");
    json.remove("target");
    set(json, "buffer", home);
    set(json, "byteOffset", at);
    set(json, "byteLength", view.bytes.size());
    if (view.stride != 0) set(json, "byteStride", view.stride);
    if (view.target != 0) set(json, "target", view.target);
  }
  for (std::size_t b = 0; b < made.size(); ++b) {
    if (made[b].empty() && buffers[b].empty()) continue;  // has no bytes of its own
    if (made[b].empty()) made[b].resize(4);
    set(all_buffers.items[b], "byteLength", made[b].size());
    buffers[b] = std::move(made[b]);
  }
  return numbers;
}

}  // namespace clers::gltf

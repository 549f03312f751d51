// EXT_meshopt_compression: a view that has it lies in a buffer without bytes, and in another one
// compressed.
#include <algorithm>
#include <utility>

#include "codec/gltf/extension_format.h"
#include "codec/gltf/foreign.h"
#include "codec/gltf/marks.h"
#include "codec/gltf/views.h"

namespace clers::gltf {
namespace {

constexpr char meshopt_name[] = "EXT_meshopt_compression";

const Json* meshopt_of(const Json& object) {
  const Json* extensions = object.find("extensions");
  const Json* found = extensions == nullptr ? nullptr : extensions->find(meshopt_name);
  return found != nullptr && found->is(Json::Kind::object) ? found : nullptr;
}

std::string text_of(const Json& object, const char* key, const char* otherwise) {
  const Json* json = object.find(key);
  return json != nullptr && json->is(Json::Kind::string) ? json->text : otherwise;
}

/// Decodes what a view stands for.
Expected<NewView> decode_view(const Json& json, const Json& extension, std::size_t index,
                              const Buffers& buffers, const decltype(Decoders::meshopt)& decode) {
  const auto wrong = [&](std::string what) {
    return malformed("bufferViews", index, std::string(meshopt_name) + ": " + std::move(what));
  };
  std::string fault;
  const std::uint64_t buffer = member(extension, "buffer", ~std::uint64_t(0), fault),
                      at = member(extension, "byteOffset", 0, fault),
                      size = member(extension, "byteLength", 0, fault),
                      stride = member(extension, "byteStride", 0, fault),
                      count = member(extension, "count", 0, fault),
                      length = member(json, "byteLength", 0, fault);
  NewView view;
  view.stride = member(json, "byteStride", 0, fault);
  view.target = member(json, "target", 0, fault);
  if (!fault.empty()) return wrong(std::move(fault));
  if (buffer >= buffers.size()) return wrong("no such buffer");
  const std::vector<std::byte>& from = buffers[static_cast<std::size_t>(buffer)];
  if (at > from.size() || size > from.size() - at)
    return wrong("goes beyond the end of its buffer");
  if (stride == 0 || count != length / stride || length % stride != 0)
    return wrong("the bufferView has no count * byteStride bytes");
  auto bytes =
      decode(std::span(from).subspan(static_cast<std::size_t>(at), static_cast<std::size_t>(size)),
             static_cast<std::size_t>(count), static_cast<std::size_t>(stride),
             text_of(extension, "mode", ""), text_of(extension, "filter", "NONE"));
  if (!bytes) return Failure{bytes.error()};
  if (bytes->size() != length) return wrong("is not decoded to as many bytes as it says");
  view.bytes = std::move(*bytes);
  return view;
}

/// Takes the extension off buffers, and those off that nothing is in any more.
void drop_buffers(Json& document, Buffers& buffers, std::vector<std::uint64_t>& empty) {
  Json* list = document.find("buffers");
  if (list == nullptr) return;
  std::vector<bool> named(list->items.size());
  for (const Json& view : document.find("bufferViews")->items) {
    const Json* json = view.find("buffer");
    const auto n = json == nullptr ? std::nullopt : integer(*json);
    if (n && *n < named.size()) named[static_cast<std::size_t>(*n)] = true;
  }
  for (std::size_t b = list->items.size(); b-- > 0;) {
    const bool stood_in = meshopt_of(list->items[b]) != nullptr;
    remove_extension(list->items[b], meshopt_name);
    if (!stood_in || named[b] || b + 1 != list->items.size() || b == 0) continue;
    list->items.pop_back();
    buffers.pop_back();
    std::erase(empty, std::uint64_t(b));
  }
}

}  // namespace

Expected<Done> decode_meshopt(Json& document, Buffers& buffers, std::vector<std::uint64_t>& empty,
                              const decltype(Decoders::meshopt)& decode,
                              std::vector<std::string>& remarks) {
  const auto views = list_of(document, "bufferViews");
  if (!views) return Failure{views.error()};
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < (*views)->size(); ++i)
    if (meshopt_of((**views)[i]) != nullptr) places.push_back(i);
  if (places.empty()) return Done{};
  if (!decode) {
    remarks.push_back(kept_compressed(meshopt_name));
    return Done{};
  }
  const auto layout = read_layout(document, as_set(empty, buffers.size()));
  if (!layout) return Failure{layout.error()};
  std::vector<NewView> decoded;
  for (const std::size_t i : places) {
    const Json& json = (**views)[i];
    auto view = decode_view(json, *meshopt_of(json), i, buffers, decode);
    if (!view) return Failure{view.error()};
    decoded.push_back(std::move(*view));
  }
  exchange_views(*layout, places, std::move(decoded), document, buffers);
  for (Json& view : document.find("bufferViews")->items) remove_extension(view, meshopt_name);
  drop_buffers(document, buffers, empty);
  remove_word(document, "extensionsUsed", meshopt_name);
  remove_word(document, "extensionsRequired", meshopt_name);
  remarks.push_back(std::string(meshopt_name) + ": " + std::to_string(places.size()) +
                    (places.size() == 1 ? " bufferView was" : " bufferViews were") + " decoded");
  return Done{};
}

}  // namespace clers::gltf

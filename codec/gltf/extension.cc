// Which primitive has which attributes and triangles of which file, and which views hold files.
#include "codec/gltf/extension.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "codec/gltf/extension_format.h"
#include "codec/gltf/views.h"

namespace clers::gltf {
namespace {

/// Views that accessors, their sparse parts and pictures name: how often each.
std::vector<std::size_t> named_views(const Json& document, std::size_t count) {
  std::vector<std::size_t> named(count);
  const auto name = [&](const Json* object) {
    const Json* view = object == nullptr ? nullptr : object->find(view_key);
    const auto n = view == nullptr ? std::nullopt : integer(*view);
    if (n && *n < count) ++named[static_cast<std::size_t>(*n)];
  };
  for (const char* key : {"accessors", "images"})
    if (const Json* list = document.find(key))
      for (const Json& item : list->items) {
        name(&item);
        if (const Json* sparse = item.find("sparse")) {
          name(sparse->find("indices"));
          name(sparse->find("values"));
        }
      }
  return named;
}

class Compressor {
 public:
  Compressor(const Layout& layout, const Plan& plan, Json& document)
      : layout_(layout), plan_(plan), document_(document) {
    for (std::size_t m = 0; m < plan.meshes.size(); ++m) {
      for (std::size_t i = 0; i < plan.meshes[m].attributes.size(); ++i)
        parts_[plan.meshes[m].attributes[i].run] = {m, i};
      for (std::size_t i = 0; i < plan.meshes[m].lists.size(); ++i)
        parts_[plan.meshes[m].lists[i]] = {m, i};
    }
  }

  void run(std::span<const std::vector<std::byte>> files, Buffers& buffers) {
    if (files.empty()) return;
    std::vector<NewView> views;
    for (const auto& file : files) views.push_back({file});
    views_ = exchange_views(layout_, places(), std::move(views), document_, buffers);
    std::size_t p = 0;
    for (Json& mesh : document_.find("meshes")->items)
      if (Json* primitives = mesh.find("primitives"))
        for (Json& primitive : primitives->items) describe(layout_.primitives[p++], primitive);
    forget_places();
    add_word(document_, "extensionsUsed", extension_name);
    add_word(document_, "extensionsRequired", extension_name);
  }

 private:
  struct Part {
    std::size_t mesh, index;
  };
  /// What of a mesh an accessor has; nullptr if it has something else.
  const Part* part(std::size_t accessor) const {
    const auto found = parts_.find(plan_.first[layout_.accessors[accessor].base]);
    return found == parts_.end() ? nullptr : &found->second;
  }

  /// Views that only accessors of meshes name.
  std::vector<std::size_t> places() const {
    std::vector<std::size_t> named = named_views(document_, layout_.views.size());
    const std::vector<std::size_t> all = named;
    for (std::size_t i = 0; i < layout_.accessors.size(); ++i)
      if (part(i) != nullptr) --named[layout_.runs[layout_.accessors[i].base].view];
    std::vector<std::size_t> free;
    for (std::size_t v = 0; v < named.size(); ++v)
      if (named[v] == 0 && all[v] > 0) free.push_back(v);
    return free;
  }

  Json attributes_of(std::span<const Primitive::Vertices> vertices, std::size_t& mesh) {
    Json json{Json::Kind::object};
    for (const Primitive::Vertices& v : vertices)
      if (const Part* p = part(v.accessor)) {
        mesh = p->mesh;
        said_.insert(v.accessor);
        json.add(v.name, Json::number(p->index));
      }
    return json;
  }

  void describe(const Primitive& primitive, Json& json) {
    std::size_t mesh = none, at = 0;
    const auto take = [&](std::size_t count) {
      const auto some = std::span(primitive.vertices).subspan(at, count);
      at += count;
      return attributes_of(some, mesh);
    };
    const Json *attributes = json.find(attributes_key), *targets = json.find(targets_key);
    Json extension{Json::Kind::object};
    Json found = take(attributes == nullptr ? 0 : attributes->items.size());
    Json of_targets{Json::Kind::array};
    bool any_target = false;
    if (targets != nullptr)
      for (const Json& target : targets->items) {
        of_targets.items.push_back(take(target.items.size()));
        any_target = any_target || !of_targets.items.back().items.empty();
      }
    // Indices may be values of some mesh, too: then no list has them, and they are the same as
    // those.
    const Part* list = primitive.indices == none ? nullptr : part(primitive.indices);
    if (list != nullptr && !is_list(list->mesh, primitive.indices)) list = nullptr;
    if (list != nullptr) {
      mesh = list->mesh;
      said_.insert(primitive.indices);
    }
    if (mesh == none) return;
    extension.add(view_key, Json::number(views_[mesh]));
    extension.add(attributes_key, std::move(found));
    if (any_target) extension.add(targets_key, std::move(of_targets));
    if (list != nullptr) extension.add(list_key, Json::number(list->index));
    if (primitive.indices == none && primitive.mode == mode_triangles && plan_.meshes[mesh].in_turn)
      extension.add(in_turn_key, Json{Json::Kind::boolean, "true"});
    extensions_of(json).add(extension_name, std::move(extension));
  }

  bool is_list(std::size_t mesh, std::size_t accessor) const {
    const std::vector<std::size_t>& lists = plan_.meshes[mesh].lists;
    return std::find(lists.begin(), lists.end(), plan_.first[layout_.accessors[accessor].base]) !=
           lists.end();
  }

  /// Accessors of meshes have no place any more. Those that no primitive names are the same as one
  /// that is.
  void forget_places() {
    std::map<std::size_t, std::size_t> of_run;
    for (const std::size_t i : said_) of_run.emplace(plan_.first[layout_.accessors[i].base], i);
    Json same{Json::Kind::array};
    std::vector<Json>& accessors = document_.find("accessors")->items;
    for (std::size_t i = 0; i < layout_.accessors.size(); ++i) {
      if (part(i) == nullptr) continue;
      accessors[i].remove(view_key);
      accessors[i].remove("byteOffset");
      if (said_.contains(i)) continue;
      Json pair{Json::Kind::array};
      pair.items.push_back(Json::number(i));
      pair.items.push_back(Json::number(of_run.at(plan_.first[layout_.accessors[i].base])));
      same.items.push_back(std::move(pair));
    }
    if (same.items.empty()) return;
    Json extension{Json::Kind::object};
    extension.add(same_key, std::move(same));
    extensions_of(document_).add(extension_name, std::move(extension));
  }

  const Layout& layout_;
  const Plan& plan_;
  Json& document_;
  std::map<std::size_t, Part> parts_;  ///< of runs
  std::vector<std::size_t> views_;     ///< of meshes
  std::set<std::size_t> said_;         ///< accessors that an extension says
};

}  // namespace

void compress(const Layout& layout, const Plan& plan, std::span<const std::vector<std::byte>> files,
              Json& document, Buffers& buffers) {
  Compressor(layout, plan, document).run(files, buffers);
}

}  // namespace clers::gltf

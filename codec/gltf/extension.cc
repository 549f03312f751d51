// Which primitive has which attributes and triangles of which file, and which views hold files.
#include "codec/gltf/extension.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "codec/gltf/triangles.h"
#include "codec/gltf/views.h"
#include <clers/decode.h>

namespace clers::gltf {
namespace {

constexpr std::uint64_t target_vertices = 34962, target_indices = 34963;
constexpr char view_key[] = "bufferView", attributes_key[] = "attributes",
               targets_key[] = "targets", list_key[] = "list", in_turn_key[] = "inTurn",
               same_key[] = "same";

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

/// Adds a word to a list, or takes it off; the list goes when it is empty.
void add_word(Json& document, const char* key, const char* word) {
  if (document.find(key) == nullptr) document.add(key, Json{Json::Kind::array});
  document.find(key)->items.push_back(Json::string(word));
}
void remove_word(Json& document, const char* key, const char* word) {
  Json* list = document.find(key);
  if (list == nullptr) return;
  std::erase_if(list->items, [&](const Json& item) { return item.text == word; });
  if (list->items.empty()) document.remove(key);
}

Json& extensions_of(Json& object) {
  if (object.find("extensions") == nullptr) object.add("extensions", Json{Json::Kind::object});
  return *object.find("extensions");
}
void remove_extension(Json& object) {
  Json* extensions = object.find("extensions");
  if (extensions == nullptr) return;
  extensions->remove(extension_name);
  if (extensions->items.empty()) object.remove("extensions");
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
    const Part* list = primitive.indices == none ? nullptr : part(primitive.indices);
    if (list != nullptr) {
      mesh = list->mesh;
      said_.insert(primitive.indices);
    }
    if (mesh == none) return;
    extension.add(view_key, Json::number(views_[mesh]));
    extension.add(attributes_key, std::move(found));
    if (any_target) extension.add(targets_key, std::move(of_targets));
    if (list != nullptr && is_list(mesh, primitive.indices))
      extension.add(list_key, Json::number(list->index));
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

/// What primitives say of the file in a view.
struct FileUse {
  std::map<std::size_t, std::size_t> attributes;  ///< of accessors
  std::map<std::size_t, std::size_t> lists;       ///< of accessors of indices
  bool in_turn = false;
};

class Expander {
 public:
  Expander(Json& document, Buffers& buffers) : document_(document), buffers_(buffers) {}

  Expected<Done> run(const std::vector<bool>& empty) {
    if (!is_used()) return Done{};
    auto layout = read_layout(document_, empty);
    if (!layout) return Failure{layout.error()};
    layout_ = std::move(*layout);
    std::size_t p = 0;
    if (Json* meshes = document_.find("meshes"))
      for (Json& mesh : meshes->items)
        if (Json* primitives = mesh.find("primitives"))
          for (Json& primitive : primitives->items) {
            if (!take(layout_.primitives[p], primitive))
              return malformed("meshes", layout_.primitives[p].mesh,
                               std::string(extension_name) + " says what cannot be");
            ++p;
          }
    for (const auto& [view, use] : files_)
      if (auto ok = fill(view, use); !ok) return ok;
    const std::vector<std::size_t> numbers =
        exchange_views(layout_, places(empty), std::move(views_), document_, buffers_);
    std::vector<Json>& accessors = document_.find("accessors")->items;
    for (std::size_t k = 0; k < numbers.size(); ++k) place(accessors[owners_[k]], numbers[k]);
    if (!same(accessors)) return fail(ErrorCode::malformed, "glTF: extensions: no such accessor");
    remove_extension(document_);
    remove_word(document_, "extensionsUsed", extension_name);
    remove_word(document_, "extensionsRequired", extension_name);
    return Done{};
  }

 private:
  bool is_used() const {
    const Json* used = document_.find("extensionsUsed");
    return used != nullptr && std::any_of(used->items.begin(), used->items.end(),
                                          [](const Json& j) { return j.text == extension_name; });
  }

  /// Takes the extension off a primitive, if there is one.
  bool take(const Primitive& primitive, Json& json) {
    const Json* extensions = json.find("extensions");
    const Json* found = extensions == nullptr ? nullptr : extensions->find(extension_name);
    if (found == nullptr) return true;
    std::string fault;
    const std::uint64_t view = member(*found, view_key, ~std::uint64_t(0), fault);
    if (!fault.empty() || view >= layout_.views.size()) return false;
    FileUse& use = files_[static_cast<std::size_t>(view)];
    const auto attributes = [&](const Json* from, const Json* of) {
      if (from == nullptr) return true;
      if (of == nullptr) return from->items.empty();
      for (std::size_t i = 0; i < from->keys.size(); ++i) {
        const Json* accessor = of->find(from->keys[i]);
        const auto index = integer(from->items[i]),
                   number = accessor == nullptr ? std::nullopt : integer(*accessor);
        if (!index || !number) return false;
        use.attributes[static_cast<std::size_t>(*number)] = static_cast<std::size_t>(*index);
      }
      return true;
    };
    bool good = attributes(found->find(attributes_key), json.find(attributes_key));
    const Json *targets = found->find(targets_key), *of_targets = json.find(targets_key);
    for (std::size_t i = 0; targets != nullptr && i < targets->items.size(); ++i)
      good = good && of_targets != nullptr && i < of_targets->items.size() &&
             attributes(&targets->items[i], &of_targets->items[i]);
    if (found->find(list_key) != nullptr) {
      good = good && primitive.indices != none;
      use.lists[primitive.indices] = static_cast<std::size_t>(member(*found, list_key, 0, fault));
    }
    use.in_turn = use.in_turn || found->find(in_turn_key) != nullptr;
    remove_extension(json);
    return good && fault.empty();
  }

  /// Decodes the file in a view, and makes views of what accessors have of it.
  Expected<Done> fill(std::size_t view, const FileUse& use) {
    const auto wrong = [&](std::string what) {
      return malformed("bufferViews", view, std::move(what));
    };
    const View& at = layout_.views[view];
    if (at.offset + at.length > buffers_[at.buffer].size()) return wrong("has no bytes");
    auto meshes = decode(
        std::span(buffers_[at.buffer])
            .subspan(static_cast<std::size_t>(at.offset), static_cast<std::size_t>(at.length)));
    if (!meshes) return Failure{meshes.error()};
    if (meshes->size() != 1)
      return wrong("a file of " + std::to_string(meshes->size()) + " meshes");
    const Mesh& mesh = meshes->front();
    auto triangles = part_triangles(mesh);
    if (!triangles) return wrong(triangles.error().what);
    auto numbers = vertex_numbers(mesh.vertex_count, *triangles, use.in_turn);
    if (!numbers) return wrong(numbers.error().what);
    for (const auto& [accessor, index] : use.attributes) {
      const Run run = run_of(accessor, 4);
      if (index >= mesh.attributes.size() || !is_values_of(mesh.attributes[index], run))
        return wrong("has no such values for accessors[" + std::to_string(accessor) + "]");
      add_view(accessor, run, renumbered(mesh.attributes[index], *numbers), target_vertices);
    }
    for (const auto& [accessor, list] : use.lists) {
      Run run = run_of(accessor, 1);
      if (list >= triangles->size() || (*triangles)[list].size() != run.count)
        return wrong("has no such triangles for accessors[" + std::to_string(accessor) + "]");
      std::vector<std::uint32_t> corners = (*triangles)[list];
      for (std::uint32_t& v : corners) v = (*numbers)[v];
      Buffers one(1, std::vector<std::byte>(packed_size(run)));
      scatter_indices(run, corners, one);
      add_view(accessor, run, {}, target_indices, std::move(one));
    }
    return Done{};
  }

  /// A run at the start of a view of its own.
  Run run_of(std::size_t accessor, std::uint64_t alignment) const {
    Run run = layout_.runs[layout_.accessors[accessor].base];
    run.buffer = 0;
    run.start = 0;
    run.stride = (run.size() + alignment - 1) / alignment * alignment;
    return run;
  }

  void add_view(std::size_t accessor, const Run& run, std::span<const std::byte> values,
                std::uint64_t target, Buffers one = {}) {
    if (one.empty()) {
      one.emplace_back(static_cast<std::size_t>(run.count * run.stride));
      scatter(run, values, one);
    }
    views_.push_back({std::move(one[0]), run.stride == run.size() ? 0 : run.stride, target});
    owners_.push_back(accessor);
  }

  /// Views of the files, and others that are the same bytes.
  std::vector<std::size_t> places(const std::vector<bool>& empty) const {
    std::set<std::pair<std::size_t, std::uint64_t>> starts;
    for (const auto& [view, use] : files_)
      starts.emplace(layout_.views[view].buffer, layout_.views[view].offset);
    std::vector<std::size_t> all;
    for (std::size_t v = 0; v < layout_.views.size(); ++v)
      if (!empty[layout_.views[v].buffer] &&
          starts.contains({layout_.views[v].buffer, layout_.views[v].offset}))
        all.push_back(v);
    return all;
  }

  static void place(Json& accessor, std::size_t view) {
    accessor.keys.insert(accessor.keys.begin(), view_key);
    accessor.items.insert(accessor.items.begin(), Json::number(view));
  }

  /// Gives accessors the places of those that they are said to be the same as.
  bool same(std::vector<Json>& accessors) const {
    const Json* extensions = document_.find("extensions");
    const Json* found = extensions == nullptr ? nullptr : extensions->find(extension_name);
    const Json* pairs = found == nullptr ? nullptr : found->find(same_key);
    if (pairs == nullptr) return true;
    for (const Json& pair : pairs->items) {
      if (pair.items.size() != 2) return false;
      const auto i = integer(pair.items[0]), k = integer(pair.items[1]);
      if (!i || !k || *i >= accessors.size() || *k >= accessors.size()) return false;
      const Json* view = accessors[static_cast<std::size_t>(*k)].find(view_key);
      const auto n = view == nullptr ? std::nullopt : integer(*view);
      if (!n) return false;
      place(accessors[static_cast<std::size_t>(*i)], static_cast<std::size_t>(*n));
    }
    return true;
  }

  Json& document_;
  Buffers& buffers_;
  Layout layout_;
  std::map<std::size_t, FileUse> files_;  ///< of views
  std::vector<NewView> views_;
  std::vector<std::size_t> owners_;  ///< accessors of the new views
};

}  // namespace

void compress(const Layout& layout, const Plan& plan, std::span<const std::vector<std::byte>> files,
              Json& document, Buffers& buffers) {
  Compressor(layout, plan, document).run(files, buffers);
}

Expected<Done> expand(Json& document, Buffers& buffers, const std::vector<bool>& empty) {
  return Expander(document, buffers).run(empty);
}

}  // namespace clers::gltf

// Files are decoded, once each, and what primitives have of them becomes views.
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "codec/gltf/extension.h"
#include "codec/gltf/extension_format.h"
#include "codec/gltf/triangles.h"
#include "codec/gltf/views.h"
#include <clers/decode.h>

namespace clers::gltf {
namespace {

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

Expected<Done> expand(Json& document, Buffers& buffers, const std::vector<bool>& empty) {
  return Expander(document, buffers).run(empty);
}

}  // namespace clers::gltf

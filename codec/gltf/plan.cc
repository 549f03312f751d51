// Primitives are gathered by the accessors that they share; then each run is given to who needs it
// first.
#include "codec/gltf/plan.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "codec/base/disjoint_sets.h"
#include "codec/gltf/overlaps.h"
#include "codec/gltf/uses.h"
#include <clers/mesh.h>

namespace clers::gltf {
namespace {

enum class Part : std::uint8_t { unused, vertices, indices, sparse_indices, sparse_values };

/// Primitives that share accessors.
struct Component {
  std::vector<std::size_t> primitives;
  std::vector<std::size_t> vertices;  ///< accessors, each once
  std::vector<std::size_t> indices;   ///< accessors, each once
  bool keep = false;
  bool one_count = true;  ///< all attributes have as many values
  std::uint64_t count = 0;
};

class Planner {
 public:
  Planner(const Layout& layout, const std::vector<bool>& odd, std::vector<Use> uses)
      : layout_(layout),
        odd_(odd),
        uses_(std::move(uses)),
        overlaps_(find_overlaps(layout)),
        part_(layout.runs.size()),
        owner_(layout.runs.size(), none) {}

  Plan run() {
    plan.first = overlaps_.first;
    plan.taken.resize(layout_.runs.size());
    gather();
    for (Component& c : components_) look_at(c);
    for (std::size_t i = 0; i < components_.size(); ++i) mark(i);
    mark_others();
    for (std::size_t i = 0; i < components_.size(); ++i) add_mesh(i);
    add_arrays();
    for (std::size_t i = 0; i < plan.taken.size(); ++i) plan.taken[i] = plan.taken[plan.first[i]];
    return std::move(plan);
  }

  Plan plan;

 private:
  const Accessor& accessor(std::size_t i) const { return layout_.accessors[i]; }
  const Run& run(std::size_t i) const { return layout_.runs[i]; }

  /// Whether a run is the codec's to have.
  bool free(std::size_t i) const { return run(i).has_bytes() && !overlaps_.fixed[i]; }

  void gather() {
    internal::DisjointSets sets(layout_.accessors.size());
    const auto unite = [&](std::size_t a, std::size_t b) {
      sets.unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
    };
    std::map<std::size_t, std::size_t> of_run;
    for (std::size_t i = 0; i < layout_.accessors.size(); ++i)
      unite(i, of_run.emplace(overlaps_.first[accessor(i).base], i).first->second);
    std::vector<std::vector<std::size_t>> named(layout_.primitives.size());
    for (std::size_t p = 0; p < named.size(); ++p) {
      const Primitive& primitive = layout_.primitives[p];
      for (const Primitive::Vertices& v : primitive.vertices) named[p].push_back(v.accessor);
      if (primitive.indices != none) named[p].push_back(primitive.indices);
      for (const std::size_t i : primitive.other_indices) named[p].push_back(i);
      for (const std::size_t i : named[p]) unite(i, named[p][0]);
    }
    std::map<std::uint32_t, std::size_t> of_set;
    for (std::size_t p = 0; p < named.size(); ++p) {
      if (named[p].empty()) continue;
      const std::uint32_t set = sets.find(static_cast<std::uint32_t>(named[p][0]));
      const auto [at, is_new] = of_set.emplace(set, components_.size());
      if (is_new) components_.emplace_back();
      components_[at->second].primitives.push_back(p);
    }
    for (Component& c : components_) {
      for (const std::size_t p : c.primitives) {
        const Primitive& primitive = layout_.primitives[p];
        for (const Primitive::Vertices& v : primitive.vertices) c.vertices.push_back(v.accessor);
        if (primitive.indices != none) c.indices.push_back(primitive.indices);
        for (const std::size_t i : primitive.other_indices) c.indices.push_back(i);
      }
      for (auto* list : {&c.vertices, &c.indices}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
      }
    }
  }

  /// Finds out whether vertices may be renumbered, by what the component itself says.
  void look_at(Component& c) const {
    if (c.vertices.empty()) {
      c.one_count = false;
      return;
    }
    c.count = accessor(c.vertices[0]).count;
    for (const std::size_t i : c.vertices) {
      const Accessor& a = accessor(i);
      c.one_count = c.one_count && a.count == c.count;
      c.keep = c.keep || !uses_[i].name.empty();
      c.keep = c.keep || std::binary_search(c.indices.begin(), c.indices.end(), i);
      c.keep = c.keep || (run(a.base).has_bytes() && overlaps_.fixed[a.base]);
      if (a.indices == none || run(a.indices).count == 0) continue;
      c.keep = c.keep || odd_[a.indices] || !free(a.indices) || !free(a.values);
    }
    for (const std::size_t i : c.indices) {
      const Accessor& a = accessor(i);
      c.keep = c.keep || !uses_[i].name.empty() || a.indices != none;
      if (a.count == 0) continue;
      c.keep = c.keep || odd_[a.base] || !free(a.base) || c.count - 1 > most_index(a.base);
    }
    bool faces = false, in_turn = false, sequence = false;
    for (const std::size_t p : c.primitives) {
      const Primitive& primitive = layout_.primitives[p];
      c.keep = c.keep || primitive.opaque;
      const bool triangles = primitive.mode == mode_triangles;
      if (primitive.indices != none) {
        faces = faces || triangles;
      } else if (triangles && c.count % 3 == 0) {
        in_turn = true;
      } else if (primitive.mode != mode_points) {
        sequence = true;
      }
    }
    c.keep = c.keep || (sequence && (faces || in_turn));
  }

  /// The greatest vertex that indices can name, one being left for "restart".
  std::uint64_t most_index(std::size_t i) const {
    const bool is_signed = run(i).scalar == Scalar::int8 || run(i).scalar == Scalar::int16 ||
                           run(i).scalar == Scalar::int32;
    const unsigned bits = 8 * static_cast<unsigned>(size_of(run(i).scalar)) - is_signed;
    return (std::uint64_t(1) << bits) - 2;
  }

  /// Says what a component needs of its runs. Two that need one run in different ways keep their
  /// order.
  void mark(std::size_t component) {
    const auto need = [&](std::size_t i, Part part) {
      if (i == none || !run(i).has_bytes()) return;
      i = overlaps_.first[i];
      if (part_[i] == Part::unused) {
        part_[i] = part;
        owner_[i] = component;
      } else if (part_[i] != part || owner_[i] != component) {
        components_[component].keep = components_[owner_[i]].keep = true;
      }
    };
    std::map<std::size_t, std::size_t> indices_of;  // of sparse values
    const Component& c = components_[component];
    for (const std::size_t v : c.vertices) {
      const Accessor& a = accessor(v);
      need(a.base, Part::vertices);
      need(a.indices, Part::sparse_indices);
      need(a.values, Part::sparse_values);
      if (a.values == none) continue;
      const std::size_t indices = overlaps_.first[a.indices];
      const auto known = indices_of.emplace(overlaps_.first[a.values], indices).first;
      if (known->second != indices) components_[component].keep = true;
    }
    for (const std::size_t i : c.indices) {
      need(accessor(i).base, Part::indices);
      need(accessor(i).indices, Part::sparse_indices);
      need(accessor(i).values, Part::sparse_values);
    }
  }

  /// The same of accessors that no primitive names.
  void mark_others() {
    std::vector<bool> named(layout_.accessors.size());
    for (const Component& c : components_)
      for (const auto* list : {&c.vertices, &c.indices})
        for (const std::size_t i : *list) named[i] = true;
    for (std::size_t i = 0; i < named.size(); ++i) {
      if (named[i]) continue;
      const Accessor& a = accessor(i);
      for (const std::size_t part : {a.base, a.indices, a.values})
        if (part != none && owner_[overlaps_.first[part]] != none)
          components_[owner_[overlaps_.first[part]]].keep = true;
    }
  }

  bool take(std::size_t i) {
    i = overlaps_.first[i];
    if (!free(i) || plan.taken[i]) return false;
    plan.taken[i] = true;
    return true;
  }

  void add_mesh(std::size_t component) {
    const Component& c = components_[component];
    if (!c.one_count) return;
    MeshPlan mesh;
    mesh.keep = c.keep;
    mesh.vertices = static_cast<std::uint32_t>(c.count);
    const Primitive& lead = layout_.primitives[c.primitives[0]];
    mesh.name = layout_.mesh_names[lead.mesh];
    bool positions = false;
    for (const std::size_t p : c.primitives)
      for (const Primitive::Vertices& v : layout_.primitives[p].vertices) {
        const std::size_t i = overlaps_.first[accessor(v.accessor).base];
        if (!take(i)) continue;
        // Displacements are no positions, even where positions are not taken, being sparse alone.
        const bool position =
            v.name == "POSITION" && !v.target && !positions && run(i).components() == 3;
        positions = positions || position;
        mesh.attributes.push_back({position ? position_name : fitting(v.name), i});
      }
    if (mesh.attributes.empty()) return;
    std::map<std::size_t, bool> only_triangles;  // runs of indices
    const auto used = [&](std::size_t indices, bool triangles) {
      const Accessor& a = accessor(indices);
      const bool can_be = triangles && a.count % 3 == 0 && a.indices == none;
      const auto at = only_triangles.emplace(overlaps_.first[a.base], can_be).first;
      at->second = at->second && can_be;
    };
    for (const std::size_t p : c.primitives) {
      const Primitive& primitive = layout_.primitives[p];
      const bool triangles = primitive.mode == mode_triangles;
      if (primitive.indices != none) used(primitive.indices, triangles);
      for (const std::size_t i : primitive.other_indices) used(i, false);
      if (primitive.indices == none && triangles && c.count % 3 == 0) mesh.in_turn = true;
    }
    const std::size_t number = plan.meshes.size();
    for (const auto& [i, triangles] : only_triangles)
      if (triangles && !odd_[i] && take(i))
        mesh.lists.push_back(i);
      else if (!c.keep)
        vertices_of_[i] = number;
    if (!c.keep)
      for (const std::size_t v : c.vertices)
        if (accessor(v).indices != none)
          vertices_of_[overlaps_.first[accessor(v).indices]] = number;
    plan.meshes.push_back(std::move(mesh));
  }

  static std::string fitting(const std::string& name) {
    return name.size() <= 255 ? name : "attribute";
  }

  void add_arrays() {
    for (std::size_t i = 0; i < layout_.accessors.size(); ++i) {
      const Accessor& a = accessor(i);
      add_array(
          a.base,
          uses_[i].name.empty() ? words(part_[overlaps_.first[a.base]]) : uses_[i].name.c_str(),
          uses_[i].each);
      if (a.indices == none) continue;
      add_array(a.indices, words(Part::sparse_indices), 1);
      add_array(a.values, words(Part::sparse_values), 1);
    }
  }

  static const char* words(Part part) {
    switch (part) {
      case Part::indices: return "indices";
      case Part::sparse_indices: return "sparse indices";
      case Part::sparse_values: return "sparse values";
      default: return "values";
    }
  }

  void add_array(std::size_t i, const char* name, std::uint64_t each) {
    i = overlaps_.first[i];
    if (!take(i)) return;
    const Run& r = run(i);
    ArrayPlan array{name, r.scalar, static_cast<std::uint8_t>(r.components()), none, {}};
    if (r.components() * each <= 255 && r.count % each == 0)
      array.components = static_cast<std::uint8_t>(r.components() * each);
    if (const auto of = vertices_of_.find(i); of != vertices_of_.end()) array.mesh = of->second;
    const auto [at, is_new] = arrays_.emplace(
        std::tuple(array.name, array.scalar, array.components, array.mesh), plan.arrays.size());
    if (is_new) plan.arrays.push_back(std::move(array));
    plan.arrays[at->second].runs.push_back(i);
  }

  const Layout& layout_;
  const std::vector<bool>& odd_;
  const std::vector<Use> uses_;
  const Overlaps overlaps_;
  std::vector<Part> part_;          ///< for each run that is the first such, what for
  std::vector<std::size_t> owner_;  ///< and which component first
  std::vector<Component> components_;
  std::map<std::size_t, std::size_t> vertices_of_;  ///< runs of vertices: the mesh
  std::map<std::tuple<std::string, Scalar, std::uint8_t, std::size_t>, std::size_t> arrays_;
};

}  // namespace

Expected<Plan> make_plan(const Layout& layout, const Json& document, const std::vector<bool>& odd) {
  auto uses = other_uses(layout, document);
  if (!uses) return Failure{uses.error()};
  return Planner(layout, odd, std::move(*uses)).run();
}

}  // namespace clers::gltf

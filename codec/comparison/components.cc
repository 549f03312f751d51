#include "codec/comparison/components.h"

#include <algorithm>
#include <numeric>

namespace clers::internal {

Components::Components(const ComparedMesh& mesh, const Classes& by_colour) {
  using Index = std::uint32_t;
  constexpr Index none = ~Index{0};
  // Union-find, the smallest vertex of a component its root.
  std::vector<Index> root(mesh.vertices());
  std::iota(root.begin(), root.end(), Index{0});
  const auto find = [&](Index v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (Index f = 0; f < mesh.faces.count(); ++f) {
    const auto cycle = mesh.faces.cycle(f);
    for (std::size_t j = 1; j < cycle.size(); ++j) {
      const Index a = find(cycle[0]), b = find(cycle[j]);
      root[std::max(a, b)] = std::min(a, b);
    }
  }
  // A counting sort by component keeps what is sorted by colour.
  std::vector<Index> number(mesh.vertices(), none);
  std::vector<Index> size;
  for (const auto& [h, f] : by_colour) {
    if (mesh.faces.size(f) == 0) continue;
    Index& k = number[find(mesh.faces.cycle(f)[0])];
    if (k == none) {
      k = count();
      colour.push_back(0);
      size.push_back(0);
    }
    colour[k] += mix(h);
    ++size[k];
  }
  begin_.resize(size.size() + 1);
  std::inclusive_scan(size.begin(), size.end(), begin_.begin() + 1);
  faces_.resize(begin_.back());
  std::vector<Index> at(begin_.begin(), begin_.end() - 1);
  for (const auto& face : by_colour)
    if (mesh.faces.size(face.second) > 0)
      faces_[at[number[find(mesh.faces.cycle(face.second)[0])]]++] = face;
}

}  // namespace clers::internal

// Disjoint sets of vertices, then a counting sort of the faces.
#include "codec/comparison/components.h"

#include <numeric>

#include "codec/base/disjoint_sets.h"
#include "codec/base/no_index.h"

namespace clers::internal {

Components::Components(const ComparedMesh& mesh, const Classes& by_colour) {
  using Index = std::uint32_t;
  DisjointSets sets(mesh.vertices());
  for (Index f = 0; f < mesh.faces.count(); ++f) {
    const auto cycle = mesh.faces.cycle(f);
    for (std::size_t j = 1; j < cycle.size(); ++j) sets.unite(cycle[0], cycle[j]);
  }
  // A counting sort by component keeps what is sorted by colour.
  std::vector<Index> number(mesh.vertices(), no_index);
  std::vector<Index> size;
  for (const auto& [h, f] : by_colour) {
    if (mesh.faces.size(f) == 0) continue;
    Index& k = number[sets.find(mesh.faces.cycle(f)[0])];
    if (k == no_index) {
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
      faces_[at[number[sets.find(mesh.faces.cycle(face.second)[0])]]++] = face;
}

}  // namespace clers::internal

#include "codec/soup/regular_faces.h"

#include <algorithm>

#include "codec/base/no_index.h"

namespace clers::internal {
namespace {

/// Whether each triangle has three vertices: what most meshes are, seen without a table.
bool no_vertex_twice(std::span<const std::uint32_t> corners) {
  bool all = true;
  for (std::size_t h = 0; h < corners.size(); h += 3) {
    const std::uint32_t a = corners[h], b = corners[h + 1], c = corners[h + 2];
    all &= a != b && b != c && c != a;
  }
  return all;
}

std::vector<std::uint32_t> degenerate_faces(const Cycles& faces, std::uint32_t vertex_count) {
  std::vector<std::uint32_t> degenerate, last_face(vertex_count, no_index);
  for (std::uint32_t f = 0; f < faces.count(); ++f) {
    bool is_degenerate = faces.size(f) < 3;
    for (const std::uint32_t v : faces.cycle(f)) {
      is_degenerate |= last_face[v] == f;
      last_face[v] = f;
    }
    if (is_degenerate) degenerate.push_back(f);
  }
  return degenerate;
}

}  // namespace

RegularFaces::RegularFaces(const Cycles& all, std::span<const std::uint32_t> sizes,
                           std::uint32_t vertex_count)
    : corners_(all.org), sizes_(sizes) {
  if (!all.triangles() || !no_vertex_twice(all.org))
    degenerate_ = degenerate_faces(all, vertex_count);
  if (!degenerate_.empty()) {
    kept_.reserve(all.count() - degenerate_.size());
    auto next = degenerate_.begin();
    for (std::uint32_t f = 0; f < all.count(); ++f) {
      if (next != degenerate_.end() && *next == f) {
        ++next;
        continue;
      }
      kept_.push_back(f);
      const auto cycle = all.cycle(f);
      kept_corners_.insert(kept_corners_.end(), cycle.begin(), cycle.end());
      kept_sizes_.push_back(all.size(f));
    }
    corners_ = kept_corners_;
    sizes_ = kept_sizes_;
  }
  if (std::all_of(sizes_.begin(), sizes_.end(), [](std::uint32_t n) { return n == 3; }))
    sizes_ = {};
}

}  // namespace clers::internal

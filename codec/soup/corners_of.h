// The corners of each vertex of triangles, as lists: one pass, where sorting them by vertex
// (Buckets) takes two, and most vertices are never asked for.
#ifndef CLERS_CODEC_SOUP_CORNERS_OF_H
#define CLERS_CODEC_SOUP_CORNERS_OF_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/base/no_index.h"

namespace clers::internal {

/// Lists of the corners of triangles by vertex, each beginning with the last. Cost: one pass; 4
/// bytes a vertex and a corner.
class CornersOf {
 public:
  /// Every corner is below `vertices`. The corners must outlive this.
  CornersOf(std::span<const std::uint32_t> corners, std::size_t vertices)
      : corners_(corners), first_(vertices, no_index), next_(corners.size()) {
    for (std::uint32_t h = 0; h < corners.size(); ++h) {
      next_[h] = first_[corners[h]];
      first_[corners[h]] = h;
    }
  }
  static std::uint64_t memory(std::uint64_t corners, std::uint64_t vertices) {
    return 4 * (corners + vertices);
  }

  /// Calls visit(neighbour) with the two other corners of the triangles of v, of the last `most` of
  /// them. Vertices that no triangle has have no neighbours.
  template <class Visit>
  void for_each_neighbour(std::uint32_t v, unsigned most, Visit visit) const {
    if (v >= first_.size()) return;
    for (std::uint32_t h = first_[v]; h != no_index && most > 0; h = next_[h], --most) {
      const std::uint32_t t = h / 3 * 3, j = h - t;
      visit(corners_[t + (j + 1) % 3]);
      visit(corners_[t + (j + 2) % 3]);
    }
  }

 private:
  std::span<const std::uint32_t> corners_;
  std::vector<std::uint32_t> first_, next_;
};

}  // namespace clers::internal

#endif

// Faces that no surface can have: those of fewer than three corners and those that repeat a vertex.
//
// They are told one by one, by vertices: in rising order, each rotated so that the least sequence
// of vertices comes of it, since cycles have no first corner.
#ifndef CLERS_CODEC_SOUP_DEGENERATE_FACES_H
#define CLERS_CODEC_SOUP_DEGENERATE_FACES_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/entropy/coder.h"
#include "codec/soup/corners_of.h"

namespace clers::internal {

/// The rotation of a cycle that makes the least sequence; the first one of those. Linear.
inline std::uint32_t least_rotation(std::span<const std::uint32_t> cycle) {
  const std::size_t n = cycle.size();
  std::size_t i = 0, j = 1, k = 0;  // rotations i and j agree in k places
  while (i < n && j < n && k < n) {
    const std::uint32_t a = cycle[(i + k) % n], b = cycle[(j + k) % n];
    if (a == b) {
      ++k;
      continue;
    }
    (a > b ? i : j) += k + 1;
    if (i == j) ++j;
    k = 0;
  }
  return static_cast<std::uint32_t>(n == 0 ? 0 : std::min(i, j));
}

/// Codes loose faces in rising order.
class DegenerateFaceModel {
 public:
  /// `corners` are the triangles of the mesh, as far as it is a surface, by its vertices.
  DegenerateFaceModel(std::span<const std::uint32_t> corners, std::uint32_t surface_vertices,
                      std::uint32_t vertices)
      : vertices_(vertices), corners_(corners, surface_vertices) {}

  /// A Coder that encodes is told the size.
  template <class Coder>
  std::uint32_t code_size(Coder& coder, std::uint32_t size) {
    return size_.code(coder, size);
  }

  /// A Coder that encodes is told the corners; one that decodes fills them in. False: what was
  /// decoded is no vertex.
  template <class Coder>
  bool code_corners(Coder& coder, std::span<std::uint32_t> face) {
    for (std::size_t j = 0; j < face.size(); ++j) {
      const std::uint64_t v = j == 0 ? std::uint64_t(first_) + step_.code(coder, face[0] - first_)
                                     : code_corner(coder, face[j - 1], face[0], face[j]);
      if (v >= vertices_) return false;
      face[j] = static_cast<std::uint32_t>(v);
    }
    if (!face.empty()) first_ = face[0];
    return true;
  }

 private:
  static constexpr unsigned most_candidates = 16;
  static constexpr unsigned most_looked_at = 32;  ///< triangles, so that hubs cost no more

  template <class Coder>
  std::uint64_t code_corner(Coder& coder, std::uint32_t before, std::uint32_t first,
                            std::uint32_t value) {
    if (coder.bit(again_, value == before)) return before;
    if (before != first && coder.bit(back_, value == first)) return first;
    // No corner of the least rotation is below its first.
    std::uint32_t candidates[most_candidates];
    unsigned n = 0;
    corners_.for_each_neighbour(before, most_looked_at, [&](std::uint32_t c) {
      if (n == most_candidates || c <= first) return;
      if (std::find(candidates, candidates + n, c) == candidates + n) candidates[n++] = c;
    });
    for (unsigned i = 0; i < n; ++i)
      if (coder.bit(neighbour_[i], value == candidates[i])) return candidates[i];
    return std::uint64_t(first) + far_.code(coder, value - first);
  }

  std::uint32_t vertices_;
  CornersOf corners_;
  std::uint32_t first_ = 0;  ///< of the face before
  NumberModel size_, step_, far_;
  BitModel again_, back_, neighbour_[most_candidates];
};

}  // namespace clers::internal

#endif

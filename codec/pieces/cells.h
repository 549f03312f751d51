// Small cells of a mesh, in space where it has places, else grown along its faces.
#ifndef CLERS_CODEC_PIECES_CELLS_H
#define CLERS_CODEC_PIECES_CELLS_H

#include <cstdint>
#include <vector>

#include "codec/base/faces.h"
#include "codec/mesh.h"

namespace clers::internal {

/// Where vertices lie: numbers that sort like their coordinates.
class SpatialKeys {
 public:
  /// Cost: linear, but for coordinates of 64 bits n log n; 4 bytes a coordinate.
  explicit SpatialKeys(const Mesh& mesh);

  unsigned axes() const { return axes_; }  ///< 0: nothing is known
  std::uint32_t at(unsigned axis, std::uint32_t v) const { return of(v)[axis]; }
  const std::uint32_t* of(std::uint32_t v) const {
    return numbers_.data() + std::size_t(axes_) * v;
  }
  /// How far two numbers of an axis are from each other: a length, where the unit is known.
  std::uint64_t distance(std::uint32_t low, std::uint32_t high) const;
  /// An order of places; where nothing is known, of vertices.
  bool less(std::uint32_t v, std::uint32_t w) const {
    for (unsigned axis = 0; axis < axes_; ++axis)
      if (at(axis, v) != at(axis, w)) return at(axis, v) < at(axis, w);
    return axes_ == 0 && v < w;
  }
  /// The same for vertices at the same place, and spread over all numbers.
  std::uint32_t hash(std::uint32_t v) const {
    std::uint32_t h = 0;
    for (unsigned axis = 0; axis < axes_; ++axis) {
      h = (h ^ at(axis, v)) * 0x9e3779b1u;
      h ^= h >> 15;
    }
    return h * 0x85ebca6bu;
  }

 private:
  unsigned axes_ = 0;
  bool is_float_ = false;
  std::vector<std::uint32_t> numbers_;  ///< vertex by vertex
};

/// The cell of each vertex: `pieces` times `each` cells or somewhat fewer, of about as many
/// vertices. Those of a piece have numbers that follow each other and lie together, for a first
/// idea of the pieces.
///
/// In space cells are halves of halves, by planes across an axis that cut few edges, so they depend
/// on places only: not on the order of faces and vertices. Without places they grow from vertex to
/// vertex. Cost: linear; some 8 bytes a face, without places 16. Throws std::bad_alloc only.
std::vector<std::uint32_t> cells_of(const SpatialKeys& places, const Faces& faces,
                                    std::uint32_t vertex_count, std::uint32_t pieces,
                                    std::uint32_t each, unsigned threads);

}  // namespace clers::internal

#endif

// Which faces repeat another one, and the faces without them: what a surface is made of. Knows how
// faces lie on edges.
#ifndef CLERS_CODEC_SOUP_DISTINCT_FACES_H
#define CLERS_CODEC_SOUP_DISTINCT_FACES_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/base/faces.h"
#include "codec/soup/adjacency.h"
#include "codec/soup/repeated_faces.h"

namespace clers::internal {

/// Those at defective edges that are better left away: without them most of their edges have two
/// faces at most. By ascending face. Precondition: `adjacency` is that of the faces. Cost: linear
/// but for a sort of the faces of each defective edge.
std::vector<Repeat> find_repeats(const Faces& faces, const Adjacency& adjacency);

/// Faces without those that repeat others, in their order.
struct DistinctFaces {
  DistinctFaces(const Faces& all, std::span<const Repeat> repeats);

  /// How their half-edges lie on edges, from how all do: what match_edges() would find. Cost:
  /// linear, but for a sort of the defective edges.
  Adjacency adjacency(const Faces& all, Adjacency of_all) const;

  std::vector<std::uint32_t> faces;           ///< of all
  std::vector<std::uint32_t> corners, sizes;  ///< no sizes: triangles
};

}  // namespace clers::internal

#endif

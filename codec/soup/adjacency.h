// Which half-edges are two sides of one edge, and whether faces form a manifold.
#ifndef CLERS_CODEC_SOUP_ADJACENCY_H
#define CLERS_CODEC_SOUP_ADJACENCY_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/base/faces.h"
#include "codec/error.h"
#include "topology/ids.h"

namespace clers::internal {

/// Which half-edges are the sides of one edge.
struct Adjacency {
  std::vector<HalfEdge> twins;  ///< null on boundaries and at defective edges
  /// Edges of more than two faces, and those of two that run along them the same way: the sides of
  /// one edge together and in file order, edges by their first sides. Edge i has those from
  /// ends[i - 1] to ends[i].
  std::vector<std::uint32_t> sides, ends;

  std::uint32_t edges() const { return static_cast<std::uint32_t>(ends.size()); }
  std::span<const std::uint32_t> edge(std::uint32_t i) const {
    const std::uint32_t begin = i == 0 ? 0 : ends[i - 1];
    return std::span(sides).subspan(begin, ends[i] - begin);
  }
};

/// Brings defective edges into the order of their first sides.
void order_defects(Adjacency& adjacency);

/// Precondition: every face has three corners or more and repeats no vertex, and vertices are below
/// vertex_count. Cost: linear, but for a sort of the sides of defective edges and of edges whose
/// smaller vertex has more than eight to larger ones; 64 bytes a vertex besides the result. Where
/// there are more vertices than corners it is n log n, and 8 bytes a corner. Throws std::bad_alloc
/// only.
Adjacency match_edges(const Faces& faces, std::uint32_t vertex_count);

/// Twins of the half-edges of faces, null on their boundary.
/// Errors name the first face, in file order, that keeps its edges from being those of an oriented
/// manifold: nonmanifold_edge, nonorientable (an edge that two faces run along in the same
/// direction). Vertices are not looked at: see vertex_of_several_fans.
/// Precondition and cost: as above.
Expected<std::vector<HalfEdge>> find_twins(const Faces& faces, std::uint32_t vertex_count);

/// The first vertex, in the order of the faces, whose corners form more than one fan: a
/// non-manifold vertex; the null index if there is none. Cost: linear.
std::uint32_t vertex_of_several_fans(const Faces& faces, std::span<const HalfEdge> twins,
                                     std::uint32_t vertex_count);

}  // namespace clers::internal

#endif

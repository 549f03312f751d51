// Which half-edges of a triangle mesh are two sides of one edge, and whether the mesh is a
// manifold.
#ifndef CLERS_CODEC_ADJACENCY_H
#define CLERS_CODEC_ADJACENCY_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/error.h"
#include "topology/ids.h"

namespace clers {

/// Twins of the half-edges of a triangle mesh, null on its boundary.
/// Errors name the first face, in file order, that keeps its edges from being those of an oriented
/// manifold: inconsistent_mesh (an index out of range), repeated_vertex, nonmanifold_edge,
/// nonorientable (an edge that two faces run along in the same direction). Vertices are not looked
/// at: see vertex_of_several_fans. Cost: linear but for hubs, which never cost more than a sort; 64
/// bytes a vertex besides the result. Throws std::bad_alloc only.
Expected<std::vector<HalfEdge>> find_twins(std::span<const std::uint32_t> corners,
                                           std::uint32_t vertex_count);

/// The first vertex, in the order of the faces, whose corners form more than one fan: a
/// non-manifold vertex; the null index if there is none. Cost: linear.
std::uint32_t vertex_of_several_fans(std::span<const std::uint32_t> corners,
                                     std::span<const HalfEdge> twins, std::uint32_t vertex_count);

}  // namespace clers

#endif

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

/// Twins of the half-edges of an oriented manifold triangle mesh, null on its boundary.
/// Errors name the first element, in the order of the faces, that keeps the mesh from being one:
/// inconsistent_mesh (an index out of range), repeated_vertex, nonmanifold_edge, nonorientable (an
/// edge that two faces run along in the same direction), nonmanifold_vertex. Cost: linear for
/// meshes of bounded degree, never more than a sort. Throws std::bad_alloc only.
Expected<std::vector<HalfEdge>> find_twins(std::span<const std::uint32_t> corners,
                                           std::uint32_t vertex_count);

}  // namespace clers

#endif

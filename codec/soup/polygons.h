// Polygons as triangles in the order in which Edgebreaker meets them, and back.
//
// A polygon entered through the edge a -> b becomes a fan of triangles around b, from a on. The
// side b -> v of each but the last is a diagonal, and always the one through which the walk goes
// on: nothing behind it is visited yet, and the right side goes first. So the triangles of a
// polygon follow each other, and all that is left to tell of polygons is how many corners each has.
//
//              v1_______v2
//              /\ .      \              faces of the surface: (a, b, v1), (v1, b, v2), (v2, b, v3)
//             /   . .     \             the polygon:          a, b, v3, v2, v1
//            a       .  .  v3
//             \         . ./
//              `---------b
#ifndef CLERS_CODEC_SOUP_POLYGONS_H
#define CLERS_CODEC_SOUP_POLYGONS_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/base/faces.h"
#include "topology/ids.h"

namespace clers::internal {

/// Triangles in the order of Edgebreaker's walk; side 0 of each is its gate.
struct Triangulation {
  std::vector<std::uint32_t> corners;
  std::vector<HalfEdge> twins;
  std::vector<std::uint32_t> gates;  ///< the half-edge through which each polygon is entered, in
                                     ///< the order of the walk
};

/// Cuts the polygons of a surface into triangles. Precondition: `twins` make the faces an oriented
/// manifold surface whose vertices are one fan each. Cost: linear. Throws std::bad_alloc only.
Triangulation triangulate(const Faces& faces, std::span<const HalfEdge> twins,
                          std::uint32_t vertex_count);

}  // namespace clers::internal

#endif

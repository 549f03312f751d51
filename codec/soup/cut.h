// Any faces -> an oriented manifold surface, by few cuts. It glues, zips and splits as the
// operators of CAGD 2010, §5.1.1, do, where there is no surface yet that these could change. Knows
// faces and edges, and nothing of what cuts cost in bytes.
#ifndef CLERS_CODEC_SOUP_CUT_H
#define CLERS_CODEC_SOUP_CUT_H

#include <cstdint>
#include <vector>

#include "codec/base/faces.h"
#include "codec/soup/adjacency.h"
#include "topology/ids.h"

namespace clers::internal {

/// The surface that faces become when they are cut where they are no manifold. Faces keep their
/// order.
struct CutSurface {
  std::vector<std::uint32_t> corners;   ///< vertices of the surface; reversed faces run backwards
                                        ///< from their corner 0 on
  std::vector<HalfEdge> twins;          ///< null on the boundary
  std::vector<std::uint32_t> copied;    ///< copied[i]: the vertex of the input that vertex
                                        ///< vertex_count + i of the surface is a copy of
  std::vector<std::uint32_t> reversed;  ///< faces, ascending
};

/// At which vertices each fan gets a vertex of its own.
enum class Fans { at_defects, all };

/// Glues faces along edges as far as an oriented manifold allows.
///
/// Regions, which edges of two faces that run opposite ways connect, stay as they are. Where two
/// regions meet along an edge in the same direction one of them is reversed; where that contradicts
/// itself the surface has no orientation and is cut. Where more than two faces meet, two are glued
/// if that joins two surfaces without reversing one, best if they are not on the same vertices, or
/// if it zips what is side by side; never if it made a handle. Of the regions of a component the
/// fewer faces are reversed. What remains apart at a vertex becomes several surface vertices.
///
/// Vertices that are no fan are found where a boundary or a defective edge shows them; those at
/// which closed fans touch by looking at all, which takes about as long as all the rest.
///
/// Precondition: `adjacency` is that of the faces; every face has three corners or more and repeats
/// no vertex, and vertices are below vertex_count. Cost: linear. Throws std::bad_alloc only.
CutSurface cut(const Faces& faces, std::uint32_t vertex_count, Adjacency adjacency, Fans fans);

}  // namespace clers::internal

#endif

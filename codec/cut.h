// Any faces -> an oriented manifold surface, by few cuts.
#ifndef CLERS_CODEC_CUT_H
#define CLERS_CODEC_CUT_H

#include <cstdint>
#include <vector>

#include "codec/faces.h"
#include "topology/ids.h"

namespace clers {

/// The surface that faces become when they are cut where they are no manifold.
struct CutSurface {
  std::vector<std::uint32_t> faces;          ///< of the input, in the order they have here
  std::vector<std::uint32_t> first_corners;  ///< for each: its corner, once turned, that is first
  std::vector<std::uint32_t> corners;        ///< vertices of the surface
  std::vector<std::uint32_t> sizes;          ///< of the faces; empty: triangles
  std::vector<HalfEdge> twins;               ///< null on the boundary
  std::vector<std::uint32_t> point;  ///< of each vertex: the vertex of the input it is a copy of
  std::vector<bool> turned;  ///< faces of the input that run backwards here, from their corner 0 on
  bool order_free = false;   ///< the same surface comes of the faces in whatever order
};

/// What to do with handles that edges of two faces make.
enum class Handles {
  keep,
  cut,  ///< every component becomes a disc or a sphere
};

/// Glues faces along edges as far as an oriented manifold allows.
///
/// Surfaces grow by breadth, first across edges of two faces. A face that runs the other way is
/// turned; of every component the fewer are. Where that contradicts itself, the component has no
/// orientation and is cut. Where more than two faces meet, two are glued if that joins two
/// surfaces, best those that need no turning and are not on the same vertices, or if it zips what
/// lies beside each other; never if it made a handle. What remains apart at a vertex becomes
/// several surface vertices. The order of the faces matters only where the mesh looks alike from
/// several of them.
///
/// Precondition: every face has three corners or more and repeats no vertex, and vertices are below
/// vertex_count. Cost: linear but for a sort of the faces. Throws std::bad_alloc only.
CutSurface cut(const Faces& faces, std::uint32_t vertex_count, Handles handles);

}  // namespace clers

#endif

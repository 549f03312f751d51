// The faces of a mesh as they are coded: those of its surface, cut into triangles, and all others.
// What tells which corner of the mesh a corner of the surface is.
#ifndef CLERS_CODEC_ATTRIBUTES_CODED_FACES_H
#define CLERS_CODEC_ATTRIBUTES_CODED_FACES_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/connectivity/coded_surface.h"
#include "codec/mesh.h"

namespace clers::internal {

/// A view of the faces of a mesh in coded order: first those of the surface, which run as its
/// triangles do, whether the mesh has them reversed or not; then those that no surface has.
///
///        v2____v1         Polygons are several triangles, so that half-edges that start at one
///        / \ .  \         corner of the mesh share it. A diagonal has the same corners of the
///       /   . \  \        mesh on both sides. Faces beside the surface have corners, but no
///      a________ b        half-edges.
struct CodedFaces {
  CodedSurface surface;
  /// The corner of the mesh that each half-edge of the surface starts at; empty: the same number.
  std::span<const std::uint32_t> corner_of = {};
  std::span<const std::uint32_t> corners = {};  ///< the vertex of each corner of the mesh
  std::span<const std::uint32_t> sizes = {};    ///< corners of each face; empty: triangles
  std::uint32_t vertices = 0;
  /// Which value of the position each vertex has; empty: its own (points.h).
  std::span<const std::uint32_t> place_of = {};

  std::uint32_t corner(std::size_t h) const {
    return corner_of.empty() ? static_cast<std::uint32_t>(h) : corner_of[h];
  }
  std::size_t faces() const { return sizes.empty() ? corners.size() / 3 : sizes.size(); }
  /// Elements of a domain.
  std::size_t count(Domain domain) const {
    switch (domain) {
      case Domain::vertex: return vertices;
      case Domain::corner: return corners.size();
      case Domain::face: return faces();
    }
    return 0;
  }
};

}  // namespace clers::internal

#endif

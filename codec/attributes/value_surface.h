// What values are coded along that are not those of a surface's own vertices: of wedges, or of
// vertices of which several are at one place.
#ifndef CLERS_CODEC_ATTRIBUTES_VALUE_SURFACE_H
#define CLERS_CODEC_ATTRIBUTES_VALUE_SURFACE_H

#include <cstdint>
#include <span>

#include "codec/connectivity/coded_surface.h"
#include "codec/mesh.h"

namespace clers::internal {

/// A surface cut along the seams of an attribute: its corners name values, and its twins are null
/// at seams. Values that no triangle has are coded like isolated vertices.
///
///        \   |   /               Two triangles are on both sides of a seam, a thick line.
///     ====1==3====   seam        Corners at a vertex that no seam parts are a wedge, and
///        /   |   \               have one value: here the vertex has wedges 1, above, and 3.
///
/// A value may be that of several wedges, at other places: then triangle introduced_by[v] has the
/// first of them.
struct ValueSurface {
  /// Triangles in coded order, without those in which a corner has no value. introduced_by is as in
  /// CodedSurface, but that any corner may introduce a value.
  CodedSurface surface;
  /// The vertex of the mesh where each value is first; empty: value i is at vertex i.
  std::span<const std::uint32_t> vertex_of = {};
  /// Values by vertex of the mesh, decoded; nullptr where there are none.
  const Attribute* position = nullptr;
  /// The vertex of the mesh at each corner; empty: that of its value.
  std::span<const std::uint32_t> vertex_at = {};
  /// The joints that values are the weights of, decoded; nullptr where there are none.
  const Attribute* joints = nullptr;

  std::uint32_t vertex(std::uint32_t value) const {
    return vertex_of.empty() ? value : vertex_of[value];
  }
  std::uint32_t vertex_of_corner(std::size_t corner) const {
    return vertex_at.empty() ? vertex(surface.corners[corner]) : vertex_at[corner];
  }
};

}  // namespace clers::internal

#endif

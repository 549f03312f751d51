// What coding knows of the triangles that a file holds: the one thing that values are predicted
// along, the same for who encodes and who decodes. It knows nothing of bytes or of values.
#ifndef CLERS_CODEC_CONNECTIVITY_CODED_SURFACE_H
#define CLERS_CODEC_CONNECTIVITY_CODED_SURFACE_H

#include <cstdint>
#include <span>
#include <vector>

#include "topology/ids.h"

namespace clers::internal {

/// A view of a surface as connectivity codes it: polygons cut into triangles, faces that were
/// reversed not yet turned back, cuts not yet stitched. So all triangles run one way, and every
/// vertex is one fan.
///
/// Triangles are in coded order, that in which Edgebreaker met them; side 0 of each is its gate.
/// Side i of triangle t is half_edge(t, i) and runs from its corner i to the next.
///
/// Triangle introduced_by[v] is the first, in coded order, that has vertex v. There v is corner 2,
/// the tip across from the gate; only the two ends of a component's first gate are corners 0 and 1.
/// So all that is across the gate of the triangle that introduces a vertex was introduced before:
///
///            v            t = introduced_by[v]
///           / \           gate = half_edge(t, 0), from a to b
///      t   a===b          twins[gate] is a side of an earlier triangle; null on the boundary
///           \ /
///            c            the corner across it
struct CodedSurface {
  std::span<const std::uint32_t> corners;        ///< vertices of the surface, 3 a triangle
  std::span<const HalfEdge> twins;               ///< of all sides; empty unless they are wanted
  std::span<const std::uint32_t> introduced_by;  ///< a triangle for each vertex of the surface
  /// The mesh's vertex, in coded numbers, of each vertex of the surface: where cuts are stitched,
  /// several have one. Empty: they are the same.
  std::span<const std::uint32_t> vertex_of;

  std::uint32_t in_mesh(std::uint32_t v) const { return vertex_of.empty() ? v : vertex_of[v]; }
};

/// The memory of one.
struct CodedArrays {
  std::vector<std::uint32_t> corners;
  std::vector<HalfEdge> twins;
  std::vector<std::uint32_t> introduced_by, vertex_of;

  CodedSurface view() const { return {corners, twins, introduced_by, vertex_of}; }
};

}  // namespace clers::internal

#endif

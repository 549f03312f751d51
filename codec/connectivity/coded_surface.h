// What coding knows of the triangles that a file holds: the one thing that values are predicted
// along, the same for who encodes and who decodes. It knows nothing of bytes or of values.
#ifndef CLERS_CODEC_CONNECTIVITY_CODED_SURFACE_H
#define CLERS_CODEC_CONNECTIVITY_CODED_SURFACE_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "topology/ids.h"

namespace clers::internal {

/// A view of a surface as connectivity codes it: polygons cut into triangles, and faces that were
/// reversed not yet turned back, so that all triangles run one way.
///
/// Triangles are in coded order, that in which Edgebreaker met them; side 0 of each is its gate.
/// Side i of triangle t is half_edge(t, i) and runs from its corner i to the next.
///
/// Corners name vertices of the mesh: they are what has a value. Where the mesh had to be cut,
/// several vertices of the surface are copies of one of the mesh, and each of them is a fan of
/// triangles of its own. Twins are those of the surface, null at a cut as on the boundary: to walk
/// around a corner over them is to walk around one copy.
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
///
/// Faces that are coded one by one (soup/raw_faces.h) are no surface. They have a CodedSurface all
/// the same, without twins, in which any corner may introduce a vertex.
struct CodedSurface {
  static constexpr std::uint32_t nothing = 0xffffffffu;  ///< introduces a vertex of no triangle

  std::span<const std::uint32_t> corners;  ///< 3 a triangle
  std::span<const HalfEdge> twins;         ///< of all sides; empty unless they are wanted
  /// A triangle for each vertex; those from introduced_by.size() on are in none.
  std::span<const std::uint32_t> introduced_by;

  /// Whether a triangle has vertex v.
  bool has(std::uint32_t v) const {
    return v < introduced_by.size() && introduced_by[v] != nothing;
  }

  /// Whether vertex u was introduced before v. Precondition: triangles have them both.
  bool before(std::uint32_t u, std::uint32_t v) const {
    const std::uint32_t first = introduced_by[u], second = introduced_by[v];
    if (first != second) return first < second;
    for (const std::uint32_t corner : corners.subspan(3 * std::size_t(first), 3)) {
      if (corner == v) return false;
      if (corner == u) return true;
    }
    return false;
  }
};

/// Calls visit(t, i) for each vertex that a triangle has, in the order of their introduction: it is
/// corner i of triangle t, which introduces it. Cost: linear.
template <class Visit>
void for_each_introduced(const CodedSurface& surface, Visit visit) {
  const std::uint32_t* c = surface.corners.data();
  const std::uint32_t triangles = static_cast<std::uint32_t>(surface.corners.size() / 3);
  for (std::uint32_t t = 0; t < triangles; ++t, c += 3) {
    if (surface.introduced_by[c[0]] == t) visit(t, 0u);
    if (surface.introduced_by[c[1]] == t && c[1] != c[0]) visit(t, 1u);
    if (surface.introduced_by[c[2]] == t && c[2] != c[1] && c[2] != c[0]) visit(t, 2u);
  }
}

/// Finds which triangle introduces each vertex. Cost: linear. Precondition: corners are below
/// introduced_by.size().
inline void find_introducing(std::span<const std::uint32_t> corners,
                             std::span<std::uint32_t> introduced_by) {
  for (std::uint32_t& t : introduced_by) t = CodedSurface::nothing;
  for (std::size_t h = corners.size(); h-- > 0;)
    introduced_by[corners[h]] = static_cast<std::uint32_t>(h / 3);
}

/// Makes corners name vertices of the mesh, where those of the surface are copies: vertex_of[v] is
/// that of v, in numbers that grow with the least copy. Cost: linear.
inline void stitch(std::span<const std::uint32_t> vertex_of, std::span<std::uint32_t> corners,
                   std::vector<std::uint32_t>& introduced_by) {
  for (std::uint32_t& v : corners) v = vertex_of[v];
  if (introduced_by.empty()) return;
  std::uint32_t vertices = 0;
  for (std::uint32_t v = 0; v < vertex_of.size(); ++v) {
    const std::uint32_t t = introduced_by[v], m = vertex_of[v];
    introduced_by[m] = m == vertices ? t : std::min(introduced_by[m], t);
    vertices += m == vertices;
  }
  introduced_by.resize(vertices);
}

/// The memory of one.
struct CodedArrays {
  std::vector<std::uint32_t> corners;
  std::vector<HalfEdge> twins;
  std::vector<std::uint32_t> introduced_by;

  CodedSurface view() const { return {corners, twins, introduced_by}; }
};

}  // namespace clers::internal

#endif

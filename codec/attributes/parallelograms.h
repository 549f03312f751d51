// The parallelograms that end at a vertex, and its walk around it. It knows the surface, but no
// values.
#ifndef CLERS_CODEC_ATTRIBUTES_PARALLELOGRAMS_H
#define CLERS_CODEC_ATTRIBUTES_PARALLELOGRAMS_H

#include <cstdint>

#include "codec/base/portable.h"
#include "codec/connectivity/coded_surface.h"
#include "topology/ids.h"

namespace clers::internal {

/// lnext and lprev of a half-edge without a branch, which would go either way.
CLERS_ALWAYS_INLINE std::uint32_t next_in(std::uint32_t h) {
  return h + 1 - 3 * static_cast<std::uint32_t>(h % 3 == 2);
}
CLERS_ALWAYS_INLINE std::uint32_t previous_in(std::uint32_t h) {
  return h - 1 + 3 * static_cast<std::uint32_t>(h % 3 == 0);
}

/// Where vertex v is in the triangle that introduces it: the half-edge there that leaves v.
/// Precondition: a triangle has v.
inline HalfEdge introducing_corner(const CodedSurface& surface, std::uint32_t v) {
  HalfEdge h = half_edge(Face(surface.introduced_by[v]), 0);
  while (surface.corners[h.index()] != v) h = lnext(h);
  return h;
}

/// Calls visit(h) for each triangle around the vertex that half-edge `first` leaves; h is the
/// half-edge of that triangle that leaves the vertex:
///
///          v
///         / \         .
///     h  /   \        .
///       a-----b       counterclockwise around v from a to b
///
/// Counterclockwise from `first`; where some are beyond the boundary, those clockwise from it
/// follow. Where v has copies, the triangles are those around the copy that `first` leaves.
/// Precondition: twins are there. Cost: linear in what is visited.
template <class Visit>
void for_each_around(const CodedSurface& surface, HalfEdge first, Visit visit) {
  HalfEdge h = first;
  do {
    visit(h);
    h = surface.twins[lprev(h).index()];
  } while (h && h != first);
  if (h) return;
  for (h = surface.twins[first.index()]; h; h = surface.twins[h.index()]) visit(h = lnext(h));
}

/// Calls visit(a, b, c) for each triangle around the vertex v that `first` leaves, in the order of
/// for_each_around, if there is a triangle across from v and known(u) holds for all three vertices
/// u: v is predicted at a + b - c (Touma and Gotsman 1998).
///
///          v
///         / \         .
///        a---b        the side from a to b runs counterclockwise around v
///         \ /
///          c
///
/// Precondition: twins are there. Cost: linear in the triangles around that copy of v.
template <class Known, class Visit>
void for_each_parallelogram(const CodedSurface& surface, HalfEdge first, const Known& known,
                            Visit visit) {
  for_each_around(surface, first, [&](HalfEdge h) {
    const HalfEdge across = surface.twins[lnext(h).index()];
    if (!across) return;
    const std::uint32_t a = surface.corners[lnext(h).index()],
                        b = surface.corners[lprev(h).index()],
                        c = surface.corners[lprev(across).index()];
    if (known(a) && known(b) && known(c)) visit(a, b, c);
  });
}

/// The same where vertices are visited in the order of their introduction: what was introduced
/// before v is known. Where v has copies, the triangles are those around the copy that is
/// introduced first. Precondition: a triangle has v.
template <class Visit>
void for_each_parallelogram(const CodedSurface& surface, std::uint32_t v, Visit visit) {
  for_each_parallelogram(
      surface, introducing_corner(surface, v),
      [&](std::uint32_t u) { return surface.before(u, v); }, visit);
}

}  // namespace clers::internal

#endif

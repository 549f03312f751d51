// The parallelograms that end at a vertex. It knows the surface, but no values.
#ifndef CLERS_CODEC_ATTRIBUTES_PARALLELOGRAMS_H
#define CLERS_CODEC_ATTRIBUTES_PARALLELOGRAMS_H

#include <cstdint>

#include "codec/connectivity/coded_surface.h"
#include "topology/ids.h"

namespace clers::internal {

/// Calls visit(a, b, c) for each triangle around vertex v, counterclockwise from the one that
/// introduces it, if there is a triangle across from v and all three vertices were introduced
/// before: v is predicted at a + b - c (Touma and Gotsman 1998).
///
///          v
///         / \         .
///        a---b        the side from a to b runs counterclockwise around v
///         \ /
///          c
///
/// Where v has copies, the triangles are those around the copy that is introduced first. Where some
/// are beyond the boundary, those clockwise from the first one follow. Preconditions: a triangle
/// has v; twins are there. Cost: linear in the triangles around that copy.
template <class Visit>
void for_each_parallelogram(const CodedSurface& surface, std::uint32_t v, Visit visit) {
  const auto at = [&](HalfEdge h) { return surface.corners[h.index()]; };
  const auto twin = [&](HalfEdge h) { return surface.twins[h.index()]; };
  const auto look = [&](HalfEdge from_v) {
    const HalfEdge across = twin(lnext(from_v));
    if (!across) return;
    const std::uint32_t a = at(lnext(from_v)), b = at(lprev(from_v)), c = at(lprev(across));
    if (surface.before(a, v) && surface.before(b, v) && surface.before(c, v)) visit(a, b, c);
  };
  HalfEdge first = half_edge(Face(surface.introduced_by[v]), 0);
  while (at(first) != v) first = lnext(first);
  HalfEdge h = first;
  do {
    look(h);
    h = twin(lprev(h));
  } while (h && h != first);
  if (h) return;
  for (h = twin(first); h; h = twin(h)) look(h = lnext(h));
}

}  // namespace clers::internal

#endif

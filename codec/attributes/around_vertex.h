// The vertices around one. It knows the surface, and no coordinates.
#ifndef CLERS_CODEC_ATTRIBUTES_AROUND_VERTEX_H
#define CLERS_CODEC_ATTRIBUTES_AROUND_VERTEX_H

#include "codec/base/portable.h"
#include "codec/connectivity/coded_surface.h"
#include "topology/ids.h"

namespace clers::internal {

inline constexpr unsigned most_steps_around = 16;  ///< in either direction
inline constexpr unsigned most_around = 2 * most_steps_around + 1;

/// Calls look(w) for the vertices around v, of which there may be more; of those, once or more
/// often if they are there so often, where triangles are degenerate. Precondition: twins are there.
template <class Look>
CLERS_ALWAYS_INLINE void look_around(const CodedSurface& surface, std::uint32_t v,
                                     const Look& look) {
  if (!surface.has(v)) return;
  const auto at = [&](HalfEdge h) { return surface.corners[h.index()]; };
  HalfEdge first = half_edge(Face(surface.introduced_by[v]), 0);
  while (at(first) != v) first = lnext(first);
  look(at(lnext(first)));
  HalfEdge h = first;
  for (unsigned i = 0; i < most_steps_around; ++i) {
    look(at(lprev(h)));
    h = surface.twins[lprev(h).index()];
    if (h == first) return;
    if (!h) break;
  }
  h = surface.twins[first.index()];
  for (unsigned i = 0; i < most_steps_around && h; ++i) {
    look(at(lprev(h)));
    h = surface.twins[lnext(h).index()];
  }
}

}  // namespace clers::internal

#endif

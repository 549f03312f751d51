// The vertices around one that is coded by parallelograms. It knows the surface, but no values.
#ifndef CLERS_CODEC_ATTRIBUTES_SIZED_AROUND_H
#define CLERS_CODEC_ATTRIBUTES_SIZED_AROUND_H

#include <cstdint>

#include "codec/attributes/parallelograms.h"
#include "codec/base/portable.h"
#include "codec/connectivity/coded_surface.h"
#include "topology/ids.h"

namespace clers::internal {

/// v and, where they are there, those that predict it; v itself in the place of those that are not.
///
///        d-----v-----e
///       / \   / \   / \        .
///      dd  \ /   \ /   ee
///           b-----a
///            \   /
///             \ /
///              c
struct Around {
  std::uint32_t v, a, b, c, d, dd, e, ee;
};

/// v is the vertex that half-edge h leaves; `next` and `previous` are the two after it.
/// Precondition: twins are there.
CLERS_ALWAYS_INLINE Around around(const CodedSurface& surface, std::uint32_t h, std::uint32_t next,
                                  std::uint32_t previous) {
  const std::uint32_t* corner = surface.corners.data();
  const HalfEdge* twin = surface.twins.data();
  const std::uint32_t v = corner[h];
  Around x = {v, corner[next], corner[previous], v, v, v, v, v};
  if (const HalfEdge out = twin[next]) [[likely]]
    x.c = corner[previous_in(out.index())];
  if (const HalfEdge out = twin[previous]) [[likely]] {
    x.d = corner[previous_in(out.index())];
    if (const HalfEdge over = twin[next_in(out.index())]) [[likely]]
      x.dd = corner[previous_in(over.index())];
  }
  if (const HalfEdge in = twin[h]) [[likely]] {
    const std::uint32_t side = previous_in(in.index());
    x.e = corner[side];
    if (const HalfEdge over = twin[side]) [[likely]]
      x.ee = corner[previous_in(over.index())];
  }
  return x;
}

/// The same where no twins are, for corner i of triangle t: by the triangle before, if it has the
/// other two corners.
inline Around around_apart(const CodedSurface& surface, std::uint32_t t, unsigned i) {
  const std::uint32_t* face = surface.corners.data() + 3 * std::size_t(t);
  const std::uint32_t v = face[i], a = face[(i + 1) % 3], b = face[(i + 2) % 3];
  std::uint32_t c = v;
  for (unsigned k = 0; t > 0 && k < 3; ++k) {
    const std::uint32_t *before = face - 3, x = before[(k + 1) % 3], y = before[(k + 2) % 3];
    if ((x == a && y == b) || (x == b && y == a)) c = before[k];
  }
  return {v, a, b, c, v, v, v, v};
}

}  // namespace clers::internal

#endif

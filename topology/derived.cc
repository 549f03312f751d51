// Attach and detach, composed of handle operators (CAGD 2010, §6.4).
#include "topology/derived.h"

namespace CLERS_VISIBLE clers {

Result<Face, Violation> attach(Surface& surface, HalfEdge h, Point apex) {
  if (!surface.is_live(h)) return Failure{Violation{Precondition::live_half_edge, h.index()}};
  if (!surface.is_boundary(h)) return Failure{Violation{Precondition::boundary_edge, h.index()}};
  const Result<Face, Violation> f =
      surface.create(surface.point(surface.dest(h)), surface.point(surface.org(h)), apex);
  if (f) (void)surface.glue(h, half_edge(*f, 0));  // two boundary edges: cannot be refused
  return f;
}

Result<Detached, Violation> detach(Surface& surface, HalfEdge h) {
  if (!surface.is_live(h)) return Failure{Violation{Precondition::live_half_edge, h.index()}};
  Detached done;
  for (const HalfEdge side : {h, lnext(h), lprev(h)}) {
    const HalfEdge twin = surface.sym(side);
    if (!twin) continue;
    done.unglued_[done.count_++] = {*surface.unglue(side), side, twin};
  }
  done.points_ = *surface.destroy(left(h));
  return done;
}

}  // namespace clers

// Which slot of a star goes where, operator by operator.
#include "topology/follow.h"

namespace CLERS_VISIBLE clers {

Change Change::of_flip(const Surface& before, HalfEdge h) {
  const HalfEdge t = before.sym(h);
  Change c;
  c.star(before, h);
  c.star(before, t);
  c.slot(h, h, lprev(t));
  c.slot(lnext(h), lprev(h), lprev(h));
  c.slot(lprev(h), lnext(t), h);
  c.slot(t, t, lprev(h));
  c.slot(lnext(t), lprev(t), lprev(t));
  c.slot(lprev(t), lnext(h), t);
  return c;
}

Change Change::of_split(const Surface& after, HalfEdge h, HalfEdge twin, Vertex v) {
  Change c;
  c.made_ = v;
  for (const HalfEdge side : {h, twin}) {
    if (!side) continue;
    // (v c a) and (v b c), of (a b c).
    const Face f = left(side), fresh = left(after.sym(half_edge(f, 0)));
    for (const Face part : {f, fresh}) {
      c.slots_[c.slot_count_++] = {
          half_edge(part, 0), part == f ? HalfEdge() : side, {side, lnext(side)}, 2};
      c.slot(half_edge(part, 1), part == f ? lprev(side) : lnext(side),
             part == f ? lprev(side) : lnext(side));
      c.slot(half_edge(part, 2), part == f ? side : HalfEdge(), part == f ? side : lprev(side));
    }
    c.parts_[c.part_count_++] = {fresh, f};
    if (side == h) {
      c.between_[c.between_count_++] = after.org(half_edge(f, 2));
      c.between_[c.between_count_++] = after.org(half_edge(fresh, 1));
    }
  }
  return c;
}

Change Change::of_split(const Surface& after, Face f, Vertex v) {
  Change c;
  c.made_ = v;
  Face part = f;
  for (unsigned i = 0; i < 3; ++i) {
    c.slots_[c.slot_count_++] = {
        half_edge(part, 0), HalfEdge(), {half_edge(f, 0), half_edge(f, 1), half_edge(f, 2)}, 3};
    c.slot(half_edge(part, 1), half_edge(f, i), half_edge(f, i));
    c.slot(half_edge(part, 2), HalfEdge(), half_edge(f, (i + 1) % 3));
    if (i != 0) c.parts_[c.part_count_++] = {part, f};
    c.between_[c.between_count_++] = after.org(half_edge(part, 1));
    part = left(after.sym(half_edge(part, 2)));
  }
  return c;
}

Change Change::of_weld(const Surface& before, HalfEdge h) {
  const auto turn = [&](HalfEdge x) { return before.sym(lprev(x)); };
  Change c;
  c.gone_ = before.org(h);
  c.gone_point_ = before.point(c.gone_);
  // On one side of the edge: kept leaves v in (v c a), gone in (v b c). Of what was a-v and v-b,
  // the edge takes after a-v on both sides.
  const auto half = [&](HalfEdge kept, HalfEdge gone, HalfEdge edge) {
    const Face f = left(kept);
    c.slot(half_edge(f, 0), lnext(kept), lnext(kept));
    c.slot(half_edge(f, 1), edge, lprev(kept));
    c.slot(half_edge(f, 2), lnext(gone), lnext(gone));
    c.gone_faces_[c.gone_count_++] = left(gone);
    c.star(before, before.sym(kept));
  };
  if (before.is_boundary(c.gone_)) {
    const HalfEdge first = before.star_half_edge(c.gone_);
    half(turn(first), first, lprev(turn(first)));
  } else if (before.degree(c.gone_) == 4) {
    const HalfEdge d = turn(h), b = turn(d);
    half(turn(b), b, before.sym(h));
    half(d, h, h);
  } else {
    HalfEdge at = h;
    for (unsigned i = 0; i < 3; ++i, at = turn(at)) {
      c.slot(half_edge(left(h), i), lnext(at), lnext(at));
      if (i != 0) c.gone_faces_[c.gone_count_++] = left(at);
      c.star(before, before.sym(at));
    }
  }
  if (before.star_half_edge(c.gone_) != h) c.star(before, before.star_half_edge(c.gone_));
  return c;
}

Change Change::of_turn(Face f) {
  Change c;
  for (unsigned i = 0; i < 3; ++i)
    c.slot(half_edge(f, (i + 1) % 3), half_edge(f, i), half_edge(f, i));
  return c;
}

}  // namespace clers

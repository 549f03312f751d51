// flip, split, weld: another star inside the same rim (§5.2, §6.3); and other numbers in it.
#include "topology/follow.h"
#include "topology/surface.h"

namespace CLERS_VISIBLE clers {

using internal::RingNode;

namespace {

Failure<Violation> violation(Precondition p, std::uint32_t element) {
  return {Violation{p, element}};
}

}  // namespace

/// Moves sides to other half-edges, all at once: what is glued to them, from outside or among
/// themselves, their origins, and the stars they are. Boundary curves do not notice: their nodes
/// are of the origins.
template <std::size_t n>
void Surface::move_rim(const RimSide (&rim)[n]) {
  std::array<HalfEdge, n> twin;
  std::array<Vertex, n> origin;
  std::array<bool, n> star{};
  for (std::size_t i = 0; i < n; ++i) {
    twin[i] = sym(rim[i].from);
    origin[i] = org(rim[i].from);
    star[i] = star_half_edge(origin[i]) == rim[i].from;
  }
  // What they are glued to learns where they go. If that is itself a side it is old, and now
  // names what its new half-edge is to be glued to, as it does if it is glued outside.
  for (std::size_t i = 0; i < n; ++i)
    if (twin[i]) twin_[twin[i].index()] = rim[i].to;
  for (std::size_t i = 0; i < n; ++i) twin[i] = sym(rim[i].from);
  for (std::size_t i = 0; i < n; ++i) {
    const HalfEdge to = rim[i].to;
    org_[to.index()] = origin[i];
    twin_[to.index()] = twin[i];
    if (star[i]) star_[origin[i].index()] = to;
  }
}

/// Both leave one vertex: if the first is its star, the other is it now.
void Surface::replace_star(HalfEdge gone, HalfEdge other) {
  HalfEdge& star = star_[org(gone).index()];
  if (star == gone) star = other;
}

Result<Done, Violation> Surface::flip(HalfEdge h) {
  if (!is_live(h)) return violation(Precondition::live_half_edge, h.index());
  if (is_boundary(h)) return violation(Precondition::interior_edge, h.index());
  const HalfEdge t = sym(h);
  if (left(h) == left(t)) return violation(Precondition::two_faces, h.index());

  if (data_.any()) move_sides(Change::of_flip(*this, h));
  const Vertex a = org(h), b = org(t), c = org(lprev(h)), d = org(lprev(t));
  replace_star(h, lnext(t));
  replace_star(t, lnext(h));
  const RimSide rim[] = {
      {lnext(h), lprev(t)}, {lprev(h), lnext(h)}, {lnext(t), lprev(h)}, {lprev(t), lnext(t)}};
  move_rim(rim);
  org_[h.index()] = d;
  org_[t.index()] = c;
  --corners_[a.index()], --corners_[b.index()];
  ++corners_[c.index()], ++corners_[d.index()];
  return Done{};
}

/// Splits the face left of h for the split of its edge at v: it keeps the part at h's origin, fresh
/// is the part at h's destination. What of h was, on the boundary, is left to the caller.
Face Surface::split_off(HalfEdge h, Face fresh, Vertex v) {
  const Face f = left(h);
  const Vertex a = org(h), c = org(lprev(h));
  const HalfEdge a_v = half_edge(f, 2), c_v = half_edge(fresh, 2);
  component_[fresh.index()] = component(f);
  const bool star = star_half_edge(a) == h;
  if (is_boundary(h)) {
    const RimSide rim[] = {{lnext(h), half_edge(fresh, 1)}, {h, a_v}, {lprev(h), half_edge(f, 1)}};
    move_rim(rim);
  } else {
    const RimSide rim[] = {{lnext(h), half_edge(fresh, 1)}, {lprev(h), half_edge(f, 1)}};
    move_rim(rim);
    if (star) star_[a.index()] = a_v;
  }
  org_[half_edge(f, 0).index()] = org_[half_edge(fresh, 0).index()] = v;
  org_[a_v.index()] = a;
  org_[c_v.index()] = c;
  join(half_edge(f, 0), c_v);
  ++corners_[c.index()];
  return f;
}

Result<Vertex, Violation> Surface::split(HalfEdge h, Point p) {
  if (!is_live(h)) return violation(Precondition::live_half_edge, h.index());
  const HalfEdge t = sym(h);
  if (t && left(h) == left(t)) return violation(Precondition::two_faces, h.index());
  const StellarCase kind = t ? StellarCase::interior_edge : StellarCase::boundary_edge;
  const std::uint32_t more = t ? 2 : 1;
  if (faces_.size() + faces_.growth(more) > max_faces)
    return violation(Precondition::ids_left, max_faces);
  reserve_faces(more);
  reserve_vertices(1);
  if (!t) reserve_nodes(1);

  const Face fresh = new_face(left(h));
  const HalfEdge v_b = half_edge(fresh, 0);
  const Component k = component(left(h));
  Vertex v;
  if (t) {
    const Face fresh_g = new_face(left(t));
    const HalfEdge v_a = half_edge(fresh_g, 0);
    v = new_vertex(v_a, 4, p);
    const Face f = left(h), g = left(t);
    split_off(h, fresh, v);
    split_off(t, fresh_g, v);
    join(half_edge(f, 2), v_a);
    join(half_edge(g, 2), v_b);
  } else {
    const Vertex b = dest(h);
    v = new_vertex(v_b, 2, p);
    split_off(h, fresh, v);
    twin_[v_b.index()] = HalfEdge();
    // Before b.
    const RingNode next = node_[b.index()];
    const Curve c = rings_.curve(rings_.root(next));
    set_node(v, rings_.single());
    name_curve(rings_.join(rings_.rotate(next), node_[v.index()]), c);
  }
  counts_[k.index()] += effect(kind);
  total_ += effect(kind);
  if (data_.any()) move_sides(Change::of_split(*this, h, t, v));
  return v;
}

Result<Vertex, Violation> Surface::split(Face f, Point p) {
  if (!is_live(f)) return violation(Precondition::live_face, f.index());
  if (faces_.size() + faces_.growth(2) > max_faces)
    return violation(Precondition::ids_left, max_faces);
  reserve_faces(2);
  reserve_vertices(1);

  const Vertex corner[3] = {org(half_edge(f, 0)), org(half_edge(f, 1)), org(half_edge(f, 2))};
  const Component k = component(f);
  const Face part[3] = {f, new_face(f), new_face(f)};
  const RimSide rim[] = {{half_edge(f, 0), half_edge(f, 1)},
                         {half_edge(f, 1), half_edge(part[1], 1)},
                         {half_edge(f, 2), half_edge(part[2], 1)}};
  move_rim(rim);
  const Vertex v = new_vertex(half_edge(f, 0), 3, p);
  for (unsigned i = 0; i < 3; ++i) {
    component_[part[i].index()] = k;
    org_[half_edge(part[i], 0).index()] = v;
    org_[half_edge(part[i], 2).index()] = corner[(i + 1) % 3];
    join(half_edge(part[i], 2), half_edge(part[(i + 1) % 3], 0));
    ++corners_[corner[i].index()];
  }
  counts_[k.index()] += effect(StellarCase::face);
  total_ += effect(StellarCase::face);
  if (data_.any()) move_sides(Change::of_split(*this, f, v));
  return v;
}

bool Surface::has_simple_star(Vertex v) const {
  for (const HalfEdge h : fan(v))
    if (org(lnext(h)) == v || org(lprev(h)) == v) return false;
  return true;
}

/// The faces around the vertex are, from h on, (v a d), (v d b), (v b c), (v c a).
Welded Surface::weld_interior_edge(HalfEdge h) {
  const HalfEdge v_d = sym(lprev(h)), v_b = sym(lprev(v_d)), v_c = sym(lprev(v_b));
  const HalfEdge a_v = sym(h), d_v = sym(v_d), b_v = sym(v_b), c_v = sym(v_c);
  const Face f = left(v_c), g = left(v_d), gone_f = left(v_b), gone_g = left(h);
  const HalfEdge a_b = half_edge(f, 1), b_a = half_edge(g, 1);
  const Vertex v = org(h), a = org(a_v), b = org(b_v);
  const Point p = point(v);

  replace_star(d_v, lnext(v_d));
  replace_star(c_v, lnext(v_c));
  --corners_[org(d_v).index()], --corners_[org(c_v).index()];
  const bool star_a = star_half_edge(a) == a_v, star_b = star_half_edge(b) == b_v;
  const RimSide rim[] = {{lnext(v_c), half_edge(f, 0)},
                         {lnext(v_b), half_edge(f, 2)},
                         {lnext(v_d), half_edge(g, 0)},
                         {lnext(h), half_edge(g, 2)}};
  move_rim(rim);
  org_[a_b.index()] = a;
  org_[b_a.index()] = b;
  join(a_b, b_a);
  if (star_a) star_[a.index()] = a_b;
  if (star_b) star_[b.index()] = b_a;
  free_face(gone_g);
  free_face(gone_f);
  free_vertex(v);
  return {StellarCase::interior_edge, a_b, p};
}

/// The faces are (v b c) and (v c a); a-v and v-b are on the boundary.
Welded Surface::weld_boundary_edge(Vertex v) {
  const HalfEdge v_b = star_half_edge(v), v_c = sym(lprev(v_b)), a_v = lprev(v_c), c_v = sym(v_c);
  const Face f = left(v_c), gone = left(v_b);
  const Point p = point(v);

  replace_star(c_v, lnext(v_c));
  --corners_[org(c_v).index()];
  const Curve c = curve(v_b);
  name_curve(rings_.pop_front(rings_.rotate(node_[v.index()])), c);
  const RimSide rim[] = {
      {lnext(v_c), half_edge(f, 0)}, {a_v, half_edge(f, 1)}, {lnext(v_b), half_edge(f, 2)}};
  move_rim(rim);
  free_face(gone);
  free_vertex(v);
  return {StellarCase::boundary_edge, half_edge(f, 1), p};
}

/// The faces around the vertex are, from h on, (v a b), (v b c), (v c a).
Welded Surface::weld_face(HalfEdge h) {
  const Face f = left(h);
  const HalfEdge v_b = sym(lprev(h)), v_c = sym(lprev(v_b));
  const Face gone_b = left(v_b), gone_c = left(v_c);
  const Vertex v = org(h);
  const Point p = point(v);

  for (const HalfEdge from_v : {h, v_b, v_c}) {
    replace_star(sym(from_v), lnext(from_v));
    --corners_[dest(from_v).index()];
  }
  const RimSide rim[] = {
      {lnext(h), half_edge(f, 0)}, {lnext(v_b), half_edge(f, 1)}, {lnext(v_c), half_edge(f, 2)}};
  move_rim(rim);
  free_face(gone_c);
  free_face(gone_b);
  free_vertex(v);
  return {StellarCase::face, half_edge(f, 0), p};
}

std::optional<Violation> Surface::refuse_weld(HalfEdge h) const {
  if (!is_live(h)) return Violation{Precondition::live_half_edge, h.index()};
  const Vertex v = org(h);
  if (degree(v) != 3 && (is_boundary(v) || degree(v) != 4))
    return Violation{Precondition::weld_degree, v.index()};
  if (!has_simple_star(v)) return Violation{Precondition::simple_star, v.index()};
  return std::nullopt;
}

Result<Welded, Violation> Surface::weld(HalfEdge h) {
  if (const auto why = refuse_weld(h)) return Failure{*why};
  const Vertex v = org(h);
  const bool boundary = is_boundary(v);
  room_to_weld();

  if (data_.any()) move_sides(Change::of_weld(*this, h));
  const Component k = component(left(h));
  const Welded done = boundary         ? weld_boundary_edge(v)
                      : degree(v) == 4 ? weld_interior_edge(h)
                                       : weld_face(h);
  counts_[k.index()] -= effect(done.undone);
  total_ -= effect(done.undone);
  return done;
}

Result<Done, Violation> Surface::turn(Face f) {
  if (!is_live(f)) return violation(Precondition::live_face, f.index());
  const RimSide rim[] = {{half_edge(f, 0), half_edge(f, 1)},
                         {half_edge(f, 1), half_edge(f, 2)},
                         {half_edge(f, 2), half_edge(f, 0)}};
  move_rim(rim);
  if (data_.any()) move_sides(Change::of_turn(f));
  return Done{};
}

Result<Done, Violation> Surface::begin_star(HalfEdge h) {
  if (!is_live(h)) return violation(Precondition::live_half_edge, h.index());
  if (is_boundary(org(h))) return violation(Precondition::interior_vertex, org(h).index());
  star_[org(h).index()] = h;
  return Done{};
}

}  // namespace clers

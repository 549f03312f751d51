// glue: identifies two boundary edges (§5.1.1, §6.2).
#include "topology/surface.h"

namespace CLERS_VISIBLE clers {

using internal::RingNode;

/// By the positions of the two on the boundary curves alone: which vertices coincide says nothing.
HandleCase Surface::classify(HalfEdge h0, HalfEdge h1) const {
  if (same_boundary(h0, h1)) {
    const bool after = boundary_next(h0) == h1, before = boundary_next(h1) == h0;
    if (after && before) return HandleCase::close;
    return after || before ? HandleCase::zip : HandleCase::split_curve;
  }
  const bool loops = boundary_next(h0) == h0 && boundary_next(h1) == h1;
  if (component(left(h0)) != component(left(h1)))
    return loops ? HandleCase::join_components_at_loops : HandleCase::join_components;
  return loops ? HandleCase::join_curves_at_loops : HandleCase::join_curves;
}

void Surface::relabel_fan(HalfEdge start, Vertex v) {
  for (HalfEdge h = start; h; h = sym(lprev(h))) org_[h.index()] = v;
}

/// Makes the fans that begin at these boundary half-edges (some may be the same) fans of one
/// vertex, that of the largest, on the point of the first and with its values.
Vertex Surface::merge_fans(std::span<const HalfEdge> starts) {
  const Vertex first = org(starts[0]);
  const Point p = point(first);
  Vertex kept = first;
  for (HalfEdge start : starts)
    if (corner_count(org(start)) > corner_count(kept)) kept = org(start);
  if (kept != first && data_.any()) make_data(kept, first);
  for (HalfEdge start : starts) {
    const Vertex v = org(start);
    if (v == kept) continue;
    relabel_fan(start, kept);
    corners_[kept.index()] += corners_[v.index()];
    free_vertex(v);
  }
  point_[kept.index()] = p;
  return kept;
}

/// Takes the nodes of h0 and h1 off their curves, frees them and links what is left:
///
///     ---p--> . --h0--> . --q-->            p is followed by s, r by q. On two curves that makes
///             .         .                   one; on one curve, h0 q .. r h1 s .. p, it makes two,
///     <--s--- . <--h1-- . <--r--            and either or both may be empty.
void Surface::splice_for_glue(RingNode n0, RingNode n1) {
  const Curve c0 = rings_.curve(rings_.root(n0)), c1 = rings_.curve(rings_.root(n1));
  if (c0 == c1) {
    rings_.rotate(n0);
    const auto [from_h0, from_h1] = rings_.split_before(n1);
    const RingNode between = rings_.pop_front(from_h0), rest = rings_.pop_front(from_h1);
    if (!between && !rest) {
      free_curve(c0);
    } else {
      name_curve(rest ? rest : between, c0);
      if (rest && between) new_curve(between);
    }
  } else {
    const RingNode rest0 = rings_.pop_front(rings_.rotate(n0));
    const RingNode rest1 = rings_.pop_front(rings_.rotate(n1));
    free_curve(c1);
    if (const RingNode joined = rings_.join(rest0, rest1))
      name_curve(joined, c0);
    else
      free_curve(c0);
  }
}

/// Labels all that can be reached from `start`, which has another label.
void Surface::relabel_component(Face start, Component k) {
  std::size_t head = 0, tail = 0;
  const auto visit = [&](Face f) {
    component_[f.index()] = k;
    scratch_[tail++] = f;
  };
  for (visit(start); head < tail;) {
    const Face f = scratch_[head++];
    for (HalfEdge h : star(f))
      if (sym(h) && component(left(sym(h))) != k) visit(left(sym(h)));
  }
}

Result<HandleCase, Violation> Surface::glue(HalfEdge h0, HalfEdge h1) {
  for (HalfEdge h : {h0, h1}) {
    if (!is_live(h)) return Failure{Violation{Precondition::live_half_edge, h.index()}};
    if (!is_boundary(h)) return Failure{Violation{Precondition::boundary_edge, h.index()}};
  }
  if (h0 == h1) return Failure{Violation{Precondition::two_half_edges, h0.index()}};
  const Component k0 = component(left(h0)), k1 = component(left(h1));
  const bool keep0 = counts_[k0.index()].f >= counts_[k1.index()].f;
  const Component kept = keep0 ? k0 : k1, gone_component = keep0 ? k1 : k0;
  vertices_.room_to_give(3);
  rings_.room_to_free(2);
  reserve_curves(1);
  curves_.room_to_give(2);
  components_.room_to_give(1);
  if (k0 != k1) reserve_search(gone_component);

  const HandleCase kind = classify(h0, h1);
  const HalfEdge after0 = boundary_next(h0), after1 = boundary_next(h1);
  const RingNode node0 = node(after0), node1 = node(after1);
  splice_for_glue(node(h0), node(h1));

  // The fans of h0's origin and h1's destination, which begin at h0 and after h1, become one; so do
  // those that begin after h0 and at h1. A curve of one edge makes all of them one.
  Vertex u, w;
  if (after0 == h0 || after1 == h1) {
    u = w = merge_fans(std::array{h0, after1, h1, after0});
  } else {
    u = merge_fans(std::array{h0, after1});
    w = merge_fans(std::array{after0, h1});
  }

  // A vertex stays on the boundary if what followed an edge there is not one of the two itself.
  const auto gone = [&](HalfEdge h) { return h == h0 || h == h1; };
  star_[w.index()] = h1;
  star_[u.index()] = h0;
  node_[w.index()] = node_[u.index()] = RingNode();
  if (!gone(after0)) star_[w.index()] = after0, set_node(w, node0);
  if (!gone(after1)) star_[u.index()] = after1, set_node(u, node1);

  if (k0 == k1) {
    counts_[k0.index()] += effect(kind);
  } else {
    relabel_component(left(keep0 ? h1 : h0), kept);
    counts_[kept.index()] += counts_[gone_component.index()] + effect(kind);
    free_component(gone_component);
  }
  total_ += effect(kind);

  twin_[h0.index()] = h1;
  twin_[h1.index()] = h0;
  return kind;
}

}  // namespace clers

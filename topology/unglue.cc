// unglue: cuts an interior edge (§5.1.2, §6.2).
#include <optional>

#include "topology/surface.h"

namespace CLERS_VISIBLE clers {

using internal::RingNode;

/// Gives every fan that the cut of `cut` and its twin leaves at one vertex a vertex of its own:
/// those that begin, counterclockwise, at these half-edges. The largest keeps the vertex. All are
/// walked in step, so the cost is that of the others.
///
///              ^ starts[0]
///     fan 1    |                 The edge of `cut` is still whole while this runs: a fan ends before
///              |     fan 0       one of its sides, or at the boundary.
///   cut -------v
void Surface::split_fans(std::span<const HalfEdge> starts, HalfEdge cut) {
  const HalfEdge twin = sym(cut);
  struct Walk {
    HalfEdge at;
    std::uint32_t corners = 1;
    bool ended = false;
  };
  std::array<Walk, 3> walks;
  for (std::size_t i = 0; i < starts.size(); ++i) walks[i].at = starts[i];

  std::size_t running = starts.size();
  while (running > 1) {
    for (std::size_t i = 0; i < starts.size() && running > 1; ++i) {
      Walk& walk = walks[i];
      if (walk.ended) continue;
      const HalfEdge side = lprev(walk.at);
      if (is_boundary(side) || side == cut || side == twin) {
        walk.ended = true;
        --running;
      } else {
        walk.at = sym(side);
        ++walk.corners;
      }
    }
  }

  const Vertex whole = org(starts[0]);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (!walks[i].ended) {
      star_[whole.index()] = starts[i];
      continue;
    }
    const Vertex v = new_vertex(starts[i], walks[i].corners, point(whole), whole);
    corners_[whole.index()] -= walks[i].corners;
    HalfEdge h = starts[i];
    for (std::uint32_t n = 0; n < walks[i].corners; ++n, h = sym(lprev(h))) org_[h.index()] = v;
  }
}

/// The six counts of faces that are all of a component. An element is counted where one of its
/// half-edges stands for it: that of a vertex is its star, that of a curve the one at the root.
Characteristic Surface::count(std::span<const Face> part) const {
  Characteristic c;
  c.f = static_cast<std::int64_t>(part.size());
  c.s = 1;
  for (Face f : part) {
    for (HalfEdge h : star(f)) {
      if (star_half_edge(org(h)) == h) ++c.v;
      if (is_boundary(h) || h < sym(h)) ++c.e;
      if (is_boundary(h) && rings_.is_root(node(h))) ++c.b;
    }
  }
  c.g = 1 - (c.euler() + c.b) / 2;
  return c;
}

/// Has the cut between h and t, already made, left two components? Searches from both at once: they
/// meet, or one is exhausted and so is a component, the smaller. Labels and counts that one.
bool Surface::separate(HalfEdge h, HalfEdge t, Component whole) {
  // One array serves both queues, from either end: together they hold each face at most once.
  const std::size_t n = scratch_.size();
  struct Side {
    Component label;
    std::size_t seen = 0, done = 0;
  };
  std::array<Side, 2> sides;
  const auto slot = [&](std::size_t side, std::size_t i) -> Face& {
    return scratch_[side == 0 ? i : n - 1 - i];
  };
  const auto visit = [&](std::size_t side, Face f) {
    component_[f.index()] = sides[side].label;
    slot(side, sides[side].seen++) = f;
  };
  const auto forget = [&](std::size_t side) {
    for (std::size_t i = 0; i < sides[side].seen; ++i) component_[slot(side, i).index()] = whole;
    free_component(sides[side].label);
  };
  // The side that was exhausted; nothing if they met.
  const auto search = [&]() -> std::optional<std::size_t> {
    for (;;) {
      for (std::size_t side = 0; side < 2; ++side) {
        if (sides[side].done == sides[side].seen) return side;
        const Face f = slot(side, sides[side].done++);
        for (HalfEdge e : star(f)) {
          if (is_boundary(e)) continue;
          const Face g = left(sym(e));
          if (component(g) == sides[1 - side].label) return std::nullopt;
          if (component(g) != sides[side].label) visit(side, g);
        }
      }
    }
  };

  if (left(h) == left(t)) return false;
  sides[0].label = new_component();
  sides[1].label = new_component();
  visit(0, left(h));
  visit(1, left(t));
  const std::optional<std::size_t> exhausted = search();
  if (!exhausted) {
    forget(1);
    forget(0);
    return false;
  }

  const std::size_t small = *exhausted;
  forget(1 - small);
  if (small == 1)
    for (std::size_t i = 0, j = n - sides[1].seen; j < n; ++i, ++j) scratch_[i] = scratch_[j];
  const Characteristic part = count(std::span(scratch_).first(sides[small].seen));
  counts_[sides[small].label.index()] = part;
  counts_[whole.index()] -= part;
  return true;
}

Result<HandleCase, Violation> Surface::unglue(HalfEdge h) {
  if (!is_live(h)) return Failure{Violation{Precondition::live_half_edge, h.index()}};
  if (is_boundary(h)) return Failure{Violation{Precondition::interior_edge, h.index()}};
  const HalfEdge t = sym(h);
  const Vertex u = org(h), w = org(t);
  const Component k = component(left(h));
  const bool loop = u == w, u_on_boundary = is_boundary(u), w_on_boundary = is_boundary(w);
  // The boundary half-edges that leave u and w before the cut, if they are on the boundary.
  const HalfEdge q = star_half_edge(u), r = star_half_edge(w);
  const RingNode node_q = node_[u.index()], node_r = node_[w.index()];
  const bool searches = loop || (u_on_boundary && w_on_boundary && same_boundary(q, r));
  reserve_vertices(2);
  reserve_nodes(2);
  reserve_curves(2);
  curves_.room_to_give(1);
  reserve_components(2);
  components_.room_to_give(2);
  if (searches) reserve_search(k);

  if (loop) {
    if (u_on_boundary)
      split_fans(std::array{q, h, t}, h);
    else
      split_fans(std::array{h, t}, h);
  } else {
    if (u_on_boundary)
      split_fans(std::array{q, h}, h);
    else
      star_[u.index()] = h;
    if (w_on_boundary)
      split_fans(std::array{r, t}, h);
    else
      star_[w.index()] = t;
  }
  twin_[h.index()] = HalfEdge();
  twin_[t.index()] = HalfEdge();

  // Each on the boundary leaves another vertex now.
  const RingNode node_h = rings_.single(), node_t = rings_.single();
  if (u_on_boundary) set_node(org(q), node_q);
  if (w_on_boundary) set_node(org(r), node_r);
  set_node(org(h), node_h);
  set_node(org(t), node_t);

  // Curves, and which cases remain: one if `decided`, else that in which the cut separates and that
  // in which it opens a handle.
  HandleCase separating = HandleCase::join_components, otherwise = HandleCase::join_curves;
  bool decided = true;
  if (!u_on_boundary && !w_on_boundary) {
    if (loop) {
      new_curve(node_h);
      new_curve(node_t);
      separating = HandleCase::join_components_at_loops;
      otherwise = HandleCase::join_curves_at_loops;
      decided = false;
    } else {
      new_curve(rings_.join(node_h, node_t));
      otherwise = HandleCase::close;
    }
  } else if (u_on_boundary != w_on_boundary) {
    // Arrive at the boundary vertex, go along one side of the cut, come back along the other.
    const RingNode next = u_on_boundary ? node_q : node_r;
    const Curve c = rings_.curve(rings_.root(next));
    const RingNode slit = u_on_boundary ? rings_.join(node_h, node_t) : rings_.join(node_t, node_h);
    name_curve(rings_.join(rings_.rotate(next), slit), c);
    otherwise = HandleCase::zip;
  } else if (loop) {
    // The fan between the two ends of the loop is closed by one side alone, which is a curve now;
    // the other side is where the boundary passed the vertex.
    const bool h_inside = org(h) == dest(h);
    const Curve c = curve(q);
    name_curve(rings_.join(rings_.rotate(node_q), h_inside ? node_t : node_h), c);
    new_curve(h_inside ? node_h : node_t);
    decided = false;
  } else if (same_boundary(q, r)) {
    // q .. (to w) r .. (to u): h takes the boundary from u to r, t takes it from w to q.
    const Curve c = curve(q);
    rings_.rotate(node_q);
    const auto [from_q, from_r] = rings_.split_before(node_r);
    name_curve(rings_.join(from_r, node_h), c);
    new_curve(rings_.join(from_q, node_t));
    decided = false;
  } else {
    const Curve c = curve(q);
    free_curve(curve(r));
    const RingNode to_w = rings_.join(rings_.rotate(node_q), node_h);
    name_curve(rings_.join(to_w, rings_.join(rings_.rotate(node_r), node_t)), c);
    otherwise = HandleCase::split_curve;
  }

  HandleCase kind = otherwise;
  if (!decided) {
    // On a component of genus 0 every such cut separates, and the search never meets itself.
    counts_[k.index()] -= effect(separating);
    if (separate(h, t, k))
      kind = separating;
    else
      counts_[k.index()] += effect(separating) - effect(otherwise);
  } else {
    counts_[k.index()] -= effect(kind);
  }
  total_ -= effect(kind);
  return kind;
}

}  // namespace clers

// Operators composed of stellar ones (Topological mesh operators, §5.2.4 and §6.4).
//
// Each takes an observer last (follow.h), which is called for every flip, split and weld.
#ifndef CLERS_TOPOLOGY_STELLAR_H
#define CLERS_TOPOLOGY_STELLAR_H

#include <optional>

#include <clers/topology/export.h>
#include <clers/topology/follow.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// Is the edge's link all that the links of its ends have in common, the boundary counting as one
/// more vertex that closes every curve (Dey, Edelsbrunner)? If it is, contracting the edge changes
/// no topology and makes no two edges between two vertices. Read so where a surface is no
/// simplicial complex: the ends differ, and no two edges from them arrive at one vertex but in the
/// edge's faces. Precondition: h is live. Cost: O(degree(org(h)) * degree(dest(h))).
bool link_condition(const Surface& surface, HalfEdge h);

/// Why an edge cannot be collapsed, or nothing.
std::optional<Violation> refuse_collapse(const Surface& surface, HalfEdge h);
/// Why remove(v, degree, ..) is not possible, or nothing.
std::optional<Violation> refuse_remove(const Surface& surface, Vertex v, std::uint32_t degree);
/// Why split_vertex is not possible, or nothing.
std::optional<Violation> refuse_split_vertex(const Surface& surface, HalfEdge from, HalfEdge to);

/// 0 if the flip of h joins two vertices that no edge joins yet, else 1. With this cost, remove
/// keeps a simplicial complex one where it can: on a sphere always, since one of any two flips that
/// follow each other around the vertex costs 0. Cost: the lower degree of the two vertices that
/// oppose h.
int doubles_an_edge(const Surface& surface, HalfEdge h);

/// Removes a vertex: flips edges of its star until it has `degree` of them, then welds it. The edge
/// that is flipped each time is the interior one with the least cost(surface, h), where h leaves
/// the vertex; the first of equals. The weld is the surface's: of degree 4 through the star
/// half-edge. A cost may be the aspect ratios of the triangles that the flip would make (§6.4).
///
/// Preconditions: `live_vertex`, `simple_star`, `weld_degree`: `degree` is 3, or 4 inside, and the
/// vertex has as many edges or more. Effect on (v,e,f,b,g,s): the negative of the split's that the
/// weld undoes: (-1,-3,-2,0,0,0), or of a vertex on the boundary (-1,-2,-1,0,0,0). Inverse: the
/// split that Welded names, then the flips. Cost: O(1) flips and calls of `cost` for each edge
/// above `degree`, times the edges. Ids: as flip and weld say.
template <class Cost, class Observer = NoObserver>
Result<Welded, Violation> remove(Surface& surface, Vertex v, std::uint32_t degree, Cost&& cost,
                                 Observer&& observer = {}) {
  if (const auto why = refuse_remove(surface, v, degree)) return Failure{*why};
  surface.reserve(0, 0);  // the weld must not fail when the flips are done
  while (surface.degree(v) > degree) {
    HalfEdge best;
    decltype(cost(surface, best)) least{};
    for (const HalfEdge h : surface.fan(v)) {
      if (surface.is_boundary(h)) continue;
      const auto price = cost(surface, h);
      if (best && !(price < least)) continue;
      best = h, least = price;
    }
    (void)flip(surface, best, observer);
  }
  return weld(surface, surface.star_half_edge(v), observer);
}
inline Result<Welded, Violation> remove(Surface& surface, Vertex v, std::uint32_t degree) {
  return remove(surface, v, degree, doubles_an_edge);
}

/// Contracts an edge: its origin is merged into its destination, its faces vanish (Fig. 12). Flips
/// hand the origin's edges over one by one; a weld takes the last three, or those on the boundary.
///
///        x2 __ x1           x2 __ x1
///        / \  / \           / _/ / \         Merged into the vertex on the boundary, if only the
///      x3--u-----w    ->  x3--------w        origin is on it.
///        \ /  \ /           \ _\ \ /
///        x4 -- x5           x4 -- x5
///
/// Preconditions: `live_half_edge`, `link_condition`. Effect: (-1,-3,-2,0,0,0), of an edge on the
/// boundary (-1,-2,-1,0,0,0). Inverse: split_vertex, up to ids. Cost: O(degree) flips besides
/// link_condition. Ids: those of the vertex that is merged and of the faces that vanish are
/// freed; which faces keep theirs follows from the flips. Returns the vertex that stays.
template <class Observer = NoObserver>
Result<Vertex, Violation> collapse(Surface& surface, HalfEdge h, Observer&& observer = {}) {
  if (const auto why = refuse_collapse(surface, h)) return Failure{*why};
  surface.reserve(0, 0);  // the weld must not fail when the flips are done
  if (surface.is_boundary(surface.org(h)) && !surface.is_boundary(surface.dest(h)))
    h = surface.sym(h);
  const Vertex u = surface.org(h), w = surface.dest(h);
  // An ear has no edge to hand over: it gets one.
  if (surface.degree(u) == 2) (void)flip(surface, lnext(h), observer);
  while (surface.degree(u) > 3) {
    const HalfEdge next = surface.sym(lprev(h));
    (void)flip(surface, next, observer);
    h = lprev(next);  // the edge, turned along with the rim
  }
  (void)weld(surface, surface.star_half_edge(u), observer);
  return w;
}

/// Makes two vertices of one, w, and an edge between them: the inverse of collapse. The new vertex,
/// on point p, gets the corners of w counterclockwise from `from` to `to`, two half-edges that
/// leave w; or, if `to` is null, to the boundary.
///
///           d                  d
///      \    |    /        \   / \   /        A split of an edge, or of the face if it is one
///        -- w --     ->     -u---w-          corner, then flips. The new faces are u, w and
///      /    |    \        /   \ /   \        what `from` and `to` lead to, c and d.
///           c                  c             .
///
/// Preconditions: `live_half_edge`, `leave_one_vertex` (and `to` comes after `from`, before the
/// boundary), `two_half_edges`, `simple_star`, `ids_left`. Effect: (1,3,2,0,0,0), with `to` null
/// (1,2,1,0,0,0). Inverse: collapse of the half-edge returned, which leads from the new vertex to
/// w. Cost: O(corners given) flips, besides O(degree(w)). Ids: all stay valid.
template <class Observer = NoObserver>
Result<HalfEdge, Violation> split_vertex(Surface& surface, HalfEdge from, HalfEdge to, Point p,
                                         Observer&& observer = {}) {
  if (const auto why = refuse_split_vertex(surface, from, to)) return Failure{*why};
  const Vertex w = surface.org(from);
  std::uint32_t corners = 0;
  HalfEdge last = from;  // of the corners
  for (HalfEdge h = from; h && h != to; h = surface.sym(lprev(h))) last = h, ++corners;

  if (!to) {
    // Between w and what was before it on the boundary, then back to `from`.
    const HalfEdge before = lprev(last);
    const Result<Vertex, Violation> u = split(surface, before, p, observer);
    if (!u) return Failure{u.error()};
    HalfEdge edge = lnext(surface.star_half_edge(*u));
    for (; corners > 1; --corners) {
      (void)flip(surface, edge, observer);
      edge = lprev(edge);
    }
    return surface.star_half_edge(*u);
  }
  Vertex u;
  if (corners == 1) {
    const Result<Vertex, Violation> made = split(surface, left(from), p, observer);
    if (!made) return Failure{made.error()};
    u = *made;
  } else {
    const HalfEdge second = surface.sym(lprev(from));
    const Face f = left(second);
    const Result<Vertex, Violation> made = split(surface, second, p, observer);
    if (!made) return Failure{made.error()};
    u = *made;
    HalfEdge side = half_edge(f, 1);  // arrives at w, the last that u has not got
    for (; corners > 2; --corners) {
      const HalfEdge edge = surface.sym(side);
      (void)flip(surface, edge, observer);
      side = lnext(edge);
    }
  }
  for (const HalfEdge h : surface.fan(u))
    if (surface.dest(h) == w) return h;
  return surface.star_half_edge(u);  // not reached: w is in the link of u
}

}  // namespace clers

#endif

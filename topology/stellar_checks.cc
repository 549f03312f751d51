// The preconditions of operators composed of stellar ones.
#include "topology/stellar.h"

namespace CLERS_VISIBLE clers {
namespace {

bool adjacent(const Surface& s, Vertex a, Vertex b) {
  if (s.degree(b) < s.degree(a)) std::swap(a, b);
  for (const Vertex x : s.adjacent_vertices(a))
    if (x == b) return true;
  return false;
}

}  // namespace

bool link_condition(const Surface& s, HalfEdge h) {
  const HalfEdge t = s.sym(h);
  const Vertex u = s.org(h), w = s.dest(h);
  if (u == w) return false;
  if (t) {
    // Two faces oppose it with two vertices; and a curve through both ends would be pinched.
    if (s.org(lprev(h)) == s.org(lprev(t))) return false;
    if (s.is_boundary(u) && s.is_boundary(w)) return false;
  } else if (s.is_boundary(lnext(h)) && s.is_boundary(lprev(h))) {
    return false;  // a triangle alone
  }
  for (const HalfEdge p : s.star(u)) {
    if (s.same_edge(p, h)) continue;
    const Vertex x = s.other_end(p, u);
    if (x == u || x == w) return false;
    for (const HalfEdge q : s.star(w)) {
      if (s.other_end(q, w) != x) continue;
      const bool beside_h = s.same_edge(p, lprev(h)) && s.same_edge(q, lnext(h));
      const bool beside_t = t && s.same_edge(p, lnext(t)) && s.same_edge(q, lprev(t));
      if (!beside_h && !beside_t) return false;
    }
  }
  // An edge that faces of both ends share, as in a tetrahedron.
  for (const HalfEdge rim : s.link(u))
    if (s.sym(rim) && s.org(lprev(s.sym(rim))) == w) return false;
  return true;
}

std::optional<Violation> refuse_collapse(const Surface& s, HalfEdge h) {
  if (!s.is_live(h)) return Violation{Precondition::live_half_edge, h.index()};
  if (!link_condition(s, h)) return Violation{Precondition::link_condition, h.index()};
  return std::nullopt;
}

std::optional<Violation> refuse_remove(const Surface& s, Vertex v, std::uint32_t degree) {
  if (!s.is_live(v)) return Violation{Precondition::live_vertex, v.index()};
  if (!s.has_simple_star(v)) return Violation{Precondition::simple_star, v.index()};
  const bool possible = degree == 3 || (degree == 4 && !s.is_boundary(v));
  if (!possible || s.degree(v) < degree) return Violation{Precondition::weld_degree, v.index()};
  return std::nullopt;
}

std::optional<Violation> refuse_split_vertex(const Surface& s, HalfEdge from, HalfEdge to) {
  if (!s.is_live(from)) return Violation{Precondition::live_half_edge, from.index()};
  if (to && !s.is_live(to)) return Violation{Precondition::live_half_edge, to.index()};
  if (from == to) return Violation{Precondition::two_half_edges, from.index()};
  const Vertex w = s.org(from);
  if (!s.has_simple_star(w)) return Violation{Precondition::simple_star, w.index()};
  // Counterclockwise from `from`: `to`, or the boundary and so null, or `from` again.
  HalfEdge h = from;
  do {
    h = s.sym(lprev(h));
  } while (h && h != to && h != from);
  if (h != to) return Violation{Precondition::leave_one_vertex, to ? to.index() : from.index()};
  return std::nullopt;
}

int doubles_an_edge(const Surface& s, HalfEdge h) {
  return adjacent(s, s.org(lprev(h)), s.org(lprev(s.sym(h)))) ? 1 : 0;
}

}  // namespace clers

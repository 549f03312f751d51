// Steps of collapse, split_vertex and remove, judged by the triangles.
#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

#include "topology/dump.h"
#include "topology/test/pair.h"

namespace clers::test {
namespace {

/// A triangle: its vertices, the least of three rotations.
using Triple = std::array<Vertex, 3>;
using Triples = std::multiset<Triple>;
Triple least(Triple t) {
  const Triple once{t[1], t[2], t[0]}, twice{t[2], t[0], t[1]};
  return std::min({t, once, twice});
}
template <class Rename>
Triples triples(const Surface& s, Rename rename) {
  Triples out;
  for (const Face f : s.faces()) {
    Triple t;
    for (unsigned i = 0; i < 3; ++i) t[i] = rename(s.org(half_edge(f, i)));
    out.insert(least(t));
  }
  return out;
}
Triples triples(const Surface& s) {
  return triples(s, [](Vertex v) { return v; });
}
void erase(Triples& from, const Triple& t) {
  if (const auto at = from.find(least(t)); at != from.end()) from.erase(at);
}

}  // namespace

/// By sets of vertices, the boundary being one more: no other way to say what cannot be undone.
bool Pair::may_collapse(HalfEdge h) const {
  const Surface& s = surface_;
  const Vertex u = s.org(h), w = s.dest(h), beyond;
  if (u == w) return false;
  const auto link = [&](Vertex v) {
    std::multiset<Vertex> out;
    for (const HalfEdge x : s.star(v)) out.insert(s.org(x) == v ? s.dest(x) : s.org(x));
    if (s.is_boundary(v)) out.insert(beyond);
    return out;
  };
  const std::multiset<Vertex> link_u = link(u), link_w = link(w);
  std::multiset<Vertex> link_edge{s.org(lprev(h)), s.sym(h) ? s.org(lprev(s.sym(h))) : beyond};
  if (*link_edge.begin() == *link_edge.rbegin()) return false;
  if (link_u.count(u) != 0 || link_u.count(w) != 1) return false;
  for (const Vertex x : link_u) {
    if (x == w || link_w.count(x) == 0) continue;  // a loop of w may stay
    if (link_edge.count(x) == 0) return false;
    if (x != beyond && link_u.count(x) * link_w.count(x) > 1) return false;
  }
  // A common edge of the links: one face beyond, or the boundary.
  for (const HalfEdge rim : s.link(u))
    if (s.sym(rim) && s.org(lprev(s.sym(rim))) == w) return false;
  return s.sym(h) || !s.is_boundary(lnext(h)) || !s.is_boundary(lprev(h));
}

std::string Pair::collapse(HalfEdge h) {
  const bool allowed = surface_.is_live(h) && may_collapse(h);
  const std::string text = thorough_ ? dump(surface_) : "";
  const Characteristic before = surface_.characteristic();
  Vertex u, w;
  bool boundary = false;
  Triples expected;
  if (allowed) {
    boundary = surface_.is_boundary(h);
    u = surface_.org(h), w = surface_.dest(h);
    if (surface_.is_boundary(u) && !surface_.is_boundary(w)) std::swap(u, w);
    if (thorough_) {
      expected = triples(surface_, [&](Vertex v) { return v == u ? w : v; });
      for (const HalfEdge x : surface_.star(h)) erase(expected, {w, w, surface_.org(lprev(x))});
    }
  }
  const auto kept = clers::collapse(surface_, h);
  if (kept.ok() != allowed) return "collapse of " + std::to_string(h.index()) + " misjudged";
  if (!kept) return refuse(text);
  ++done_, ++composed_[0];
  oracle_.adopt(surface_);
  if (*kept != w || surface_.is_live(u)) return "collapse kept the wrong vertex";
  const auto kind = boundary ? StellarCase::boundary_edge : StellarCase::interior_edge;
  if (surface_.characteristic() != before - effect(kind)) return "wrong effect of collapse";
  if (thorough_ && triples(surface_) != expected) return "collapse made other triangles";
  return "";
}

std::string Pair::split_vertex(const Op& op) {
  const HalfEdge from = pick(op.choice % 3 == 0);
  HalfEdge to;
  if (surface_.is_live(from) && op.choice % 4 != 0) {
    to = from;
    for (std::uint32_t i = random(4) + 1; i > 0 && to; --i) to = surface_.sym(lprev(to));
  }
  if (op.choice % 16 == 1) to = pick(false);
  bool allowed = surface_.is_live(from) && (!to || surface_.is_live(to)) && from != to;
  std::set<Face> given;
  if (allowed) {
    allowed = simple_star(surface_.org(from));
    HalfEdge h = from;
    do {
      given.insert(left(h));
      h = surface_.sym(lprev(h));
    } while (h && h != to && h != from);
    allowed = allowed && h == to;
  }
  const std::string text = thorough_ ? dump(surface_) : "";
  const Characteristic before = surface_.characteristic();
  const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
  const auto edge = clers::split_vertex(surface_, from, to, Point(op.b));
  if (edge.ok() != allowed) return "split_vertex misjudged";
  if (!edge) return refuse(text);
  ++done_, ++composed_[1];
  oracle_.adopt(surface_);
  const auto kind = to ? StellarCase::interior_edge : StellarCase::boundary_edge;
  if (surface_.characteristic() != before + effect(kind)) return "wrong effect of split_vertex";
  if (old) {
    const Vertex u = surface_.org(*edge), w = surface_.dest(*edge);
    if (u == w || old->is_live(u) != false || surface_.point(u) != Point(op.b))
      return "split_vertex made another vertex";
    Triples expected;
    for (const Face f : old->faces()) {
      Triple t;
      for (unsigned i = 0; i < 3; ++i) {
        t[i] = old->org(half_edge(f, i));
        if (t[i] == w && given.count(f) != 0) t[i] = u;
      }
      expected.insert(least(t));
    }
    Triples made = triples(surface_);
    for (const HalfEdge x : surface_.star(*edge))
      erase(made, {surface_.org(x), surface_.dest(x), surface_.org(lprev(x))});
    if (made != expected) return "split_vertex made other triangles";
    Surface undone = surface_;
    if (const auto kept = clers::collapse(undone, *edge)) {
      if (*kept != w) return "collapse kept the wrong vertex";
      if (triples(undone) != triples(*old)) return "collapse does not undo split_vertex";
      return compare(undone, *old, "collapse does not undo split_vertex");
    }
  }
  return "";
}

std::string Pair::remove(const Op& op) {
  const HalfEdge h = pick(op.choice % 3 == 0);
  const bool live = surface_.is_live(h);
  const Vertex v = live ? surface_.org(h) : Vertex(surface_.vertex_limit() + 1);
  const std::uint32_t degree = op.choice % 5 == 0 ? op.choice % 7 : 3 + op.choice % 2;
  const bool boundary = live && surface_.is_boundary(v);
  const bool allowed = live && simple_star(v) && (degree == 3 || (degree == 4 && !boundary)) &&
                       surface_.degree(v) >= degree;
  const std::string text = thorough_ ? dump(surface_) : "";
  const Characteristic before = surface_.characteristic();
  Triples kept;
  if (thorough_) kept = triples(surface_);
  if (thorough_ && live)
    for (const HalfEdge x : surface_.fan(v))
      erase(kept, {surface_.org(x), surface_.dest(x), surface_.org(lprev(x))});
  const auto price = [&](const Surface& s, HalfEdge x) {
    return (s.dest(x).index() * 2654435761u) ^ op.b;
  };
  const auto done = op.choice % 2 == 0 ? clers::remove(surface_, v, degree)
                                       : clers::remove(surface_, v, degree, price);
  if (done.ok() != allowed) return "remove misjudged";
  if (!done) return refuse(text);
  ++done_, ++composed_[2];
  oracle_.adopt(surface_);
  if (surface_.characteristic() != before - effect(done->undone)) return "wrong effect of remove";
  if (surface_.is_live(v)) return "the removed vertex is alive";
  if (!thorough_) return "";
  const Triples now = triples(surface_);
  if (!std::includes(now.begin(), now.end(), kept.begin(), kept.end()))
    return "remove changed triangles elsewhere";
  return "";
}

}  // namespace clers::test

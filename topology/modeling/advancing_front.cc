// How a front grows, and what keeps it a manifold.
#include "topology/modeling/advancing_front.h"

#include <algorithm>

#include "topology/derived.h"

namespace CLERS_VISIBLE clers {

/// Each fan once, by its vertex, the youngest first.
template <class Visit>
void AdvancingFront::for_each_fan(Point p, Visit&& visit) const {
  std::array<Vertex, max_fans> seen;
  unsigned count = 0;
  for (HalfEdge h = corner_at_[p.index()]; h; h = next_corner_[h.index()]) {
    const Vertex v = surface_.org(h);
    if (std::find(seen.begin(), seen.begin() + count, v) != seen.begin() + count) continue;
    seen[count++] = v;
    visit(v);
  }
}

bool AdvancingFront::has_edge(Point from, Point to) const {
  bool found = false;
  for_each_fan(from, [&](Vertex v) {
    for (const HalfEdge h : surface_.fan(v)) found |= destination(h) == to;
  });
  return found;
}

std::optional<HalfEdge> AdvancingFront::boundary_edge(Point from, Point to) const {
  std::optional<HalfEdge> found;
  for_each_fan(from, [&](Vertex v) {
    const HalfEdge h = surface_.star_half_edge(v);
    if (surface_.is_boundary(h) && destination(h) == to) found = h;
  });
  return found;
}

std::optional<AdvancingFront::Fit> AdvancingFront::fit(HalfEdge h, Point c) const {
  const Point a = origin(h), b = destination(h);
  if (c == a || c == b) return {};
  Fit fit;
  if (!is_used(c)) return fit;
  unsigned fans = 0;
  bool inside = false;
  for_each_fan(c, [&](Vertex v) {
    ++fans;
    inside |= !surface_.is_boundary(v);
  });
  if (inside || has_edge(a, c) || has_edge(c, b)) return {};
  if (const auto g = boundary_edge(c, a)) fit.after = *g;
  if (const auto g = boundary_edge(b, c)) fit.before = *g;
  if (!fit.after && !fit.before && fans == max_fans) return {};
  return fit;
}

void AdvancingFront::add_corner(HalfEdge h) {
  // The list is made anew without what merged, so that it stays short.
  const Point p = origin(h);
  std::array<HalfEdge, max_fans + 1> kept{h};
  unsigned count = 1;
  for (HalfEdge g = corner_at_[p.index()]; g; g = next_corner_[g.index()]) {
    const auto same = [&](HalfEdge k) { return surface_.org(k) == surface_.org(g); };
    if (std::none_of(kept.begin(), kept.begin() + count, same)) kept[count++] = g;
  }
  next_corner_.resize(surface_.half_edge_limit());
  corner_at_[p.index()] = h;
  for (unsigned i = 0; i < count; ++i)
    next_corner_[kept[i].index()] = i + 1 < count ? kept[i + 1] : HalfEdge();
}

std::optional<Face> AdvancingFront::new_front(Point a, Point b, Point c) {
  if (!is_apart(a, b, c)) return {};
  const auto f = surface_.create(a, b, c);
  if (!f) return {};
  for (unsigned i = 0; i < 3; ++i) add_corner(half_edge(*f, i));
  return *f;
}

std::optional<Face> AdvancingFront::attach(HalfEdge h, Point c) {
  if (!is_candidate(h)) return {};
  const auto where = fit(h, c);
  if (!where) return {};
  const auto f = clers::attach(surface_, h, c);
  if (!f) return {};
  // Boundary edges both, of two triangles: never refused.
  if (where->after) (void)surface_.glue(where->after, half_edge(*f, 1));
  if (where->before) (void)surface_.glue(where->before, half_edge(*f, 2));
  add_corner(half_edge(*f, 2));
  return *f;
}

void AdvancingFront::remove_fan(Vertex v) {
  std::vector<Face> faces;
  for (const HalfEdge h : surface_.fan(v)) faces.push_back(left(h));
  for (const Face f : faces) (void)detach(surface_, f);
}

std::size_t AdvancingFront::part_fans() {
  const std::int64_t before = surface_.characteristic().f;
  // Faces that go may part a fan elsewhere: again until none is left.
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<Vertex> widest(corner_at_.size());
    std::vector<Vertex> gone;
    for (const Vertex v : surface_.vertices()) {
      Vertex& w = widest[surface_.point(v).index()];
      if (!w) {
        w = v;
      } else if (surface_.corner_count(v) > surface_.corner_count(w)) {
        gone.push_back(w);
        w = v;
      } else {
        gone.push_back(v);
      }
    }
    // Ids may be given anew while faces go, so each is looked at before: the fan of a vertex that
    // another removal changed waits for the next round.
    std::vector<HalfEdge> corners;
    for (const Vertex v : gone) corners.push_back(surface_.star_half_edge(v));
    for (std::size_t i = 0; i < gone.size(); ++i)
      if (surface_.is_live(corners[i])) remove_fan(surface_.org(corners[i]));
    changed = !gone.empty();
  }
  // The lists of corners, by what is left.
  std::fill(corner_at_.begin(), corner_at_.end(), HalfEdge());
  std::fill(next_corner_.begin(), next_corner_.end(), HalfEdge());
  for (const Vertex v : surface_.vertices())
    corner_at_[surface_.point(v).index()] = surface_.star_half_edge(v);
  return static_cast<std::size_t>(before - surface_.characteristic().f);
}

}  // namespace clers

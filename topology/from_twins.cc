// A whole surface from arrays, checked.
#include <optional>

#include "topology/surface.h"

namespace CLERS_VISIBLE clers {
namespace {

Failure<Fault> fault(Invariant i, std::size_t element) {
  return {Fault{i, static_cast<std::uint32_t>(element)}};
}

/// Are the arrays triangles glued along edges? Each invariant everywhere before the next, which may
/// rely on it.
std::optional<Fault> check_gluing(std::span<const Vertex> org, std::span<const HalfEdge> twin,
                                  std::uint32_t vertex_count) {
  const auto n = static_cast<std::uint32_t>(org.size());
  const auto everywhere = [n](Invariant invariant, auto holds) -> std::optional<Fault> {
    for (std::uint32_t i = 0; i < n; ++i)
      if (!holds(HalfEdge(i))) return Fault{invariant, i};
    return std::nullopt;
  };
  const auto org_of = [org](HalfEdge h) { return org[h.index()]; };
  const auto twin_of = [twin](HalfEdge h) { return twin[h.index()]; };

  auto fault = everywhere(Invariant::origin_is_live, [&](HalfEdge h) {
    const bool dead = !org_of(half_edge(left(h), 0));
    return dead ? !org_of(h) : org_of(h).index() < vertex_count;
  });
  if (fault) return fault;
  fault = everywhere(Invariant::twin_in_range, [&](HalfEdge h) {
    const HalfEdge t = twin_of(h);
    return !t || (org_of(h) && t.index() < n && org_of(t));
  });
  if (fault) return fault;
  fault = everywhere(Invariant::twin_is_mutual, [&](HalfEdge h) {
    const HalfEdge t = twin_of(h);
    return !t || (t != h && twin_of(t) == h);
  });
  if (fault) return fault;
  return everywhere(Invariant::twin_is_opposite, [&](HalfEdge h) {
    const HalfEdge t = twin_of(h);
    return !t || (org_of(t) == org_of(lnext(h)) && org_of(lnext(t)) == org_of(h));
  });
}

}  // namespace

/// Labels the components and counts them; the rest of the surface is complete.
void Surface::find_components() {
  scratch_.resize(faces_.size());
  for (std::uint32_t i = 0; i < faces_.size(); ++i) {
    const Face f(i);
    if (!org(half_edge(f, 0)) || component(f)) continue;
    reserve_components(1);
    const Component k = new_component();
    relabel_component(f, k);
    counts_[k.index()].s = 1;
  }
  std::vector<Face>().swap(scratch_);
  for (std::uint32_t i = 0; i < org_.size(); ++i) {
    const HalfEdge h(i);
    if (!org(h)) continue;
    Characteristic& c = counts_[component(left(h)).index()];
    if (corner(h) == 0) ++c.f;
    if (star_half_edge(org(h)) == h) ++c.v;
    if (is_boundary(h) || h < sym(h)) ++c.e;
  }
  for (const Curve c : curves()) ++counts_[component(left(on_curve(c))).index()].b;
  for (Characteristic& c : counts_) {
    c.g = 1 - (c.euler() + c.b) / 2;
    total_ += c;
  }
}

Result<Surface, Fault> Surface::from_twins(std::span<const Vertex> org,
                                           std::span<const HalfEdge> twin,
                                           std::uint32_t vertex_count,
                                           std::span<const Point> points) {
  if (org.size() % 3 != 0 || org.size() / 3 > max_faces)
    return fault(Invariant::array_sizes, org.size());
  if (twin.size() != org.size()) return fault(Invariant::array_sizes, twin.size());
  if (!points.empty() && points.size() != vertex_count)
    return fault(Invariant::array_sizes, points.size());
  if (vertex_count == Vertex::null_index) return fault(Invariant::array_sizes, vertex_count);
  if (const auto wrong = check_gluing(org, twin, vertex_count)) return Failure{*wrong};

  Surface s;
  const auto face_count = static_cast<std::uint32_t>(org.size() / 3);
  s.org_.assign(org.begin(), org.end());
  s.twin_.assign(twin.begin(), twin.end());
  s.component_.resize(face_count);
  s.star_.resize(vertex_count);
  s.corners_.resize(vertex_count);
  s.point_.resize(vertex_count);
  s.node_.resize(vertex_count);
  s.faces_.fill(face_count);
  s.vertices_.fill(vertex_count);

  // The star of a vertex: its half-edge on the boundary if there is one, else the first.
  for (std::uint32_t i = 0; i < org.size(); ++i) {
    if (!org[i]) continue;
    const std::uint32_t v = org[i].index();
    HalfEdge& star = s.star_[v];
    if (!star || (s.is_boundary(HalfEdge(i)) && !s.is_boundary(star))) star = HalfEdge(i);
    ++s.corners_[v];
  }
  // One fan from there must be all corners. The walk ends at the boundary or where it began:
  // twins are mutual, so every step has one step back.
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    if (!s.star_[v]) continue;
    s.point_[v] = points.empty() ? Point(v) : points[v];
    std::uint32_t corners = 0;
    HalfEdge h = s.star_[v];
    do {
      ++corners;
      h = s.sym(lprev(h));
    } while (h && h != s.star_[v]);
    if (corners != s.corners_[v]) return fault(Invariant::one_fan, v);
  }

  std::uint32_t on_boundary = 0;
  for (const HalfEdge star : s.star_)
    if (star && s.is_boundary(star)) ++on_boundary;
  s.reserve_nodes(on_boundary);
  for (std::uint32_t v = 0; v < vertex_count; ++v)
    if (s.star_[v] && s.is_boundary(s.star_[v])) s.set_node(Vertex(v), s.rings_.single());
  for (std::uint32_t i = 0; i < org.size(); ++i) {
    const HalfEdge start(i);
    if (!org[i] || !s.is_boundary(start) || s.curve(start)) continue;
    internal::RingNode tree;
    HalfEdge h = start;
    do {
      tree = s.rings_.join(tree, s.node(h));
      h = s.boundary_next(h);
    } while (h != start);
    s.reserve_curves(1);
    s.new_curve(tree);
  }
  s.find_components();

  for (std::uint32_t f = face_count; f-- > 0;)
    if (!s.is_live(Face(f))) s.faces_.give(Face(f));
  for (std::uint32_t v = vertex_count; v-- > 0;)
    if (!s.is_live(Vertex(v))) s.vertices_.give(Vertex(v));
  return s;
}

}  // namespace clers

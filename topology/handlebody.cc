// A surface as handles attached one by one: CAGD 2010, Theorem 4 and Corollary 12.
#include "topology/handlebody.h"

#include <algorithm>

namespace CLERS_VISIBLE clers {

OperatorCounts Handlebody::counts() const {
  OperatorCounts counts;
  counts.create = static_cast<std::int64_t>(triangles.size());
  for (const Gluing& g : gluings) counts.add(g.kind);
  return counts;
}

Handlebody unbuild(Surface& surface) {
  Handlebody done;
  for (std::uint32_t i = 0; i < surface.half_edge_limit(); ++i) {
    const HalfEdge h(i);
    if (!surface.is_live(h) || surface.is_boundary(h)) continue;
    const HalfEdge twin = surface.sym(h);
    done.gluings.push_back({*surface.unglue(h), h, twin});
  }
  for (std::uint32_t i = 0; i < surface.face_limit(); ++i)
    if (surface.is_live(Face(i))) done.triangles.push_back({Face(i), *surface.destroy(Face(i))});
  std::reverse(done.gluings.begin(), done.gluings.end());
  return done;
}

Result<Surface, Violation> build(const Handlebody& handlebody) {
  std::uint32_t limit = 0;
  for (const auto& t : handlebody.triangles) {
    if (!t.face) return Failure{Violation{Precondition::live_face, t.face.index()}};
    limit = std::max(limit, t.face.index() + 1);
  }
  std::vector<Face> face(limit);  // by the id it had

  Surface surface;
  for (const auto& t : handlebody.triangles) {
    const auto made = surface.create(t.points[0], t.points[1], t.points[2]);
    if (!made) return Failure{made.error()};
    face[t.face.index()] = *made;
  }
  for (const auto& g : handlebody.gluings) {
    HalfEdge sides[2];
    for (unsigned i = 0; i < 2; ++i) {
      const HalfEdge h = i == 0 ? g.h0 : g.h1;
      if (left(h).index() >= limit || !face[left(h).index()])
        return Failure{Violation{Precondition::live_half_edge, h.index()}};
      sides[i] = half_edge(face[left(h).index()], corner(h));
    }
    const auto glued = surface.glue(sides[0], sides[1]);
    if (!glued) return Failure{glued.error()};
  }
  return surface;
}

}  // namespace clers

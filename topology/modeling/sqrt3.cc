// The refinement of sqrt(3) subdivision: CAGD 2010, §7.3, Algorithm 4.
#include "topology/modeling/sqrt3.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "topology/modeling/masks.h"

namespace CLERS_VISIBLE clers {
namespace {

double alpha(std::uint32_t n) {
  return (4 - 2 * std::cos(2 * std::numbers::pi / n)) / 9;
}

/// The mask of the vertex near `end` on the edge of h.
void third_mask(const Surface& s, const Creases& creases, HalfEdge h, Vertex end,
                std::vector<Term>& mask) {
  const Vertex other = s.other_end(h, end);
  const SharpEdges sharp = sharp_edges(s, creases, end);
  if (sharp.curve()) {
    const Vertex before = sharp.ends[s.same_edge(sharp.edges[0], h) ? 1 : 0];
    mask = {{before, 1. / 27}, {end, 16. / 27}, {other, 10. / 27}};
  } else {
    mask = {{end, 2. / 3}, {other, 1. / 3}};
  }
}

}  // namespace

void sqrt3_vertex_mask(const Surface& surface, const Creases& creases, Vertex v, Sqrt3Step step,
                       std::vector<Term>& mask) {
  vertex_mask(surface, creases, v, alpha, step == Sqrt3Step::second ? 8. / 27 : 0, mask);
}

void sqrt3_edge_mask(const Surface& surface, const Creases& creases, HalfEdge h,
                     std::vector<Term>& mask) {
  third_mask(surface, creases, h, surface.org(h), mask);
}
void sqrt3_edge_mask_at_dest(const Surface& surface, const Creases& creases, HalfEdge h,
                             std::vector<Term>& mask) {
  third_mask(surface, creases, h, surface.dest(h), mask);
}

void sqrt3_limit_mask(const Surface& surface, const Creases& creases, Vertex v,
                      std::vector<Term>& mask) {
  const auto ring = [](std::uint32_t n) { return 3 * alpha(n) / (1 + 3 * alpha(n)); };
  vertex_mask(surface, creases, v, ring, 1. / 3, mask);
}

Result<Sqrt3Plan, Violation> sqrt3_plan(const Surface& surface, const Creases& creases,
                                        Sqrt3Step step, std::span<const Face> faces) {
  if (surface.characteristic().f > std::int64_t{max_faces} / 3)
    return Failure{Violation{Precondition::ids_left, max_faces}};
  Sqrt3Plan plan;
  plan.faces.reserve(static_cast<std::size_t>(surface.characteristic().f));
  for (const Face f : faces) {
    unsigned sharp = 0;
    if (step == Sqrt3Step::second) {
      for (const HalfEdge h : surface.star(f)) {
        if (!creases.is_sharp(surface, h)) continue;
        const HalfEdge twin = surface.sym(h);
        if (twin && left(twin) == f) return Failure{Violation{Precondition::two_faces, h.index()}};
        if (++sharp > 1) return Failure{Violation{Precondition::one_sharp_edge, f.index()}};
        if (!twin || h < twin) plan.edges.push_back(h);
      }
    }
    if (sharp == 0) plan.faces.push_back(f);
  }
  return plan;
}

// A face with a sharp edge a-b, and c: after two splits (p c a), (q c p) and (q b c).
//
//            c
//          / | \           The old edges c-a and b-c are half-edge 1 of their faces, as are those
//         / / \ \          of faces with a vertex put inside. c-p, half-edge 1 of the face in
//        / /   \ \         between, is not on its other side.
//       a-p-----q-b
Sqrt3Made sqrt3_refine(Surface& surface, Creases& creases, const Sqrt3Plan& plan) {
  Sqrt3Made made;
  made.in_faces.reserve(plan.faces.size());
  made.on_edges.reserve(plan.edges.size());
  surface.reserve(static_cast<std::uint32_t>(2 * surface.characteristic().f),
                  static_cast<std::uint32_t>(plan.faces.size() + 2 * plan.edges.size()));
  // Edges first: a split takes the faces beside it along, and no other of the plan.
  for (const HalfEdge h : plan.edges) {
    const Vertex p = *creases.split(surface, h, Point());
    const HalfEdge p_b = half_edge(left(surface.sym(half_edge(left(h), 0))), 0);
    made.on_edges.push_back({p, *creases.split(surface, p_b, Point())});
  }
  // Faces made whose half-edge 1 is an old edge: it is flipped once it is so from both sides.
  std::vector<bool> waits(surface.face_limit() + 2 * plan.faces.size());
  const auto flip = [&](Face f) {
    const HalfEdge h = half_edge(f, 1), twin = surface.sym(h);
    if (!twin || corner(twin) != 1 || creases.is_sharp(surface, h)) return;
    if (!waits[f.index()] || !waits[left(twin).index()]) return;
    (void)creases.flip(surface, h);
    waits[f.index()] = waits[left(twin).index()] = false;
  };
  const auto wait = [&](Face f) { waits[f.index()] = true; };
  std::vector<Face> beside;
  for (const auto& pair : made.on_edges)
    for (const Vertex v : pair)
      for (const HalfEdge h : surface.fan(v)) beside.push_back(left(h));
  std::ranges::for_each(beside, wait);
  for (const Face f : plan.faces) {
    const Vertex v = *creases.split(surface, f, Point());
    made.in_faces.push_back(v);
    const HalfEdge h = surface.star_half_edge(v);
    const std::array parts = {left(h), left(surface.sym(lprev(h))),
                              left(surface.sym(half_edge(left(h), 0)))};
    std::ranges::for_each(parts, wait);
    std::ranges::for_each(parts, flip);
  }
  std::ranges::for_each(beside, flip);
  return made;
}

}  // namespace clers

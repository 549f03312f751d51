// The refinement of Loop subdivision, by splits and flips.
#include "topology/modeling/loop.h"

#include <cmath>
#include <numbers>

#include "topology/modeling/masks.h"

namespace CLERS_VISIBLE clers {
namespace {

double alpha(std::uint32_t n) {
  const double t = 3 + 2 * std::cos(2 * std::numbers::pi / n);
  return (40 - t * t) / 64;
}

}  // namespace

void loop_vertex_mask(const Surface& surface, const Creases& creases, Vertex v,
                      std::vector<Term>& mask) {
  vertex_mask(surface, creases, v, alpha, 0.25, mask);
}

void loop_edge_mask(const Surface& surface, const Creases& creases, HalfEdge h,
                    std::vector<Term>& mask) {
  edge_mask(surface, creases, h, 0.375, mask);
}

void loop_limit_mask(const Surface& surface, const Creases& creases, Vertex v,
                     std::vector<Term>& mask) {
  const auto ring = [](std::uint32_t n) { return 1 / (1 + 3 / (8 * alpha(n))); };
  vertex_mask(surface, creases, v, ring, 1. / 3, mask);
}

Result<Done, Violation> loop_check(const Surface& surface) {
  // A new face takes a free id first, so what counts is how many there are.
  if (surface.characteristic().f > std::int64_t{max_faces} / 4)
    return Failure{Violation{Precondition::ids_left, max_faces}};
  for (const Face f : surface.faces())
    for (const HalfEdge h : surface.star(f))
      if (surface.sym(h) && left(surface.sym(h)) == f)
        return Failure{Violation{Precondition::two_faces, h.index()}};
  return Done{};
}

// clang-format off
//
//           c                 c                 c                  c
//          / \               /|\               /|\                / \        .
//         /   \             / | \             / | 2              3---2
//        /     \    ->     /  |  \     ->    /  |/ \     ->     / \ / \      The edges of a
//       a ----- b         a - 1 - b         a - 1 - b          a - 1 - b     triangle are split in
//                                                                            any order: that from
// the first new vertex to the old one opposite, the diagonal, is flipped when all are split.
//
// clang-format on
//
std::vector<Vertex> loop_refine(Surface& surface, Creases& creases,
                                std::span<const HalfEdge> edges) {
  surface.reserve(static_cast<std::uint32_t>(3 * surface.characteristic().f),
                  static_cast<std::uint32_t>(edges.size()));
  std::vector<HalfEdge> twins;
  twins.reserve(edges.size());
  for (const HalfEdge h : edges) twins.push_back(surface.sym(h));
  // Where sides of old faces are, null once they are split; and their diagonals.
  std::vector<HalfEdge> side(surface.half_edge_limit()), diagonal(surface.face_limit());
  for (std::uint32_t i = 0; i < side.size(); ++i) side[i] = HalfEdge(i);

  std::vector<Vertex> made;
  made.reserve(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const HalfEdge old[] = {edges[i], twins[i]};
    const HalfEdge split[] = {side[old[0].index()], old[1] ? side[old[1].index()] : HalfEdge()};
    made.push_back(*creases.split(surface, split[0], Point()));
    for (std::size_t k = 0; k < 2 && old[k]; ++k) {
      // What was left of the edge is f and fresh, in which the other sides are half-edge 1.
      const Face f = left(split[k]), fresh = left(surface.sym(half_edge(f, 0)));
      HalfEdge& next = side[lnext(old[k]).index()];
      HalfEdge& prev = side[lprev(old[k]).index()];
      HalfEdge& cut = diagonal[left(old[k]).index()];
      for (HalfEdge* moved : {&next, &prev, &cut}) {
        if (*moved == lnext(split[k]))
          *moved = half_edge(fresh, 1);
        else if (*moved == lprev(split[k]))
          *moved = half_edge(f, 1);
      }
      if (!cut) cut = half_edge(f, 0);
      side[old[k].index()] = HalfEdge();
      if (!next && !prev) (void)creases.flip(surface, cut);
    }
  }
  return made;
}

}  // namespace clers

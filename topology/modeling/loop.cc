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

/// What a half-edge is, while edges are being split: the number of an old edge, or one of these.
constexpr std::uint32_t no_edge = ~0u;       ///< a half of an old edge, or between new vertices
constexpr std::uint32_t to_flip = ~0u - 1u;  ///< from a new vertex to the old one that opposed it

bool is_old(std::uint32_t number) {
  return number < to_flip;
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

//           c                 c                 c                  c
//          / \               /|\               /|\                / \        .
//         /   \             / | \             / | 2              3---2
//        /     \    ->     /  |  \     ->    /  |/ \     ->     / \ / \      The edges of a
//       a ----- b         a - 1 - b         a - 1 - b          a - 1 - b     triangle are split in
//                                                                            any order: that from
// the first new vertex to the old one opposite is flipped when all are split.
std::vector<Vertex> loop_refine(Surface& surface, Creases& creases,
                                std::span<const HalfEdge> edges) {
  const auto faces = static_cast<std::uint32_t>(surface.characteristic().f);
  surface.reserve(3 * faces, static_cast<std::uint32_t>(edges.size()));
  std::vector<std::uint32_t> number;
  number.reserve(surface.half_edge_limit() + 9 * std::size_t{faces});
  number.resize(surface.half_edge_limit(), no_edge);
  const auto at = [&](HalfEdge h) -> std::uint32_t& { return number[h.index()]; };
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (const HalfEdge side : surface.star(edges[i])) at(side) = static_cast<std::uint32_t>(i);

  std::vector<Vertex> made(edges.size());
  std::vector<Face> pending;
  pending.reserve(2 * std::size_t{faces});
  for (const Face f : surface.faces()) pending.push_back(f);

  const auto split = [&](HalfEdge h) {
    struct Side {
      HalfEdge h;
      std::uint32_t next, prev;
    };
    std::array<Side, 2> sides;
    std::size_t count = 0;
    for (const HalfEdge side : surface.star(h))
      sides[count++] = {side, at(lnext(side)), at(lprev(side))};
    made[at(h)] = *creases.split(surface, h, Point());
    number.resize(surface.half_edge_limit(), no_edge);
    for (const Side& side : std::span(sides).first(count)) {
      const Face f = left(side.h), fresh = left(surface.sym(half_edge(f, 0)));
      const bool first = is_old(side.next) && is_old(side.prev);
      at(half_edge(f, 0)) = at(half_edge(fresh, 2)) = first ? to_flip : no_edge;
      at(half_edge(f, 1)) = side.prev;
      at(half_edge(fresh, 1)) = side.next;
      at(half_edge(f, 2)) = at(half_edge(fresh, 0)) = no_edge;
      if (is_old(side.next)) pending.push_back(fresh);
    }
  };
  for (std::size_t i = 0; i < pending.size(); ++i) {
    const Face f = pending[i];
    for (bool again = true; again;) {
      again = false;
      for (unsigned c = 0; c < 3 && !again; ++c)
        if (is_old(at(half_edge(f, c)))) split(half_edge(f, c)), again = true;
    }
  }
  // Of the four faces of a triangle two have such an edge, the same: flips do not disturb others.
  for (std::uint32_t i = 0; i < number.size(); ++i)
    if (number[i] == to_flip && HalfEdge(i) < surface.sym(HalfEdge(i)))
      (void)creases.flip(surface, HalfEdge(i));
  return made;
}

}  // namespace clers

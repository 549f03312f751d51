// The order of visit by parallelograms: vertices that two predict, before those that one does. It
// knows the surface, but no values.
#ifndef CLERS_CODEC_ATTRIBUTES_VISIT_ORDER_H
#define CLERS_CODEC_ATTRIBUTES_VISIT_ORDER_H

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "codec/attributes/parallelograms.h"
#include "codec/base/portable.h"
#include "codec/connectivity/coded_surface.h"
#include "topology/ids.h"

namespace clers::internal {

/// What is known in the order of visit.
class Visited {
 public:
  /// How many parallelograms end at each vertex, 2 being many; or that it is known.
  static constexpr std::uint8_t known = 3;
  explicit Visited(const std::uint8_t* state) : state_(state) {}

  bool operator()(std::uint32_t v) const { return state_[v] == known; }

 private:
  const std::uint8_t* state_;
};

/// Calls visit(h, visited) for each vertex that a triangle has; h leaves it. visited(u) tells
/// whether u was visited before.
///
/// A vertex x waits when all vertices of a triangle are visited and x is across from one of its
/// sides, a-b: it has a parallelogram then, and h is the half-edge from x to a.
///
///          x
///         / \           .
///        a---b
///         \ /
///          c
///
/// Around a vertex v that is visited those triangles are looked at that follow each other on both
/// sides of the one that h is in, as far as all their vertices are known. What is across from the
/// sides that do not end at v waits, and so do the first vertices around v that are not known:
///
///        x---x---x         v has h in the triangle v r s. x wait, if they are not visited; what is
///         \ / \ /          known on the far side of v is not looked for
///      x---s---r---x
///           \ /
///            v
///
/// First come those that waited twice, then those that did once, in the order in which they did.
/// With none waiting, the next one in the order of introduction is visited. Where a vertex has
/// copies, it is visited once, and the triangles around it are those around the copy that h leaves.
///
/// Precondition: twins are there. Cost: linear; memory: visit_order_memory.
template <class Visit>
void for_each_by_parallelograms(const CodedSurface& surface, Visit visit) {
  const std::size_t vertices = surface.introduced_by.size();
  const std::uint32_t* const corners = surface.corners.data();
  const HalfEdge* const twins = surface.twins.data();
  std::vector<std::uint8_t> states(vertices);
  std::uint8_t* const state = states.data();
  // Each vertex enters each queue once; what does not enter is written behind the last.
  std::vector<HalfEdge> ones(vertices + 1), twos(vertices + 1);
  HalfEdge *one = ones.data(), *one_end = one, *two = twos.data(), *two_end = two;
  const auto knows = [=](std::uint32_t h)
                         CLERS_INLINE_LAMBDA { return state[corners[h]] == Visited::known; };
  // One more parallelogram for the vertex that half-edge x leaves, which is not visited. Without a
  // branch, which would go either way.
  const auto wait = [&](std::uint32_t x) CLERS_INLINE_LAMBDA {
    std::uint8_t& n = state[corners[x]];
    const unsigned before = n, first = before == 0, second = before == 1;
    *one_end = *two_end = HalfEdge(x);
    one_end += first;
    two_end += second;
    n = static_cast<std::uint8_t>(before + first + second);
    fetch(&twins[x]);
  };
  // Across side h of a triangle whose vertices are all known.
  const auto look_across = [&](std::uint32_t h) CLERS_INLINE_LAMBDA {
    if (const HalfEdge across = twins[h]) [[likely]]
      wait(previous_in(across.index()));
  };
  const auto go_to = [&](HalfEdge from) CLERS_INLINE_LAMBDA {
    visit(from, Visited(state));
    const std::uint32_t first = from.index();
    state[corners[first]] = Visited::known;
    if (!(unsigned(knows(next_in(first))) & unsigned(knows(previous_in(first))))) return;
    look_across(next_in(first));
    for (std::uint32_t side = previous_in(first);;) {  // counterclockwise
      const HalfEdge across = twins[side];
      if (!across) [[unlikely]]
        break;
      if (across == from) [[unlikely]]
        return;
      side = previous_in(across.index());
      if (!knows(side)) {
        wait(side);
        break;
      }
      look_across(next_in(across.index()));
    }
    for (std::uint32_t side = first;;) {  // clockwise
      const HalfEdge across = twins[side];
      if (!across) [[unlikely]]
        return;
      side = next_in(across.index());
      const std::uint32_t ahead = next_in(side);
      if (!knows(ahead)) return wait(ahead);
      look_across(ahead);
    }
  };
  for_each_introduced(surface, [&](std::uint32_t t, unsigned corner) CLERS_INLINE_LAMBDA {
    HalfEdge next = half_edge(Face(t), corner);
    for (;;) {
      if (!knows(next.index())) go_to(next);
      if (two < two_end)
        next = *two++;
      else if (one < one_end)
        next = *one++;
      else
        return;
    }
  });
}

/// What for_each_by_parallelograms allocates.
inline std::uint64_t visit_order_memory(std::uint64_t vertices) {
  return vertices + 2 * (vertices + 1) * sizeof(HalfEdge);
}

}  // namespace clers::internal

#endif

// The order of visit by parallelograms: vertices that two predict, before those that one does. It
// knows the surface, but no values.
#ifndef CLERS_CODEC_ATTRIBUTES_VISIT_ORDER_H
#define CLERS_CODEC_ATTRIBUTES_VISIT_ORDER_H

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "codec/attributes/parallelograms.h"
#include "codec/connectivity/coded_surface.h"
#include "topology/ids.h"

namespace clers::internal {

/// What is known in the order of visit.
class Visited {
 public:
  explicit Visited(std::size_t vertices) : state_(vertices) {}

  bool operator()(std::uint32_t v) const { return state_[v] == known; }
  void visit(std::uint32_t v) { state_[v] = known; }

  /// One more parallelogram ends at v, which is not visited. Returns how many there are, 1 or 2,
  /// if it is the first or second; else 0.
  unsigned another(std::uint32_t v) {
    if (state_[v] == 2) return 0;
    return ++state_[v];
  }

 private:
  static constexpr std::uint8_t known = 3;
  std::vector<std::uint8_t> state_;  ///< parallelograms that end there, two are many; or known
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
///          c     the last of a, b, c is visited
///
/// First come those with two parallelograms, then those with one, in the order in which they began
/// to wait for it (by the parallelogram that is their second, or first). With none waiting, the
/// next one in the order of introduction is visited. Where a vertex has copies, it is visited once,
/// and the triangles around the copy that h leaves are those whose vertices may become known by
/// that.
///
/// Precondition: twins are there. Cost: linear; memory: visit_order_memory.
template <class Visit>
void for_each_by_parallelograms(const CodedSurface& surface, Visit visit) {
  const std::size_t vertices = surface.introduced_by.size();
  Visited visited(vertices);
  // The queues: each vertex enters each once.
  std::vector<HalfEdge> one(vertices), two(vertices);
  std::size_t one_begin = 0, one_end = 0, two_begin = 0, two_end = 0;
  // One more parallelogram for the vertex that half-edge x leaves.
  const auto wait = [&](std::uint32_t x) {
    const unsigned n = visited.another(surface.corners[x]);
    if (n == 1) one[one_end++] = HalfEdge(x);
    if (n == 2) two[two_end++] = HalfEdge(x);
  };
  // Across from v in a triangle v a b, of which a and b are known.
  const auto look_out = [&](std::uint32_t h) {
    const HalfEdge across = surface.twins[next_in(h)];
    if (!across) return;
    const std::uint32_t x = previous_in(across.index());
    if (!visited(surface.corners[x])) wait(x);
  };
  // Around v, of two triangles v r s and v s t that follow each other: where s is known and r or t
  // is, the other is across from it.
  const auto go_to = [&](HalfEdge first) {
    visit(first, std::as_const(visited));
    visited.visit(surface.corners[first.index()]);
    const auto knows = [&](std::uint32_t h) { return visited(surface.corners[h]); };
    std::uint32_t h = first.index();
    const bool first_r = knows(next_in(h)), first_s = knows(previous_in(h));
    if (first_r & first_s) look_out(h);
    bool r = first_r, s = first_s;
    for (;;) {
      const std::uint32_t back = next_in(h);  // leaves r
      const HalfEdge across = surface.twins[previous_in(h)];
      if (!across) break;
      h = across.index();
      const bool closed = h == first.index(), t = closed ? first_s : knows(previous_in(h));
      if (s & (r != t)) {
        const std::uint32_t x = r ? previous_in(h) : back;
        wait(x);
      }
      if (closed) return;
      if (s & t) look_out(h);
      r = s;
      s = t;
    }
    // The same clockwise from the first.
    h = first.index();
    r = first_s;
    s = first_r;
    for (;;) {
      const std::uint32_t back = previous_in(h);
      const HalfEdge across = surface.twins[h];
      if (!across) return;
      h = next_in(across.index());
      const bool t = knows(next_in(h));
      if (s & (r != t)) wait(r ? next_in(h) : back);
      if (s & t) look_out(h);
      r = s;
      s = t;
    }
  };
  const auto go_on = [&] {
    for (;;) {
      HalfEdge next;
      if (two_begin < two_end)
        next = two[two_begin++];
      else if (one_begin < one_end)
        next = one[one_begin++];
      else
        return;
      if (!visited(surface.corners[next.index()])) go_to(next);
    }
  };
  for_each_introduced(surface, [&](std::uint32_t t, unsigned corner) {
    const HalfEdge first = half_edge(Face(t), corner);
    if (visited(surface.corners[first.index()])) return;
    go_to(first);
    go_on();
  });
}

/// What for_each_by_parallelograms allocates.
inline std::uint64_t visit_order_memory(std::uint64_t vertices) {
  return vertices * (1 + 2 * sizeof(HalfEdge));
}

}  // namespace clers::internal

#endif

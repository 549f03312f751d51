// Cyclic sequences of boundary half-edges, cut and joined in logarithmic time.
// Internal: installed because surface.h needs it, no part of the API.
//
// A boundary curve is a ring. The paper decides which curve an edge is on by union-find (§6.2), but
// glue of type 1b and its like split curves, which union-find cannot. A balanced tree can: a ring
// is kept as a treap whose in-order sequence, read cyclically, is the curve. Priorities are a
// bijective hash of the half-edge's id, so that the shape depends on the sequence alone.
#ifndef CLERS_TOPOLOGY_RING_H
#define CLERS_TOPOLOGY_RING_H

#include <cstdint>
#include <utility>
#include <vector>

#include <clers/topology/export.h>
#include <clers/topology/ids.h>

namespace CLERS_VISIBLE clers {
struct SurfacePeer;  // corrupts arrays, in tests
}

namespace clers {
namespace CLERS_VISIBLE internal {

/// A forest of treaps over half-edges. A tree is named by its root; the null id is the empty tree.
/// Trees of n nodes cost O(log n) expected for each operation that does not say otherwise; none
/// allocates but `resize`. Everything is iterative: a degenerate shape costs time, not stack.
class Rings {
 public:
  struct Node {
    HalfEdge parent, lower, upper;  ///< lower: the subtree before this node; upper: after it
    std::uint32_t size = 0;         ///< nodes of this subtree; 0: the half-edge is on no ring
    Curve curve;                    ///< at a root: the curve's name; null elsewhere
  };

  void reserve(std::size_t half_edges) { nodes_.reserve(half_edges); }
  void resize(std::size_t half_edges) { nodes_.resize(half_edges); }
  std::size_t capacity() const { return nodes_.capacity(); }
  const std::vector<Node>& nodes() const { return nodes_; }

  bool contains(HalfEdge h) const { return at(h).size != 0; }
  std::uint32_t size(HalfEdge tree) const { return tree ? at(tree).size : 0; }
  Curve curve(HalfEdge tree) const { return at(tree).curve; }
  void set_curve(HalfEdge tree, Curve c) { at(tree).curve = c; }

  /// The tree `h` is in.
  HalfEdge root(HalfEdge h) const {
    while (at(h).parent) h = at(h).parent;
    return h;
  }

  /// The half-edge before `h`, cyclically.
  HalfEdge prev(HalfEdge h) const {
    if (at(h).lower) return last(at(h).lower);
    const HalfEdge start = h;
    while (at(h).parent && at(at(h).parent).lower == h) h = at(h).parent;
    return at(h).parent ? at(h).parent : last(root(start));
  }

  /// Makes `h`, which is on no ring, a tree of its own.
  HalfEdge single(HalfEdge h) {
    at(h) = Node{};
    at(h).size = 1;
    return h;
  }

  /// Takes a half-edge off whatever ring it is on, without regard for the others of that ring.
  void clear(HalfEdge h) { at(h) = Node{}; }

  /// The sequence of `before` followed by that of `after`. Either may be empty. Names are lost.
  HalfEdge join(HalfEdge before, HalfEdge after) {
    HalfEdge result, parent;
    HalfEdge* link = &result;
    // Merge the right spine of one with the left spine of the other, higher priority on top.
    while (before && after) {
      if (priority(before) > priority(after)) {
        at(before).size += at(after).size;
        link_child(before, parent, link);
        parent = before, link = &at(before).upper, before = *link;
      } else {
        at(after).size += at(before).size;
        link_child(after, parent, link);
        parent = after, link = &at(after).lower, after = *link;
      }
    }
    link_child(before ? before : after, parent, link);
    return result;
  }

  /// Cuts the tree of `h` into what precedes `h` (may be empty) and what begins with it.
  std::pair<HalfEdge, HalfEdge> split_before(HalfEdge h) {
    HalfEdge before = at(h).lower, after = h, child = h, up = at(h).parent;
    if (before) at(before).parent = HalfEdge(), at(before).curve = Curve();
    at(h).lower = HalfEdge();
    at(h).parent = HalfEdge();
    at(h).curve = Curve();
    at(h).size -= size(before);
    // Each ancestor goes, with the subtree on its far side, to the part it is in.
    while (up) {
      const HalfEdge next = at(up).parent;
      const bool was_lower = at(up).lower == child;
      child = up;
      at(up).parent = HalfEdge();
      at(up).curve = Curve();
      HalfEdge& part = was_lower ? after : before;
      (was_lower ? at(up).lower : at(up).upper) = part;
      if (part) at(part).parent = up;
      at(up).size = 1 + size(at(up).lower) + size(at(up).upper);
      part = up;
      up = next;
    }
    return {before, after};
  }

  /// Turns the ring of `h` so that its sequence begins with `h`.
  HalfEdge rotate(HalfEdge h) {
    const auto [before, after] = split_before(h);
    return join(after, before);
  }

  /// Takes the first half-edge off the sequence; what remains may be empty.
  HalfEdge pop_front(HalfEdge tree) {
    const HalfEdge front = first(tree);
    const HalfEdge up = at(front).parent, rest = at(front).upper;
    if (rest) at(rest).parent = up;
    if (up) at(up).lower = rest;
    for (HalfEdge n = up; n; n = at(n).parent) --at(n).size;
    at(front) = Node{};
    return up ? tree : rest;
  }

  static std::uint32_t priority(HalfEdge h) {
    std::uint32_t x = h.index();
    x = (x ^ (x >> 16)) * 0x9e3779b1u;
    x = (x ^ (x >> 15)) * 0x85ebca77u;
    return x ^ (x >> 16);
  }

 private:
  friend struct clers::SurfacePeer;

  Node& at(HalfEdge h) { return nodes_[h.index()]; }
  const Node& at(HalfEdge h) const { return nodes_[h.index()]; }

  HalfEdge first(HalfEdge tree) const {
    while (at(tree).lower) tree = at(tree).lower;
    return tree;
  }
  HalfEdge last(HalfEdge tree) const {
    while (at(tree).upper) tree = at(tree).upper;
    return tree;
  }
  void link_child(HalfEdge child, HalfEdge parent, HalfEdge* link) {
    *link = child;
    if (!child) return;
    at(child).parent = parent;
    at(child).curve = Curve();
  }

  std::vector<Node> nodes_;
};

}  // namespace internal
}  // namespace clers

#endif

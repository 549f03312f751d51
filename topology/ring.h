// Cyclic sequences of boundary vertices, cut and joined in logarithmic time.
// Internal: installed because surface.h needs it, no part of the API.
//
// A boundary curve is a ring. The paper decides which curve an edge is on by union-find (§6.2), but
// glue of type 1b and its like split curves, which union-find cannot. A balanced tree can: a ring
// is kept as a treap whose in-order sequence, read cyclically, is the curve. Nodes are of vertices:
// one half-edge on the boundary leaves a boundary vertex, its star, and which half-edge that is may
// change as the faces beside the curve do. There are as many nodes as boundary edges, no matter how
// many vertices are inside. Priorities are a bijective hash of the node's id.
#ifndef CLERS_TOPOLOGY_RING_H
#define CLERS_TOPOLOGY_RING_H

#include <cstdint>
#include <utility>
#include <vector>

#include <clers/topology/export.h>
#include <clers/topology/id_pool.h>
#include <clers/topology/ids.h>

namespace CLERS_VISIBLE clers {
struct RingNodeTag;  // not internal: members of Surface have it in their names
}

namespace clers {
namespace CLERS_VISIBLE internal {

using RingNode = Id<RingNodeTag>;

/// A forest of treaps over boundary vertices. A tree is named by its root; the null id is the empty
/// tree. Trees of n nodes cost O(log n) expected for each operation that does not say otherwise;
/// none allocates but `reserve` and `room_to_free`. Everything is iterative: a degenerate shape
/// costs time, not stack.
class Rings {
 public:
  struct Node {
    RingNode parent, lower, upper;  ///< lower: the subtree before this node; upper: after it
    std::uint32_t size = 0;         ///< nodes of this subtree; 0: free
    Vertex vertex;                  ///< whose star half-edge is here on the curve
    Curve curve;                    ///< at a root: the curve's name; null elsewhere
  };

  void reserve(std::uint32_t count) { reserve_more(nodes_, pool_.growth(count)); }
  void room_to_free(std::uint32_t count) { pool_.room_to_give(count); }
  const std::vector<Node>& nodes() const { return nodes_; }
  const IdPool<RingNode>& pool() const { return pool_; }

  Vertex vertex(RingNode n) const { return at(n).vertex; }
  void set_vertex(RingNode n, Vertex v) { at(n).vertex = v; }
  bool is_root(RingNode n) const { return !at(n).parent; }
  std::uint32_t size(RingNode tree) const { return tree ? at(tree).size : 0; }
  Curve curve(RingNode tree) const { return at(tree).curve; }
  void set_curve(RingNode tree, Curve c) { at(tree).curve = c; }

  /// The tree `n` is in.
  RingNode root(RingNode n) const {
    while (at(n).parent) n = at(n).parent;
    return n;
  }

  /// The node before `n`, cyclically.
  RingNode prev(RingNode n) const {
    if (at(n).lower) return last(at(n).lower);
    const RingNode start = n;
    while (at(n).parent && at(at(n).parent).lower == n) n = at(n).parent;
    return at(n).parent ? at(n).parent : last(root(start));
  }

  /// A new node, of no vertex yet, a tree of its own.
  RingNode single() {
    const RingNode n = pool_.take();
    if (n.index() == nodes_.size()) nodes_.emplace_back();
    at(n).size = 1;
    return n;
  }

  /// Frees a node, without regard for the others of its ring.
  void free(RingNode n) {
    at(n) = Node{};
    pool_.give(n);
  }

  /// The sequence of `before` followed by that of `after`. Either may be empty. Names are lost.
  RingNode join(RingNode before, RingNode after) {
    RingNode result, parent;
    RingNode* link = &result;
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

  /// Cuts the tree of `n` into what precedes `n` (may be empty) and what begins with it.
  std::pair<RingNode, RingNode> split_before(RingNode n) {
    RingNode before = at(n).lower, after = n, child = n, up = at(n).parent;
    if (before) at(before).parent = RingNode(), at(before).curve = Curve();
    at(n).lower = RingNode();
    at(n).parent = RingNode();
    at(n).curve = Curve();
    at(n).size -= size(before);
    // Each ancestor goes, with the subtree on its far side, to the part it is in.
    while (up) {
      const RingNode next = at(up).parent;
      const bool was_lower = at(up).lower == child;
      child = up;
      at(up).parent = RingNode();
      at(up).curve = Curve();
      RingNode& part = was_lower ? after : before;
      (was_lower ? at(up).lower : at(up).upper) = part;
      if (part) at(part).parent = up;
      at(up).size = 1 + size(at(up).lower) + size(at(up).upper);
      part = up;
      up = next;
    }
    return {before, after};
  }

  /// Turns the ring of `n` so that its sequence begins with `n`.
  RingNode rotate(RingNode n) {
    const auto [before, after] = split_before(n);
    return join(after, before);
  }

  /// Frees the first node of the sequence; what remains may be empty.
  RingNode pop_front(RingNode tree) {
    const RingNode front = first(tree);
    const RingNode up = at(front).parent, rest = at(front).upper;
    if (rest) at(rest).parent = up;
    if (up) at(up).lower = rest;
    for (RingNode n = up; n; n = at(n).parent) --at(n).size;
    free(front);
    return up ? tree : rest;
  }

  static std::uint32_t priority(RingNode n) {
    std::uint32_t x = n.index();
    x = (x ^ (x >> 16)) * 0x9e3779b1u;
    x = (x ^ (x >> 15)) * 0x85ebca77u;
    return x ^ (x >> 16);
  }

 private:
  friend struct clers::SurfacePeer;

  Node& at(RingNode n) { return nodes_[n.index()]; }
  const Node& at(RingNode n) const { return nodes_[n.index()]; }

  RingNode first(RingNode tree) const {
    while (at(tree).lower) tree = at(tree).lower;
    return tree;
  }
  RingNode last(RingNode tree) const {
    while (at(tree).upper) tree = at(tree).upper;
    return tree;
  }
  void link_child(RingNode child, RingNode parent, RingNode* link) {
    *link = child;
    if (!child) return;
    at(child).parent = parent;
    at(child).curve = Curve();
  }

  std::vector<Node> nodes_;
  IdPool<RingNode> pool_;
};

}  // namespace internal
}  // namespace clers

#endif

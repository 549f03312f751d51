// Sequences that are cut and joined anywhere, and searched by position, in logarithmic time.
#ifndef CLERS_CODEC_CONNECTIVITY_SEQUENCES_H
#define CLERS_CODEC_CONNECTIVITY_SEQUENCES_H

#include <cstdint>
#include <utility>
#include <vector>

namespace clers::internal {

/// A forest of splay trees (Sleator and Tarjan 1985). A node stands for one or more places that
/// follow each other; read in order, a tree is a sequence of them. Nodes have the numbers 1, 2 .. ;
/// 0 is no node, and the empty tree. A tree is named by its root: what changes it returns the new
/// one.
///
/// Cost: O(log n) amortised for each operation that does not say otherwise, whatever comes in
/// whichever order. Memory: 24 bytes a node. Throws std::bad_alloc only.
class Sequences {
 public:
  using Node = std::uint32_t;

  /// A node of its own. A node that was released comes back with its number.
  Node make(std::uint32_t places) {
    Node n = free_;
    if (n) {
      free_ = at(n).up;
    } else {
      n = static_cast<Node>(nodes_.size());
      nodes_.emplace_back();
    }
    at(n) = {0, {0, 0}, places, places, 0};
    return n;
  }

  /// Gives all nodes of a tree back. Cost: linear.
  void release(Node tree) {
    for (Node next = tree; next;) {
      const Node n = next;
      next = n == tree ? 0 : at(n).up;
      for (const Node below : at(n).below) {
        if (!below) continue;
        at(below).up = next;
        next = below;
      }
      at(n).up = free_;
      free_ = n;
    }
  }

  std::uint32_t places(Node n) const { return at(n).own; }
  std::uint32_t length(Node tree) const { return at(tree).total; }

  /// A number that a tree keeps until it is cut or joined, 0 at first.
  std::uint32_t name(Node tree) const { return at(tree).name; }
  void set_name(Node tree, std::uint32_t name) { at(tree).name = name; }

  /// Makes a node the root of its tree.
  Node to_root(Node n) {
    while (const Node parent = at(n).up) {
      if (const Node above = at(parent).up)
        rotate((at(parent).below[1] == n) == (at(above).below[1] == parent) ? parent : n);
      rotate(n);
    }
    return n;
  }

  /// Places before a root.
  std::uint32_t before(Node root) const { return at(at(root).below[0]).total; }

  /// Makes the node that has the k-th place of a tree its root. Precondition: k < length(tree).
  Node find(Node tree, std::uint32_t k) {
    for (;;) {
      const std::uint32_t before = this->before(tree);
      if (k < before) {
        tree = at(tree).below[0];
      } else if (k - before < at(tree).own) {
        return to_root(tree);
      } else {
        k -= before + at(tree).own;
        tree = at(tree).below[1];
      }
    }
  }

  /// Makes the last node of a tree its root.
  Node last(Node tree) {
    while (at(tree).below[1]) tree = at(tree).below[1];
    return to_root(tree);
  }

  /// Changes how many places a root stands for.
  void resize(Node root, std::uint32_t places) {
    at(root).total += places - at(root).own;
    at(root).own = places;
  }

  /// Takes off what comes before a root, or after it, and returns that.
  Node cut_before(Node root) { return cut(root, 0); }
  Node cut_after(Node root) { return cut(root, 1); }

  /// One tree after another. Either may be empty.
  Node join(Node first, Node second) {
    if (!first || !second) return first ? first : second;
    first = last(first);
    at(first).below[1] = second;
    at(second).up = first;
    at(first).total += at(second).total;
    at(first).name = at(second).name = 0;
    return first;
  }

 private:
  struct Data {
    Node up = 0;                       ///< of one that was released: the next such
    Node below[2] = {0, 0};            ///< before it, after it
    std::uint32_t own = 0, total = 0;  ///< places, of the node and of its tree
    std::uint32_t name = 0;            ///< at a root
  };

  Data& at(Node n) { return nodes_[n]; }
  const Data& at(Node n) const { return nodes_[n]; }

  /// Puts a node in the place of the one above it.
  void rotate(Node n) {
    const Node parent = at(n).up, above = at(parent).up;
    const unsigned side = at(parent).below[1] == n;
    const Node inner = at(n).below[1 - side];
    at(parent).below[side] = inner;
    if (inner) at(inner).up = parent;
    at(n).below[1 - side] = parent;
    at(parent).up = n;
    at(n).up = above;
    if (above)
      at(above).below[at(above).below[1] == parent] = n;
    else
      std::swap(at(n).name, at(parent).name);
    at(n).total = at(parent).total;
    at(parent).total =
        at(parent).own + at(at(parent).below[0]).total + at(at(parent).below[1]).total;
  }

  Node cut(Node root, unsigned side) {
    const Node part = at(root).below[side];
    at(root).name = 0;
    if (!part) return 0;
    at(root).below[side] = 0;
    at(root).total -= at(part).total;
    at(part).up = 0;
    return part;
  }

  std::vector<Data> nodes_ = std::vector<Data>(1);
  Node free_ = 0;
};

}  // namespace clers::internal

#endif

// Unbuilding at codec speed: unglue and detach on nothing but a table of twins.
//
// unglue is the operator of the paper, in any of its cases. detach(gate) is unglue(left side), then
// unglue(right side), each if it is not on the boundary, then destroy(face).
//
// Edgebreaker asks of the surface only whether an edge is on the boundary; "the neighbour is
// visited" is "the edge was unglued". Which case an unglue was (§5.1.2) is not needed to go on, and
// turns out later: Spirale Reversi meets it again from the other side.
//
// A polygon is a fan of triangles whose diagonals nobody has drawn: which they are depends on the
// edge at which it is entered. To detach one of these triangles, an ear, is the same operators;
// its diagonal is glued and unglued at once, and what is left is a polygon of one side less.
#ifndef CLERS_TOPOLOGY_UNBUILD_H
#define CLERS_TOPOLOGY_UNBUILD_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "topology/ids.h"

namespace clers::internal {

// Two kinds of faces. Each says how the half-edges of a face follow each other, and keeps of a
// destroyed triangle which one it was, in their order.

/// Triangles: what follows is arithmetic (ids.h).
class TriangleFaces {
 public:
  static constexpr bool only_triangles = true;
  /// A destroyed face keeps this in place of the twin of its first half-edge, and a note in place
  /// of that of the next.
  static constexpr HalfEdge destroyed_mark = HalfEdge(HalfEdge::null_index - 1);

  TriangleFaces(std::span<HalfEdge> twins, std::span<const std::uint32_t>) : twins_(twins) {}

  std::uint32_t faces() const { return static_cast<std::uint32_t>(twins_.size() / 3); }
  std::uint32_t triangles() const { return faces(); }
  std::uint32_t size(std::uint32_t) const { return 3; }
  HalfEdge next(HalfEdge h) const { return lnext(h); }
  HalfEdge prev(HalfEdge h) const { return lprev(h); }
  bool is_triangle(HalfEdge) const { return true; }

  void cut_ear(HalfEdge, HalfEdge, HalfEdge, std::uint32_t) {}
  void destroy(HalfEdge gate, HalfEdge, HalfEdge, std::uint32_t i) {
    const HalfEdge first = half_edge(left(gate), 0);
    twins_[first.index()] = destroyed_mark;
    twins_[first.index() + 1] = half_edge(Face(i), corner(gate));
  }
  bool is_destroyed(HalfEdge h) const {
    return twins_[half_edge(left(h), 0).index()] == destroyed_mark;
  }
  HalfEdge detached_side(HalfEdge h) const {
    const HalfEdge gate = twins_[half_edge(left(h), 1).index()];
    return half_edge(left(gate), (corner(h) + 3 - corner(gate)) % 3);
  }

 private:
  std::span<HalfEdge> twins_;
};

/// Polygons, their half-edges consecutive: cycles that lose an ear at a time.
///
///          v_______u          The triangle at the gate a -> b is (a, b, v). Without it the half-edge
///         / .       \         v -> a is no longer there; the diagonal v -> b takes its name.
///        /    .      \        So the next triangle is (v, b, u), and all are a fan around b.
///       a =gate=> b --'
class PolygonFaces {
 public:
  static constexpr bool only_triangles = false;
  /// Precondition: sizes of at least 3 that add up to the number of twins.
  PolygonFaces(std::span<HalfEdge> twins, std::span<const std::uint32_t> sizes) : sizes_(sizes) {
    links_.reserve(twins.size());
    std::uint32_t first = 0;
    for (const std::uint32_t size : sizes) {
      const std::uint32_t last = first + size - 1;
      links_.push_back({HalfEdge(first + 1), HalfEdge(last)});
      for (std::uint32_t h = first + 1; h < last; ++h)
        links_.push_back({HalfEdge(h + 1), HalfEdge(h - 1)});
      links_.push_back({HalfEdge(first), HalfEdge(last - 1)});
      first += size;
    }
  }

  std::uint32_t faces() const { return static_cast<std::uint32_t>(sizes_.size()); }
  std::uint32_t triangles() const {
    return static_cast<std::uint32_t>(links_.size() - 2 * sizes_.size());
  }
  std::uint32_t size(std::uint32_t f) const { return sizes_[f]; }
  HalfEdge next(HalfEdge h) const { return links_[h.index()].next; }
  HalfEdge prev(HalfEdge h) const { return links_[h.index()].prev; }
  /// Whether the triangle at a gate is all that is left of the face.
  bool is_triangle(HalfEdge gate) const { return prev(prev(gate)) == next(gate); }

  /// The i-th triangle goes, the rest of the face stays.
  void cut_ear(HalfEdge gate, HalfEdge right, HalfEdge left, std::uint32_t i) {
    links_[left.index()].next = right;
    links_[right.index()].prev = left;
    links_[gate.index()] = gone(i, 0);
  }
  void destroy(HalfEdge gate, HalfEdge right, HalfEdge left, std::uint32_t i) {
    links_[gate.index()] = gone(i, 0);
    links_[right.index()] = gone(i, 1);
    links_[left.index()] = gone(i, 2);
  }
  bool is_destroyed(HalfEdge h) const { return !next(h); }
  HalfEdge detached_side(HalfEdge h) const {
    const HalfEdge side = prev(h);
    // Was it a gate? Then that was the diagonal that had its name.
    return corner(side) == 0 ? half_edge(Face(left(side).index() - 1), 2) : side;
  }

 private:
  struct Links {
    HalfEdge next, prev;
  };
  /// Of a half-edge that is destroyed: in place of `prev` what it was.
  static Links gone(std::uint32_t i, unsigned side) {
    return {HalfEdge(), half_edge(Face(i), side)};
  }

  std::span<const std::uint32_t> sizes_;
  std::vector<Links> links_;
};

/// Witness of operators that is not interested.
struct NoWitness {
  void unglue(HalfEdge, HalfEdge, unsigned) {}
  void cut_ear(HalfEdge, HalfEdge) {}
  void destroy(HalfEdge, HalfEdge, HalfEdge) {}
};

/// The surface that is still there, by its twins; null on a boundary. It consumes the table.
/// Witness sees every operator (topology/mirror.h runs them on a full Surface).
template <class Faces, class Witness>
class Unbuilding {
 public:
  /// `sizes`: of PolygonFaces.
  Unbuilding(std::span<HalfEdge> twins, std::span<const std::uint32_t> sizes, Witness& witness)
      : twins_(twins), faces_(twins, sizes), witness_(&witness) {}

  std::span<const HalfEdge> twins() const { return twins_; }
  HalfEdge sym(HalfEdge h) const { return twins_[h.index()]; }
  bool is_boundary(HalfEdge h) const { return !sym(h); }
  HalfEdge next(HalfEdge h) const { return faces_.next(h); }
  HalfEdge prev(HalfEdge h) const { return faces_.prev(h); }
  bool is_triangle(HalfEdge gate) const { return faces_.is_triangle(gate); }
  std::uint32_t faces() const { return faces_.faces(); }
  std::uint32_t triangles() const { return faces_.triangles(); }
  std::uint32_t size(std::uint32_t face) const { return faces_.size(face); }

  /// Asked while no face is there in part.
  bool is_destroyed(HalfEdge h) const { return faces_.is_destroyed(h); }
  /// Which side of which triangle it was, of those that were detached: half_edge(i, 1) was right of
  /// the gate of the i-th. Precondition: h is destroyed, and its face was entered elsewhere.
  HalfEdge detached_side(HalfEdge h) const { return faces_.detached_side(h); }

  /// Makes two boundary edges of an interior one (any case; O(1)). `side`: of the triangle that is
  /// detached next, counted from its gate. Precondition: h is not on the boundary.
  void unglue(HalfEdge h, unsigned side) {
    witness_->unglue(h, sym(h), side);
    twins_[sym(h).index()] = HalfEdge();
    twins_[h.index()] = HalfEdge();
  }

  /// CAGD 2010, §6.4, with the destroy after the loop. The side left of the gate goes first, then
  /// the one right of it: the opposite order of attach, then zip or glue. If the triangle is an
  /// ear, its left side becomes the name of the diagonal. `i` is kept: the triangle is the i-th.
  /// Precondition: the gate is on the boundary.
  void detach(HalfEdge gate, std::uint32_t i) {
    const HalfEdge left_side = prev(gate), right_side = next(gate);
    if (!is_boundary(left_side)) unglue(left_side, 2);
    if (!is_triangle(gate)) {
      witness_->cut_ear(gate, left_side);
      faces_.cut_ear(gate, right_side, left_side, i);
      return;
    }
    if (!is_boundary(right_side)) unglue(right_side, 1);
    witness_->destroy(gate, right_side, left_side);
    faces_.destroy(gate, right_side, left_side, i);
  }

 private:
  std::span<HalfEdge> twins_;
  Faces faces_;
  Witness* witness_;
};

/// Witness that keeps the twins of what is unbuilt, by the triangles in the order in which they
/// were detached: side 0 of each is its gate. The counterpart of Opposites (front.h).
class KeepTwins {
 public:
  /// `half_edges` of the surface; of its triangles there are 3 sides each.
  KeepTwins(std::size_t half_edges, std::size_t sides) : twins(sides), beyond_(half_edges) {}

  void unglue(HalfEdge, HalfEdge twin, unsigned side) { beyond_[twin.index()] = here(side); }
  void cut_ear(HalfEdge gate, HalfEdge left_side) {
    meet(gate, 0);
    meet(left_side, 2);
    beyond_[left_side.index()] = here(1);
    ++detached_;
  }
  void destroy(HalfEdge gate, HalfEdge right_side, HalfEdge left_side) {
    meet(gate, 0);
    meet(right_side, 1);
    meet(left_side, 2);
    ++detached_;
  }

  std::vector<HalfEdge> twins;

 private:
  HalfEdge here(unsigned side) const { return half_edge(Face(detached_), side); }
  void meet(HalfEdge h, unsigned side) {
    const HalfEdge other = beyond_[h.index()];
    if (!other) return;
    twins[here(side).index()] = other;
    twins[other.index()] = here(side);
  }

  std::vector<HalfEdge> beyond_;  ///< the side of an earlier triangle that each was glued to
  std::uint32_t detached_ = 0;
};

}  // namespace clers::internal

#endif

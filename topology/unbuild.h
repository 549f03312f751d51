// Unbuilding at codec speed: unglue and detach on nothing but a table of twins.
//
// unglue is the operator of the paper, in any of its cases. detach(gate) is unglue(left side), then
// unglue(right side), each if it is not on the boundary, then destroy(face).
//
// Edgebreaker asks of the surface only whether an edge is on the boundary; "the neighbour is
// visited" is "the edge was unglued". Which case an unglue was (§5.1.2) is not needed to go on, and
// turns out later: Spirale Reversi meets it again from the other side.
#ifndef CLERS_TOPOLOGY_UNBUILD_H
#define CLERS_TOPOLOGY_UNBUILD_H

#include <cstdint>
#include <span>

#include "topology/ids.h"

namespace clers::internal {

/// Witness of operators that is not interested.
struct NoWitness {
  void unglue(HalfEdge) {}
  void destroy(Face) {}
};

/// The surface that is still there, by its twins; null on a boundary. It consumes the table.
/// Witness sees every operator (topology/mirror.h runs them on a full Surface).
template <class Witness>
class Unbuilding {
 public:
  Unbuilding(std::span<HalfEdge> twins, Witness& witness) : twins_(twins), witness_(&witness) {}

  std::span<const HalfEdge> twins() const { return twins_; }
  HalfEdge sym(HalfEdge h) const { return twins_[h.index()]; }
  bool is_boundary(HalfEdge h) const { return !sym(h); }

  /// A destroyed face keeps this in place of the twin of its first half-edge.
  static constexpr HalfEdge destroyed_mark = HalfEdge(HalfEdge::null_index - 1);
  bool is_destroyed(Face f) const { return twins_[half_edge(f, 0).index()] == destroyed_mark; }

  /// Makes two boundary edges of an interior one (any case; O(1)).
  /// Precondition: h is not on the boundary.
  void unglue(HalfEdge h) {
    witness_->unglue(h);
    twins_[sym(h).index()] = HalfEdge();
    twins_[h.index()] = HalfEdge();
  }

  /// And this, from detach, in place of the next one's.
  HalfEdge note(Face f) const { return twins_[half_edge(f, 1).index()]; }

  /// Paper §6.4, with the destroy after the loop. The side left of the gate goes first, then the
  /// one right of it: the opposite order of attach, then zip or glue. The face keeps a note.
  /// Precondition: the gate is on the boundary.
  void detach(HalfEdge gate, HalfEdge note) {
    const HalfEdge left_side = lprev(gate), right_side = lnext(gate);
    if (!is_boundary(left_side)) unglue(left_side);
    if (!is_boundary(right_side)) unglue(right_side);
    const Face f = left(gate);
    witness_->destroy(f);
    twins_[half_edge(f, 0).index()] = destroyed_mark;
    twins_[half_edge(f, 1).index()] = note;
  }

 private:
  std::span<HalfEdge> twins_;
  Witness* witness_;
};

}  // namespace clers::internal

#endif

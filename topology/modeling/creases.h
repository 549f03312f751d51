// Edges that stay sharp when a surface is subdivided.
#ifndef CLERS_TOPOLOGY_MODELING_CREASES_H
#define CLERS_TOPOLOGY_MODELING_CREASES_H

#include <array>
#include <cstdint>
#include <vector>

#include "topology/follow.h"
#include "topology/surface.h"

namespace clers {

/// A set of edges, the creases, that follows the operators (follow.h): the parts of a split edge
/// are creases if the edge was. The boundary is sharp without being marked: schemes treat both
/// alike, as curves of their own that what is beside them does not pull at.
class Creases {
 public:
  void mark(const Surface& surface, HalfEdge h);
  bool any() const { return any_; }

  bool is_sharp(const Surface& surface, HalfEdge h) const {
    return surface.is_boundary(h) || (h.index() < sharp_.size() && sharp_[h.index()] != 0);
  }

  void operator()(const Change& change);

  // The operators, told to this set unless it is empty.
  auto split(Surface& surface, HalfEdge h, Point p) {
    return any_ ? clers::split(surface, h, p, *this) : surface.split(h, p);
  }
  auto split(Surface& surface, Face f, Point p) {
    return any_ ? clers::split(surface, f, p, *this) : surface.split(f, p);
  }
  auto flip(Surface& surface, HalfEdge h) {
    return any_ ? clers::flip(surface, h, *this) : surface.flip(h);
  }

 private:
  std::vector<std::uint8_t> sharp_;  // by half-edge
  bool any_ = false;
};

/// The sharp edges at a vertex: none or one (a dart ends there) and it is smooth, two and a curve
/// runs through it, more and it is a corner, which stays.
struct SharpEdges {
  unsigned count = 0;
  std::array<HalfEdge, 2> edges;  ///< the first two
  std::array<Vertex, 2> ends;     ///< the other ends of those

  bool smooth() const { return count < 2; }
  bool curve() const { return count == 2; }
};
SharpEdges sharp_edges(const Surface& surface, const Creases& creases, Vertex v);

/// One half-edge of every edge, in their order: that without a twin, or the lower of the two.
std::vector<HalfEdge> edges_of(const Surface& surface);

}  // namespace clers

#endif

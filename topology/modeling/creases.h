// Edges that stay sharp when a surface is subdivided.
#ifndef CLERS_TOPOLOGY_MODELING_CREASES_H
#define CLERS_TOPOLOGY_MODELING_CREASES_H

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <clers/topology/export.h>
#include <clers/topology/follow.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// A set of edges, the creases, that observes the operators (follow.h): the parts of a split edge
/// are creases if the edge was. The boundary is sharp without being marked: schemes treat both
/// alike, as curves whose points depend on points of the curve only.
class Creases {
 public:
  void mark(const Surface& surface, HalfEdge h);
  bool any() const { return any_; }

  bool is_sharp(const Surface& surface, HalfEdge h) const {
    return surface.is_boundary(h) || (h.index() < sharp_.size() && sharp_[h.index()] != 0);
  }

  /// Unmarks the creases at a vertex, and returns their other ends.
  std::vector<Vertex> unmark(const Surface& surface, Vertex v);

  void operator()(const Change& change);

  // The operators, observed by this set unless it is empty.
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

/// The sharp edges at a vertex. With none or one (a crease ends there) the vertex is smooth, with
/// two a curve runs through it, with more it is a corner, which stays where it is.
struct SharpEdges {
  unsigned count = 0;
  std::array<HalfEdge, 2> edges;  ///< the first two
  std::array<Vertex, 2> ends;     ///< the other ends of those

  bool smooth() const { return count < 2; }
  bool curve() const { return count == 2; }
};
SharpEdges sharp_edges(const Surface& surface, const Creases& creases, Vertex v);

/// A list of surface.edges(), for loops that change the surface.
std::vector<HalfEdge> edges_of(const Surface& surface);

/// All faces, those of the newest vertices first: the order in which steps of subdivision go. A
/// step leaves a part of every old face where it was and appends the others, and new vertices, in
/// the order in which it goes. In the order of faces, a sweep over the surface leaves two behind,
/// those two four, and so on, until neighbours are far apart in memory. But the vertices that a
/// step has made are in one sweep, and every face has one.
std::vector<Face> newest_faces(const Surface& surface);
/// All vertices and all edges, of all faces in this order.
std::vector<Vertex> vertices_along(const Surface& surface, std::span<const Face> faces);
std::vector<HalfEdge> edges_along(const Surface& surface, std::span<const Face> faces);

}  // namespace clers

#endif

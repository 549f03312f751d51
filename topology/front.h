// The active boundary of a surface under construction: attach, zip and glue at codec speed.
//
// Spirale Reversi (CAGD 2010, §7.2, Algorithm 3) only ever works at one boundary edge, the gate. So
// the fast form of the handle operators (§5.1) keeps nothing but the boundary: for every vertex on
// it the vertex before, and how many triangles the vertex has so far. The gate lives in registers.
//
//            built surface                        built surface
//      .--<--.     .--<--.                  .--<--.           .--<--.
//           prev(x)                              prev(x)
//              \                                    \  <- zipped by C
//               x ====gate====> y  ...               \ . . . . . y ...
//              (outside)                            new gate: prev(x) -> y
//
// A boundary half-edge x->y has the surface on its left. The gate's own edge is not in the ring:
// the link of y is stale until the gate moves away, and walks must not cross it.
//
// Each move is operators of the paper in one step. With g the gate x -> y and f the new triangle:
//
//     create             create(f)                                                  E
//     attach_zip         attach(g), then zip(left side of f, edge into x)           C
//     attach_keep_left   attach(g)                                                  L
//     attach_keep_right  attach(g)                                                  R
//     attach_glue        attach(g), then glue(p -> q, left side of f): type 1       S
//     close              glue(g, edge into x): type 2
//
// where attach(g) is create(f), then glue(g, a side of f): type 1a. Every move also names the
// half-edges it joins to a Pairing, a policy that does nothing in the codec's fast path
// (NoPairing), fills a table of twins (Opposites), or runs each operator on a full Surface with all
// its bookkeeping and compares (topology/mirror.h). One source, so what is proved of one holds for
// the others.
#ifndef CLERS_TOPOLOGY_FRONT_H
#define CLERS_TOPOLOGY_FRONT_H

#include <cstdint>
#include <span>

#include "topology/handle_case.h"
#include "topology/ids.h"

namespace clers::internal {

/// A vertex on the boundary. Once the vertex has left it, the codec keeps other things here.
struct FrontLink {
  std::uint32_t prev;     ///< the vertex before it on its boundary curve
  std::uint32_t valence;  ///< triangles it has so far
};

/// Pairing that is not interested.
struct NoPairing {
  struct Edge {};  ///< a boundary half-edge, as far as this policy wants to know it
  /// Operators, when they are done: a triangle on three new vertices from this one on; a triangle
  /// whose side is glued to the gate, and the vertex opposite; a glue. Returns side 0.
  Edge create(Face, Vertex) { return {}; }
  void attach(Face, unsigned, Edge, Vertex) {}
  void join(Edge, Edge, HandleCase) {}
  /// The boundary half-edge that arrives at a vertex, and a side of a triangle.
  Edge edge_into(Vertex) const { return {}; }
  void set_edge_into(Vertex, Edge) {}
  Edge side(Face, unsigned) const { return {}; }
  /// What the front is like when a move is done, and when a component is.
  template <class Gate>
  void moved(const FrontLink*, const Gate&) {}
  template <class Gate>
  void component_ends(const FrontLink*, const Gate&, std::span<const std::uint32_t>) {}
};

/// Operators on the boundary around one gate. A value type over memory of the caller: links for all
/// vertices that will be made. Preconditions are the caller's to check where stated: nothing here
/// looks at them.
template <class Pairing>
class Front {
 public:
  using Edge = typename Pairing::Edge;

  /// The boundary edge x -> y at which the next operator works.
  struct Gate {
    std::uint32_t x = 0, y = 0;    ///< vertices
    std::uint32_t kx = 0, ky = 0;  ///< their valences
    [[no_unique_address]] Edge edge;
  };

  /// Vertices of a new triangle; the first two are the ends of the new gate.
  struct Corners {
    std::uint32_t a, b, v;
  };

  Front(FrontLink* links, Pairing& pairing) : links_(links), pairing_(&pairing) {}

  std::uint32_t prev(std::uint32_t v) const { return links_[v].prev; }
  FrontLink* links() const { return links_; }

  // In each of these `f` is the new triangle, `c` receives its corners, and `n` is the first id of
  // as many new vertices as the operator makes. The new gate always is side 0 of f, from a to b.

  /// create(f): type 0 (§5.1.1), a component of one triangle on the vertices n, n+1, n+2 (E).
  Gate create(Face f, std::uint32_t n, Corners& c) {
    c = {n, n + 1, n + 2};
    const Edge gate = pairing_->create(f, Vertex(n));
    links_[n].prev = n + 2;
    links_[n + 2] = {n + 1, 1};
    pairing_->set_edge_into(Vertex(n), pairing_->side(f, 2));
    pairing_->set_edge_into(Vertex(n + 2), pairing_->side(f, 1));
    return moved({n, n + 1, 1, 1, gate});
  }

  /// attach(g), then zip(side 2 of f, the edge into x): closes x, whose predecessor becomes the
  /// gate's origin (C). Precondition: prev(x) != y.
  Gate attach_zip(Gate g, Face f, Corners& c) {
    const std::uint32_t p = links_[g.x].prev;
    c = {p, g.y, g.x};
    pairing_->attach(f, 1, g.edge, Vertex(p));
    pairing_->join(pairing_->side(f, 2), pairing_->edge_into(Vertex(g.x)), HandleCase::zip);
    return moved({p, g.y, links_[p].valence + 1, g.ky + 1, pairing_->side(f, 0)});
  }

  /// attach(g) with a new vertex n: the gate goes on from n to y, f's left side stays boundary (L).
  Gate attach_keep_left(Gate g, Face f, std::uint32_t n, Corners& c) {
    c = {n, g.y, g.x};
    pairing_->attach(f, 1, g.edge, Vertex(n));
    links_[n].prev = g.x;
    links_[g.x].valence = g.kx + 1;
    pairing_->set_edge_into(Vertex(n), pairing_->side(f, 2));
    return moved({n, g.y, 1, g.ky + 1, pairing_->side(f, 0)});
  }

  /// attach(g) with a new vertex n: the gate goes on from x to n, f's right side stays boundary
  /// (R).
  Gate attach_keep_right(Gate g, Face f, std::uint32_t n, Corners& c) {
    c = {g.x, n, g.y};
    pairing_->attach(f, 2, g.edge, Vertex(n));
    links_[g.y] = {n, g.ky + 1};
    pairing_->set_edge_into(Vertex(g.y), pairing_->side(f, 1));
    return moved({g.x, n, g.kx + 1, 1, pairing_->side(f, 0)});
  }

  /// attach(g), then glue(p -> q, side 2 of f): type 1 (S). x merges into q, of which it was a
  /// copy, and is dead afterwards; the caller keeps that. `kq` and `pq` are the valence of q and
  /// the edge p -> q, which a pending gate carries itself and other edges keep in the ring.
  ///
  ///        p --------> q                p . . . . . q
  ///                                 a= p \         / : x and q are one
  ///   ... prev(x) ---> x ===> y ---      new gate p ===> y
  ///
  /// Preconditions: p -> q is a boundary edge but not the gate, and x is not one of its ends; p is
  /// not y.
  Gate attach_glue(Gate g, Face f, std::uint32_t p, std::uint32_t kp, std::uint32_t q,
                   std::uint32_t kq, Edge pq, HandleCase as, Corners& c) {
    c = {p, g.y, g.x};
    pairing_->attach(f, 1, g.edge, Vertex(p));
    const Edge into_x = pairing_->edge_into(Vertex(g.x));
    pairing_->join(pq, pairing_->side(f, 2), as);
    links_[q] = {links_[g.x].prev, g.kx + kq + 1};
    pairing_->set_edge_into(Vertex(q), into_x);
    return moved({p, g.y, kp + 1, g.ky + 1, pairing_->side(f, 0)});
  }

  /// glue(g, the edge into x): type 2 (§5.1.1), which closes a curve of two edges. Precondition:
  /// prev(x) == y.
  void close(Gate g) {
    pairing_->join(g.edge, pairing_->edge_into(Vertex(g.x)), HandleCase::close);
  }

  /// No operator: nothing will be built at the gate any more, nor at a hole, of each of which a
  /// vertex is given. Before close, if that comes.
  void end_component(Gate g, std::span<const std::uint32_t> holes) {
    pairing_->component_ends(links_, g, holes);
  }

  Edge edge_into(std::uint32_t v) const { return pairing_->edge_into(Vertex(v)); }

 private:
  Gate moved(Gate g) {
    pairing_->moved(links_, g);
    return g;
  }

  FrontLink* links_;
  Pairing* pairing_;
};

/// Pairing that fills a table of twins; half-edges are those of the faces in their order of making.
class Opposites {
 public:
  using Edge = HalfEdge;

  /// Memory for 3 half-edges a face and one entry a vertex; `twins` starts as null ids.
  Opposites(std::span<HalfEdge> twins, std::span<HalfEdge> into) : twins_(twins), into_(into) {}

  Edge create(Face f, Vertex) { return side(f, 0); }
  Edge edge_into(Vertex v) const { return into_[v.index()]; }
  void set_edge_into(Vertex v, Edge e) { into_[v.index()] = e; }
  Edge side(Face f, unsigned i) const { return half_edge(f, i); }
  void attach(Face f, unsigned i, Edge gate, Vertex) {
    join(side(f, i), gate, HandleCase::join_components);
  }
  void join(Edge a, Edge b, HandleCase) {
    twins_[a.index()] = b;
    twins_[b.index()] = a;
  }
  template <class Gate>
  void moved(const FrontLink*, const Gate&) {}
  template <class Gate>
  void component_ends(const FrontLink*, const Gate&, std::span<const std::uint32_t>) {}

 private:
  std::span<HalfEdge> twins_;
  std::span<HalfEdge> into_;
};

}  // namespace clers::internal

#endif

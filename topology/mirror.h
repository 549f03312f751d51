// Runs the codec's operators on a full Surface, with all its bookkeeping, beside the fast form.
//
// The front and the unbuilding (front.h, unbuild.h) say what each operator is; here the surface
// finds out for itself, and what it finds must agree: the case of every glue, the points of the
// vertices that merge, and the boundary curves, link by link. Used by tests and by builds with
// CLERS_BOOKKEEPING.
#ifndef CLERS_TOPOLOGY_MIRROR_H
#define CLERS_TOPOLOGY_MIRROR_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "topology/front.h"
#include "topology/handle_case.h"
#include "topology/ids.h"
#include "topology/surface.h"
#include "topology/validate.h"

namespace clers::internal {

/// Handle operators in the order in which they were applied, building or unbuilding: the numbers of
/// HandleCase, and this for create and destroy.
using OperatorTrace = std::vector<std::uint8_t>;
inline constexpr std::uint8_t create_or_destroy = 0xff;

/// Operators of a trace that builds, as coordinates of the paper's basis (§5.1.3).
inline OperatorCounts count_operators(const OperatorTrace& trace) {
  OperatorCounts counts;
  for (const std::uint8_t step : trace) {
    if (step == create_or_destroy)
      ++counts.create;
    else
      counts.add(static_cast<HandleCase>(step));
  }
  return counts;
}

/// Pairing (see front.h) that only writes down what the front says it does.
class Tracing {
 public:
  struct Edge {};
  Edge create(Face, Vertex) {
    trace.push_back(create_or_destroy);
    return {};
  }
  Edge edge_into(Vertex) const { return {}; }
  void set_edge_into(Vertex, Edge) {}
  Edge side(Face, unsigned) const { return {}; }
  void attach(Face f, unsigned, Edge gate, Vertex apex) {
    create(f, apex);
    join(gate, gate, HandleCase::join_components);
  }
  void join(Edge, Edge, HandleCase as) { trace.push_back(static_cast<std::uint8_t>(as)); }
  template <class Gate>
  void moved(const FrontLink*, const Gate&) {}
  template <class Gate>
  void component_ends(const FrontLink*, const Gate&, std::span<const std::uint32_t>) {}

  OperatorTrace trace;
};

/// Validates a surface after every operator while it is small, and then so rarely that the cost an
/// operator stays that of looking at sixteen faces.
class Validating {
 public:
  bool valid_now_and_then(const Surface& surface) {
    if (++operators_ < surface.characteristic().f / 16) return true;
    operators_ = 0;
    return validate(surface, 1).empty();
  }

 private:
  std::int64_t operators_ = 0;
};

/// Pairing that applies every operator to a surface.
///
/// A vertex of the front is a point of the surface (Appendix A): the vertices that S merges are
/// copies of one vertex, and the surface's has the point of the one that is kept.
class BuildingMirror {
 public:
  using Edge = HalfEdge;

  /// Room for so many vertex ids of the front.
  explicit BuildingMirror(std::size_t vertex_ids) : into_(vertex_ids) {}

  Edge create(Face f, Vertex n) {
    make(f, point_of(n.index()), point_of(n.index() + 1), point_of(n.index() + 2));
    return side(f, 0);
  }
  void attach(Face f, unsigned i, Edge gate, Vertex apex) {
    if (!agrees) return;
    Point points[3];
    points[i] = surface.point(surface.dest(gate));
    points[(i + 1) % 3] = surface.point(surface.org(gate));
    points[(i + 2) % 3] = point_of(apex.index());
    make(f, points[0], points[1], points[2]);
    join(gate, side(f, i), HandleCase::join_components);
  }
  /// Vertices that merge have one point; but S merges the origin of b into the end of a, two copies
  /// of which only one is to be found on the front any more.
  void join(Edge a, Edge b, HandleCase as) {
    if (!agrees || !surface.is_live(a) || !surface.is_live(b)) return agree(false);
    agree(point(surface.org(a)) == point(surface.dest(b)));
    if (as == HandleCase::zip || as == HandleCase::close)
      agree(point(surface.dest(a)) == point(surface.org(b)));
    const auto found = surface.glue(a, b);
    if (!found) return agree(false);
    agree(*found == as || in_another_order(as, *found));
    trace.push_back(static_cast<std::uint8_t>(*found));
    validate_now_and_then();
  }

  Edge edge_into(Vertex v) const { return into_[v.index()]; }
  void set_edge_into(Vertex v, Edge e) { into_[v.index()] = e; }
  Edge side(Face f, unsigned i) const { return half_edge(f, i); }

  /// The gate's curve is that of the front, link by link: all of it while curves are short, and
  /// then so often that the cost an operator stays that of sixteen links; near the gate, where the
  /// next operator reads it, always.
  template <class Gate>
  void moved(const FrontLink* links, const Gate& gate) {
    if (!is_at(gate)) return agree(false);
    const std::uint32_t length = surface.length(surface.curve(gate.edge));
    links_unseen_ += 16;
    const bool whole = links_unseen_ >= length;
    if (whole) links_unseen_ = 0;
    agree(same_links(links, gate.edge, gate.x, gate.y,
                     whole ? length - 1 : std::min(length - 1, 4u)));
  }
  /// All that is left of the component's boundary, and nothing is owed: see in_another_order.
  template <class Gate>
  void component_ends(const FrontLink* links, const Gate& gate,
                      std::span<const std::uint32_t> holes) {
    if (!is_at(gate)) return agree(false);
    agree(owed_ == 0);
    const std::uint32_t length = surface.length(surface.curve(gate.edge));
    agree(same_links(links, gate.edge, gate.x, gate.y, length - 1));
    for (const std::uint32_t hole : holes) {
      if (!is_boundary(into_[hole])) return agree(false);
      const HalfEdge from_hole = surface.boundary_next(into_[hole]);
      agree(same_links(links, from_hole, hole, hole, surface.length(surface.curve(from_hole))));
    }
  }

  /// Are these the surface's vertices, by corner, those of the last face first: equal numbers where
  /// corners are at one vertex, and only there?
  bool same_vertices(std::span<const std::uint32_t> corners) const {
    constexpr std::uint32_t none = 0xffffffffu;
    const auto faces = static_cast<std::uint32_t>(corners.size() / 3);
    if (surface.characteristic().f != faces) return false;
    std::vector<std::uint32_t> number(surface.vertex_limit(), none);
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t f = 0; f < faces; ++f)
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t n = corners[3 * std::size_t{faces - 1 - f} + i];
        std::uint32_t& known = number[surface.org(half_edge(Face(f), i)).index()];
        if (known == none) numbers.push_back(known = n);
        if (known != n) return false;
      }
    std::sort(numbers.begin(), numbers.end());
    return std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end();
  }

  Surface surface;
  OperatorTrace trace;  ///< what the surface found each operator to be
  bool agrees = true;   ///< with what the front said; and valid whenever it was looked at

 private:
  static Point point_of(std::uint32_t front_vertex) { return Point(front_vertex); }
  Point point(Vertex v) const { return surface.point(v); }
  void agree(bool yes) { agrees = agrees && yes; }
  void validate_now_and_then() { agree(validating_.valid_now_and_then(surface)); }
  bool is_boundary(HalfEdge h) const { return surface.is_live(h) && surface.is_boundary(h); }

  void make(Face f, Point p0, Point p1, Point p2) {
    if (!agrees) return;
    const auto made = surface.create(p0, p1, p2);
    agree(made.ok() && *made == f);
    trace.push_back(create_or_destroy);
    validate_now_and_then();
  }

  /// A handle may join a curve that was split off in a part that an S has yet to join. Then that
  /// glue joins the components (1a), and the S, which finds them one, makes the handle (1c): the
  /// same two operators in the other order.
  bool in_another_order(HandleCase as, HandleCase found) {
    if (as == HandleCase::join_curves && found == HandleCase::join_components) {
      ++owed_;
      return true;
    }
    if (as == HandleCase::join_components && found == HandleCase::join_curves) {
      --owed_;
      return owed_ >= 0;
    }
    return false;
  }

  template <class Gate>
  bool is_at(const Gate& gate) const {
    return agrees && is_boundary(gate.edge) && point(surface.org(gate.edge)) == point_of(gate.x) &&
           point(surface.dest(gate.edge)) == point_of(gate.y);
  }

  /// From the boundary half-edge h, which leaves the front's vertex v, back along its curve: is the
  /// half-edge before that which arrives at v, and does it come from the vertex that v's link says?
  /// A whole curve ends at `last`.
  bool same_links(const FrontLink* links, HalfEdge h, std::uint32_t v, std::uint32_t last,
                  std::uint32_t count) const {
    const bool whole = count + 1 >= surface.length(surface.curve(h));
    for (; count > 0; --count) {
      const HalfEdge before = surface.boundary_prev(h);
      if (before != into_[v] || point(surface.org(before)) != point_of(links[v].prev)) return false;
      h = before;
      v = links[v].prev;
    }
    return !whole || v == last;
  }

  Validating validating_;
  std::vector<HalfEdge> into_;  ///< by vertex of the front
  std::uint32_t links_unseen_ = 0;
  std::int64_t owed_ = 0;  ///< handles that an S will make in place of joining components
};

/// Witness (see unbuild.h) that applies every operator to a surface.
class UnbuildingMirror {
 public:
  explicit UnbuildingMirror(Surface whole) : surface(std::move(whole)) {}

  void unglue(HalfEdge h, HalfEdge, unsigned) {
    const auto found = surface.unglue(h);
    agree(found.ok());
    if (found) trace.push_back(static_cast<std::uint8_t>(*found));
    validate_now_and_then();
  }
  void cut_ear(HalfEdge, HalfEdge) { agree(false); }  // its faces are triangles
  void destroy(HalfEdge gate, HalfEdge, HalfEdge) {
    agree(surface.destroy(left(gate)).ok());
    trace.push_back(create_or_destroy);
    validate_now_and_then();
  }

  Surface surface;
  OperatorTrace trace;
  bool agrees = true;

 private:
  void agree(bool yes) { agrees = agrees && yes; }
  void validate_now_and_then() { agree(validating_.valid_now_and_then(surface)); }

  Validating validating_;
};

}  // namespace clers::internal

#endif

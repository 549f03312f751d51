// Runs the codec's operators on a full Surface, with all its bookkeeping, beside the fast form.
//
// The front and the unbuilding (front.h, unbuild.h) say what each operator is; here the surface
// finds out for itself, and what it finds must agree. Used by tests and by builds with
// CLERS_BOOKKEEPING.
#ifndef CLERS_TOPOLOGY_MIRROR_H
#define CLERS_TOPOLOGY_MIRROR_H

#include <cstdint>
#include <utility>
#include <vector>

#include "topology/handle_case.h"
#include "topology/ids.h"
#include "topology/surface.h"
#include "topology/validate.h"

namespace clers {

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
  Edge create(Face) {
    trace.push_back(create_or_destroy);
    return {};
  }
  Edge edge_into(Vertex) const { return {}; }
  void set_edge_into(Vertex, Edge) {}
  Edge side(Face, unsigned) const { return {}; }
  void attach(Face f, unsigned, Edge gate) {
    create(f);
    join(gate, gate, HandleCase::join_components);
  }
  void join(Edge, Edge, HandleCase as) { trace.push_back(static_cast<std::uint8_t>(as)); }

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
class BuildingMirror {
 public:
  using Edge = HalfEdge;

  /// Room for so many vertex ids of the front.
  explicit BuildingMirror(std::size_t vertex_ids) : into_(vertex_ids) {}

  Edge create(Face f) {
    const auto made = surface.create(Point(0), Point(0), Point(0));
    agree(made.ok() && *made == f);
    trace.push_back(create_or_destroy);
    validate_now_and_then();
    return side(f, 0);
  }
  Edge edge_into(Vertex v) const { return into_[v.index()]; }
  void set_edge_into(Vertex v, Edge e) { into_[v.index()] = e; }
  Edge side(Face f, unsigned i) const { return half_edge(f, i); }
  void attach(Face f, unsigned i, Edge gate) {
    create(f);
    join(gate, side(f, i), HandleCase::join_components);
  }
  void join(Edge a, Edge b, HandleCase as) {
    const auto found = surface.glue(a, b);
    agree(found.ok() && *found == as);
    if (found) trace.push_back(static_cast<std::uint8_t>(*found));
    validate_now_and_then();
  }

  Surface surface;
  OperatorTrace trace;  ///< what the surface found each operator to be
  bool agrees = true;   ///< with what the front said; and valid whenever it was looked at

 private:
  void agree(bool yes) { agrees = agrees && yes; }
  void validate_now_and_then() { agree(validating_.valid_now_and_then(surface)); }

  Validating validating_;
  std::vector<HalfEdge> into_;
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

}  // namespace clers

#endif

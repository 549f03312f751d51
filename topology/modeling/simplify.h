// Simplification of triangle meshes by flips and welds (Topological mesh operators, §7.4).
//
// Algorithm 5 of the paper with edges in its queue. An edge is contracted as Fig. 16 removes a
// vertex, by flips until a weld can take it (`collapse`, stellar.h). In a four-face cluster
// (clusters.h) the flips stop at four edges and the shape of triangles chooses among them: what is
// left is a good triangulation of the same hole, by vertices that stay. Here they go on to the
// vertex that the other is merged into, since that one then moves to where the error is least.
// Error and place are those of Lindstrom and Turk (1998), see placement.h.
#ifndef CLERS_TOPOLOGY_MODELING_SIMPLIFY_H
#define CLERS_TOPOLOGY_MODELING_SIMPLIFY_H

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <clers/modeling/creases.h>
#include <clers/topology/export.h>
#include <clers/topology/stellar.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

using Position3 = std::array<double, 3>;

struct SimplifyOptions {
  /// Ends at this many faces or fewer.
  std::int64_t faces = 0;
  /// No edge is contracted if that would take the surface farther than this, in units of the
  /// positions, from where it was. See SimplifyResult::error.
  double error = std::numeric_limits<double>::infinity();
  /// How much the mean square of the edges at a new vertex, as far as it is more than round
  /// triangles of that area have, counts beside the mean square of its distances from the planes
  /// that were there. The default decides nothing but where a vertex goes on a flat face, and gives
  /// the least error; 1e-3 .. 4e-3: rounder triangles, at an error that is 1.1 to 1.5 times as
  /// large, of machine parts up to six times.
  double shape = 1e-9;
};

enum class SimplifyEnd : std::uint8_t {
  faces,     ///< as few as were asked for
  error,     ///< whatever else could go would take the surface too far
  smallest,  ///< nothing can go that keeps topology, creases and the sides of faces
};

struct SimplifyResult {
  std::uint64_t contracted = 0;  ///< edges, and so vertices that are gone
  /// How far the surface has moved, in units of the positions, by an estimate that mostly is too
  /// large: each contraction adds the greatest distance of the new vertex from a plane, or a
  /// crease, of the triangles that it replaces, and of the old vertices from the new triangles, to
  /// what these had moved already.
  double error = 0;
  SimplifyEnd ended = SimplifyEnd::faces;
};

enum class SimplifyRule : std::uint8_t {
  option,             ///< faces, error and shape are numbers of 0 or more
  position_count,     ///< as many positions as vertex_limit(), or more
  position_in_range,  ///< of every live vertex: finite, below 1e100 in size
};
struct SimplifyFault {
  SimplifyRule rule;
  std::uint32_t vertex = 0;  ///< of the first position that breaks it
};

/// An edge that goes, and what that means for values of its ends.
struct Contraction {
  HalfEdge edge;  ///< of which collapse() makes one vertex
  Vertex kept, gone;
  /// Of `gone` in values of the vertex that is kept, 0 .. 1: value(kept) = (1 - weight) value(kept)
  /// + weight value(gone). It is where the new place is along the edge.
  double weight = 0;
  Position3 place{};  ///< of the vertex that is kept
  double error = 0;   ///< how far the surface has moved here
};

/// Which edge goes next: the queue of simplify(), for whoever applies the operators himself.
///
///     while (const auto c = simplification.next()) {
///       contract(surface, creases, *c);
///       simplification.contracted(*c);
///     }
///
/// Surface, positions and creases are the caller's, and stay where they are as long as this lives.
/// Nothing else may change the surface meanwhile. Preconditions: `refuse` has nothing to say.
/// Memory: some 250 bytes a vertex.
class Simplification {
 public:
  static std::optional<SimplifyFault> refuse(const Surface& surface,
                                             std::span<const Position3> positions,
                                             const SimplifyOptions& options);

  Simplification(const Surface& surface, std::vector<Position3>& positions, const Creases& creases,
                 const SimplifyOptions& options);
  Simplification(Simplification&&) noexcept;
  Simplification& operator=(Simplification&&) noexcept;
  ~Simplification();

  /// The cheapest contraction, or nothing: then result() says why. Amortised O(degree^2 log V).
  std::optional<Contraction> next();
  /// The surface has changed by it: sets the position of the vertex that is kept.
  void contracted(const Contraction& c);
  const SimplifyResult& result() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Contracts the edge, and lets the creases follow. `observer` as of collapse().
template <class Observer = NoObserver>
void contract(Surface& surface, Creases& creases, const Contraction& c, Observer&& observer = {}) {
  if (!creases.any()) {
    (void)collapse(surface, c.edge, observer);
    return;
  }
  const std::vector<Vertex> ends = creases.unmark(surface, c.gone);
  (void)collapse(surface, c.edge, [&](const Change& change) {
    if constexpr (observes<Observer>) observer(change);
    creases(change);
  });
  // They have another end now: a flip turns an edge elsewhere.
  for (const HalfEdge h : surface.star(c.kept))
    for (const Vertex end : ends)
      if (surface.other_end(h, c.kept) == end) creases.mark(surface, h);
}

/// Makes a mesh of fewer faces near the same surface, by contracting one edge after the other, the
/// cheapest first.
///
/// Topology stays: components, boundary curves, genus (link_condition). Creases and the boundary
/// stay curves: an edge of one is contracted to where curve and planes are near, a smooth vertex
/// only into one of a curve, and vertices where other than two sharp edges meet stay where they
/// are. No face that stays turns over, by more than 78 degrees in one step. Faces without area may
/// go and be changed, never made.
///
/// `positions` are by vertex; those of live vertices are changed, where they move. `told` is called
/// with each Contraction before it is applied, to carry values along. `observer` is that of
/// operators (follow.h).
///
/// Errors: a SimplifyFault, nothing changed. Throws std::bad_alloc: surface, positions and creases
/// then are those of some step. Ids: those of vertices and faces that are gone are freed; a vertex
/// that stays where it is keeps its id but on the boundary. Deterministic. Cost: O(V log V) where
/// degrees are bounded.
template <class Told, class Observer = NoObserver>
Result<SimplifyResult, SimplifyFault> simplify(Surface& surface, std::vector<Position3>& positions,
                                               Creases& creases, const SimplifyOptions& options,
                                               Told&& told, Observer&& observer = {}) {
  if (const auto why = Simplification::refuse(surface, positions, options)) return Failure{*why};
  Simplification simplification(surface, positions, creases, options);
  while (const auto c = simplification.next()) {
    told(*c);
    contract(surface, creases, *c, observer);
    simplification.contracted(*c);
  }
  return simplification.result();
}
inline Result<SimplifyResult, SimplifyFault> simplify(Surface& surface,
                                                      std::vector<Position3>& positions,
                                                      Creases& creases,
                                                      const SimplifyOptions& options) {
  return simplify(surface, positions, creases, options, [](const Contraction&) {});
}
inline Result<SimplifyResult, SimplifyFault> simplify(Surface& surface,
                                                      std::vector<Position3>& positions,
                                                      const SimplifyOptions& options) {
  Creases none;
  return simplify(surface, positions, none, options);
}

}  // namespace clers

#endif

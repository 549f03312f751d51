// Four-face clusters: simplification by vertices that stay (Topological mesh operators, §7.4).
#ifndef CLERS_TOPOLOGY_MODELING_CLUSTERS_H
#define CLERS_TOPOLOGY_MODELING_CLUSTERS_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <clers/modeling/creases.h>
#include <clers/modeling/simplify.h>
#include <clers/topology/export.h>
#include <clers/topology/stellar.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

struct ClusterOptions {
  /// Ends at this many faces or fewer.
  std::int64_t faces = 0;
  /// Vertices whose quadrics say more than this stay, in units of the positions.
  double error = std::numeric_limits<double>::infinity();
};

/// A vertex that goes, and what triangles take its place.
struct Removal {
  Vertex vertex;
  std::uint32_t degree = 4;  ///< at which a weld takes it: 4, or 3
  /// Its neighbours whose edges are flipped away until then, in this order.
  std::vector<Vertex> ears;
  /// The ends of the edge in the middle of what was a cluster of four faces, else null.
  std::array<Vertex, 2> diagonal;
  double error = 0;  ///< how far from the surface, as the quadrics say
};

/// Which vertex goes next: the queue of Algorithm 5. As Simplification (simplify.h) is used.
///
/// A step of the hierarchy removes vertices that share no face: when one goes, its neighbours are
/// marked until the next. Of those that may go, the half with the least errors is put into the
/// queue, so that a step does not take what others should have gone before.
///
/// Surface, positions and creases are the caller's; nothing else may change the surface meanwhile.
/// Memory: some 150 bytes a vertex.
class ClusterSimplification {
 public:
  static std::optional<SimplifyFault> refuse(const Surface& surface,
                                             std::span<const Position3> positions,
                                             const ClusterOptions& options);

  ClusterSimplification(const Surface& surface, std::span<const Position3> positions,
                        const Creases& creases, const ClusterOptions& options);
  ClusterSimplification(ClusterSimplification&&) noexcept;
  ClusterSimplification& operator=(ClusterSimplification&&) noexcept;
  ~ClusterSimplification();

  /// The next vertex, or nothing: then result() says why. Amortised O(degree^2 log V).
  std::optional<Removal> next();
  /// It was removed.
  void removed(const Removal& r);
  /// `contracted` counts the vertices that are gone.
  const SimplifyResult& result() const;
  /// Steps that were begun: N of the paper.
  std::uint32_t steps() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Fig. 16: flips, and a weld. If the weld leaves the other diagonal, that is flipped too. The
/// creases follow.
template <class Observer = NoObserver>
void remove(Surface& surface, Creases& creases, const Removal& r, Observer&& observer = {}) {
  const auto follow = [&](const Change& change) {
    if constexpr (observes<Observer>) observer(change);
    if (creases.any()) creases(change);
  };
  const auto place = [&](const Surface& s, HalfEdge h) {
    return std::find(r.ears.begin(), r.ears.end(), s.dest(h)) - r.ears.begin();
  };
  const auto welded = remove(surface, r.vertex, r.degree, place, follow);
  if (!welded || !r.diagonal[0]) return;
  const Vertex a = surface.org(welded->at);
  if (a != r.diagonal[0] && a != r.diagonal[1]) (void)flip(surface, welded->at, follow);
}

/// Removes vertices by Algorithm 5 until there are so few faces, and moves none: what is left are
/// vertices of the mesh that was. Triangles are rounder than those of simplify() by error alone,
/// and about twice as far from the surface.
///
///     two flips              and a weld           The edges that are flipped, and which of the
///      .---.       .---.       .---.              two diagonals stays, are those that make round
///     / \ / \     /  / |\     /  / |\             triangles near the surface.
///    .---v---. ->.  v--.-. ->. /   . .
///     \ / \ /     \  \ |/     \    |/
///      .---.       .---.       .---.
///
/// Topology stays, and no two edges come to join the same vertices. Vertices of creases stay; those
/// of the boundary go where it is straight enough. No triangle turns away from the mean normal of
/// those it replaces by more than 78 degrees.
///
/// Errors: a SimplifyFault, nothing changed. Throws std::bad_alloc: the surface then is that of
/// some removal. Ids: as of remove(). Deterministic. Cost: O(V log V) where degrees are bounded.
template <class Observer = NoObserver>
Result<SimplifyResult, SimplifyFault> simplify_by_clusters(Surface& surface,
                                                           std::span<const Position3> positions,
                                                           Creases& creases,
                                                           const ClusterOptions& options,
                                                           Observer&& observer = {}) {
  if (const auto why = ClusterSimplification::refuse(surface, positions, options))
    return Failure{*why};
  ClusterSimplification clusters(surface, positions, creases, options);
  while (const auto r = clusters.next()) {
    remove(surface, creases, *r, observer);
    clusters.removed(*r);
  }
  return clusters.result();
}

}  // namespace clers

#endif

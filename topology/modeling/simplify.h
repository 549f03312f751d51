// Simplification of triangle meshes by flips and welds (Topological mesh operators, §7.4).
#ifndef CLERS_TOPOLOGY_MODELING_SIMPLIFY_H
#define CLERS_TOPOLOGY_MODELING_SIMPLIFY_H

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include <clers/topology/export.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

using Position3 = std::array<double, 3>;

struct SimplifyOptions {
  /// Ends at this many faces or fewer.
  std::int64_t faces = 0;
  /// No vertex goes if that would take the surface farther than this from where it was, by an
  /// estimate that adds up what each step does to its neighbourhood.
  double error = std::numeric_limits<double>::infinity();
  /// How much round stars count beside a small error.
  double shape = 1e-3;
};

struct SimplifyReport {
  std::uint64_t removed = 0;
  double error = 0;  ///< the greatest estimate
};

SimplifyReport simplify(Surface& surface, std::vector<Position3>& at, const SimplifyOptions& options);

}  // namespace clers

#endif

// Theorem 11 as a procedure: what a surface is built of.
#ifndef CLERS_TOPOLOGY_HANDLEBODY_H
#define CLERS_TOPOLOGY_HANDLEBODY_H

#include <array>
#include <vector>

#include <clers/topology/export.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// A handlebody decomposition (Theorem 4): triangles, and then the glues in the order that builds.
struct Handlebody {
  struct Triangle {
    Face face;  ///< its id in the surface that was unbuilt; `gluings` speaks of its half-edges
    std::array<Point, 3> points;
  };
  struct Gluing {
    HandleCase kind = HandleCase::zip;
    HalfEdge h0, h1;
  };

  std::vector<Triangle> triangles;
  std::vector<Gluing> gluings;

  /// How many operators of each kind; their Λ is the characteristic of what they build.
  OperatorCounts counts() const;
};

/// Unbuilds a surface down to nothing as the proof of Theorem 11 does: unglues every interior edge,
/// in the order of half-edges, then destroys every face. Returns the reverse of what it did. The
/// cost is that of the operators: O(F log F) if every cut that may separate falls on genus 0.
Handlebody unbuild(Surface& surface);

/// Builds what `unbuild` unbuilt, by create and glue: a surface equivalent to it, on the same
/// points. Errors: the first precondition that does not hold, if the handlebody is not from
/// unbuild.
Result<Surface, Violation> build(const Handlebody& handlebody);

}  // namespace clers

#endif

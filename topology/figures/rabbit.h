// A rabbit, to be meshed: an implicit surface, sampled by projection along its gradient.
#ifndef CLERS_TOPOLOGY_FIGURES_RABBIT_H
#define CLERS_TOPOLOGY_FIGURES_RABBIT_H

#include <cstdint>
#include <vector>

#include "topology/figures/vector.h"

namespace clers::figures {

/// Where this is 0: the surface of some ellipsoids that melt into each other. Positive outside. x
/// is forward, z up.
struct Rabbit {
  struct Potential {
    double value;
    Vector gradient;
  };
  static Potential potential(const Vector& p);

  /// The point of the surface that is reached from here along the gradient.
  static Vector project(Vector p);

  /// The sampling function: between two points of the surface.
  Vector operator()(const Vector& a, const Vector& b) const { return project(0.5 * (a + b)); }

  /// The domain: the sides of some cubes, near the surface.
  struct Cubes {
    std::vector<Vector> at;
    std::vector<std::uint32_t> quads;  ///< four corners each, counterclockwise
  };
  static Cubes cubes();
};

}  // namespace clers::figures

#endif

// Adaptive meshes in the plane, and how they are drawn.
#ifndef CLERS_TOPOLOGY_FIGURES_PLANE_H
#define CLERS_TOPOLOGY_FIGURES_PLANE_H

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "topology/figures/scene.h"
#include "topology/modeling/adaptive_mesh.h"

namespace clers::figures {

inline Place mix(const Place& a, const Place& b, double k) {
  return {a.x + k * (b.x - a.x), a.y + k * (b.y - a.y), 0};
}
inline Place middle(const Place& a, const Place& b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2, 0};
}
inline double distance(const Place& a, const Place& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

struct Middle {
  Place operator()(const Place& a, const Place& b) const { return middle(a, b); }
};
using Plane = AdaptiveMesh<Place, Middle>;

/// Of quadrilaterals, which are its blocks.
Plane plane_of(const std::vector<std::array<std::uint32_t, 4>>& quads, std::vector<Place> at);
/// Three quadrilaterals about a vertex.
Plane hexagon();

/// As it is now, split edges of blocks dashed.
Scene scene_of(const Plane& plane);

/// The edge between two places, null if there is none.
HalfEdge find(const Scene& s, const std::array<Place, 2>& ends);
/// The same where there must be one.
HalfEdge between(const Scene& s, const std::array<Place, 2>& ends);

}  // namespace clers::figures

#endif

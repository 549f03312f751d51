// Figures of adaptive meshes in space (Topological mesh operators, Fig. 19; Dynamic adaptive
// meshes, Fig. 11 and §6).
#include <algorithm>
#include <array>
#include <numbers>

#include "topology/figures/deforming_sphere.h"
#include "topology/figures/drawing.h"
#include "topology/figures/shaded.h"
#include "topology/validate.h"

namespace clers::figures {
namespace {

/// The middle of the box that holds all places.
template <class At>
Vector middle_of(const Surface& surface, At at) {
  Vector least{1e9, 1e9, 1e9}, most{-1e9, -1e9, -1e9};
  for (const Vertex v : surface.vertices())
    for (std::size_t i = 0; i < 3; ++i) {
      least[i] = std::min(least[i], at(v)[i]);
      most[i] = std::max(most[i], at(v)[i]);
    }
  return 0.5 * (least + most);
}

}  // namespace

std::string deforming_sphere() {
  struct Frame {
    unsigned iteration;
    double width;
  };
  constexpr std::array<Frame, 5> frames{{{0, 160}, {20, 165}, {30, 165}, {35, 175}, {63, 300}}};
  DeformingSphere::Criterion criterion;
  criterion.turn = 0.5, criterion.longest = 0.07, criterion.shortest = 0.035;
  DeformingSphere sphere(criterion);
  constexpr double volume = 4. / 3 * std::numbers::pi * DeformingSphere::radius *
                            DeformingSphere::radius * DeformingSphere::radius;
  Figure figure(1, 0, 0);
  for (const auto& [iteration, width] : frames) {
    while (sphere.iteration() < iteration) {
      sphere.deform();
      must(sphere.adapt().complete(), "adapted");
    }
    const Surface& surface = sphere.mesh().surface();
    must(validate(surface).empty() && surface.genus() == 0, "a sphere");
    must(std::abs(sphere.volume() / volume - 1) < 0.04, "the flow keeps the volume");
    const auto at = [&](Vertex v) { return sphere[v]; };
    const Camera camera({-0.3, -1, -0.5}, {0, 0, 1}, middle_of(surface, at), 440, 3);
    figure.resize(width, 320);
    figure.panel(shaded(surface, camera, at), "iteration " + std::to_string(iteration) + ", " +
                                                  std::to_string(surface.characteristic().f) +
                                                  " faces");
  }
  return figure.svg();
}

}  // namespace clers::figures

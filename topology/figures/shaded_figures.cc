// Figures of adaptive meshes in space (Topological mesh operators, Fig. 19; Dynamic adaptive
// meshes, Fig. 11 and §6).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "topology/figures/deforming_sphere.h"
#include "topology/figures/drawing.h"
#include "topology/figures/rabbit.h"
#include "topology/figures/shaded.h"
#include "topology/modeling/adaptive_mesh.h"
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

std::string ring(const Camera& camera, const Vector& centre, double radius) {
  const Vector p = camera.see(centre);
  const auto tenths = [](double x) { return std::to_string(std::lround(10 * x)); };
  return "<circle class=\"q\" cx=\"" + tenths(p[0]) + "\" cy=\"" + tenths(-p[1]) + "\" r=\"" +
         tenths(radius * camera.pixels) + "\"/>\n";
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

/// The surface is fine within a ball, the brush, which moves along a path; elsewhere it is the
/// base.
std::string brush_of_resolution() {
  constexpr unsigned fine = 7, coarse = 1;
  constexpr double radius = 0.36;
  constexpr std::array<Vector, 3> path{
      {{0.88, -0.16, 1.27}, {0.31, -0.29, 1.98}, {-0.50, -0.50, 0.62}}};
  AdaptiveMesh<Vector, Rabbit> rabbit{Rabbit{}};
  const Rabbit::Cubes cubes = Rabbit::cubes();
  const std::vector<std::uint32_t> sizes(cubes.quads.size() / 4, 4);
  auto base = surface_of_polygons(sizes, cubes.quads, static_cast<std::uint32_t>(cubes.at.size()),
                                  [&](auto a, auto b, auto c, auto d) {
                                    return length(cubes.at[a] - cubes.at[c]) <
                                           length(cubes.at[b] - cubes.at[d]);
                                  });
  must(static_cast<bool>(base), "the cubes have a surface");
  must(rabbit.read(*std::move(base), cubes.at,
                   [](const Vector& a, const Vector& b) { return length(a - b); }));

  Vector brush = path[0];
  const auto wanted = [&](const Vector& p) { return length(p - brush) < radius ? fine : coarse; };
  const auto need_refine = [&](const auto& mesh, HalfEdge h) {
    const Vector &a = mesh[mesh.surface().org(h)], &b = mesh[mesh.surface().dest(h)];
    return mesh.level(h) < std::max({wanted(a), wanted(b), wanted(0.5 * (a + b))});
  };
  const auto need_simplify = [&](const auto& mesh, Vertex v) {
    const Surface& surface = mesh.surface();
    unsigned most = wanted(mesh[v]);
    for (const Vertex u : surface.adjacent_vertices(v)) most = std::max(most, wanted(mesh[u]));
    return mesh.level(v) > most;
  };
  Figure figure(1, 265, 330);
  for (std::size_t i = 0; i < path.size(); ++i) {
    constexpr int steps = 8;
    const Vector from = brush;
    for (int step = 1; step <= steps; ++step) {
      brush = from + (double(step) / steps) * (path[i] - from);
      must(rabbit.adapt(need_refine, need_simplify).complete(), "adapted");
    }
    const Surface& surface = rabbit.surface();
    must(validate(surface).empty() && surface.genus() == 0, "a rabbit");
    for (const Vertex v : surface.vertices())
      must(length(rabbit[v] - brush) < 1 || rabbit.level(v) <= coarse, "the base elsewhere");
    const auto at = [&](Vertex v) { return rabbit[v]; };
    const auto tone = [&](Face f) { return rabbit.mesh().level(f) >= fine ? 1u : 0u; };
    const Camera camera({0.75, -1.4, 0.45}, {0, 0, 1}, {0, 0, 1.1}, 122, 8);
    figure.panel(shaded(surface, camera, at, tone) + ring(camera, brush, radius),
                 std::to_string(surface.characteristic().f) + " faces");
  }
  return figure.svg();
}

namespace {

/// A torus over the unit square, in quadrilaterals.
constexpr std::uint32_t around = 12, across = 6;
struct OnTorus {
  double s = 0, t = 0;  // in turns
  Vector at{};
};
OnTorus on_torus(double s, double t) {
  const double r = 1 + 0.42 * cos_pi(2 * t);
  return {s, t, {r * cos_pi(2 * s), r * sin_pi(2 * s), 0.42 * sin_pi(2 * t)}};
}
struct ByLabel {
  OnTorus operator()(const Label& label) const {
    return on_torus((label.block / across + label.u()) / around,
                    (label.block % across + label.v()) / across);
  }
};
/// How far from a curve that goes around the torus three times one way and twice the other.
double from_knot(const OnTorus& p) {
  const double turns = 3 * p.s - 2 * p.t;
  return std::fabs(turns - std::floor(turns + 0.5));
}

}  // namespace

std::string torus_by_label() {
  std::vector<std::uint32_t> corners;
  std::vector<OnTorus> values;
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t j = 0; j < across; ++j) {
      const auto id = [](std::uint32_t a, std::uint32_t b) {
        return a % around * across + b % across;
      };
      for (const std::uint32_t v : {id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)})
        corners.push_back(v);
      values.push_back(on_torus(double(i) / around, double(j) / across));
    }
  const std::vector<std::uint32_t> sizes(corners.size() / 4, 4);
  auto base = surface_of_polygons(sizes, corners, around * across, [](auto...) { return false; });
  must(static_cast<bool>(base), "a torus");
  AdaptiveMesh<OnTorus, ByLabel> torus{ByLabel{}};
  must(torus.read(*std::move(base), values,
                  [](const OnTorus& a, const OnTorus& b) { return length(a.at - b.at); }));
  constexpr unsigned coarse = 1, fine = 8;
  constexpr double width = 0.05;
  must(torus
           .adapt_refine([&](const auto& mesh, HalfEdge h) {
             const double near = std::min(from_knot(mesh[mesh.surface().org(h)]),
                                          from_knot(mesh[mesh.surface().dest(h)]));
             return mesh.level(h) < (near < width ? fine : coarse);
           })
           .complete(),
       "adapted");
  const Surface& surface = torus.surface();
  must(validate(surface).empty() && surface.genus() == 1, "a torus");
  for (const Vertex v : surface.vertices()) {
    const OnTorus again = ByLabel{}(torus.label(v));
    must(length(again.at - torus[v].at) < 1e-12, "a vertex is where its label says");
  }
  Figure figure(1, 440, 330);
  const auto at = [&](Vertex v) { return torus[v].at; };
  const auto tone = [&](Face f) { return torus.mesh().level(f) >= fine ? 1u : 0u; };
  const Camera camera({0.2, -1, 0.95}, {0, 0, 1}, {0, 0, 0}, 130, 7);
  figure.panel(shaded(surface, camera, at, tone),
               std::to_string(surface.characteristic().f) + " faces");
  return figure.svg();
}

}  // namespace clers::figures

// A front that advances over points (Topological mesh operators, Fig. 13).
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "topology/figures/drawing.h"
#include "topology/figures/rabbit.h"
#include "topology/figures/shaded.h"
#include "topology/modeling/adaptive_mesh.h"
#include "topology/modeling/advancing_front.h"
#include "topology/modeling/pivoting_policy.h"
#include "topology/validate.h"

namespace clers::figures {
namespace {

/// Points on the rabbit, about evenly: of a mesh whose edges are as long as wanted.
std::vector<Vector> points_of_rabbit(double longest) {
  AdaptiveMesh<Vector, Rabbit> rabbit{Rabbit{}};
  const Rabbit::Cubes cubes = Rabbit::cubes();
  const std::vector<std::uint32_t> sizes(cubes.quads.size() / 4, 4);
  auto base = surface_of_polygons(sizes, cubes.quads, static_cast<std::uint32_t>(cubes.at.size()),
                                  [](auto...) { return false; });
  must(static_cast<bool>(base), "the cubes have a surface");
  must(rabbit.read(*std::move(base), cubes.at,
                   [](const Vector& a, const Vector& b) { return length(a - b); }));
  must(rabbit
           .adapt_refine([&](const auto& mesh, HalfEdge h) {
             return length(mesh[mesh.surface().org(h)] - mesh[mesh.surface().dest(h)]) > longest;
           })
           .complete(),
       "adapted");
  std::vector<Vector> points;
  for (const Vertex v : rabbit.surface().vertices()) points.push_back(rabbit[v]);
  return points;
}

/// A policy that stops for a picture when there are so many faces.
struct Pausing : internal::PivotingPolicy {
  using PivotingPolicy::PivotingPolicy;
  std::int64_t faces = 0;
  bool added(const AdvancingFront& front, Face f) {
    return PivotingPolicy::added(front, f) && front.surface().characteristic().f < faces;
  }
};

/// The surface and, as faces of their own, its inside.
Surface both_sides(const Surface& surface) {
  const std::uint32_t n = surface.vertex_limit();
  std::vector<std::uint32_t> corners;
  for (const Face f : surface.faces()) {
    std::array<std::uint32_t, 3> c;
    for (unsigned i = 0; i < 3; ++i) c[i] = surface.org(half_edge(f, i)).index();
    corners.insert(corners.end(), {c[0], c[1], c[2], n + c[0], n + c[2], n + c[1]});
  }
  auto made = Surface::from_faces(corners, 2 * n);
  must(static_cast<bool>(made), "two sheets");
  return *std::move(made);
}

std::string dots(const std::vector<Vector>& points, const AdvancingFront& front,
                 const Camera& camera) {
  std::string svg;
  const auto tenths = [](double x) { return std::to_string(std::lround(10 * x)); };
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Vector p = camera.see(points[i]);
    const Vector outwards = Rabbit::potential(points[i]).gradient;
    if (!front.is_used(Point(i)) && dot(outwards, camera.towards) > 0)
      svg += "<circle cx=\"" + tenths(p[0]) + "\" cy=\"" + tenths(-p[1]) + "\" r=\"7\"/>\n";
  }
  return svg;
}

}  // namespace

std::string advancing_front() {
  constexpr double longest = 0.11;
  const std::vector<Vector> points = points_of_rabbit(longest);
  std::vector<internal::Place> places, normals;
  for (const Vector& p : points) {
    const Vector n = Rabbit::potential(p).gradient;
    places.push_back({p[0], p[1], p[2]});
    normals.push_back({n[0], n[1], n[2]});
  }
  const std::function<bool(double)> nobody_waits;
  internal::FrontPoints known(places, normals, nobody_waits);
  Pausing policy(known, {0.06, 0.08, 0.12});
  AdvancingFront front(static_cast<std::uint32_t>(points.size()));
  const Camera camera({0.75, -1.4, 0.45}, {0, 0, 1}, {0, 0, 1.1}, 122, 8);
  Figure figure(1, 265, 330);
  for (const double share : {0.12, 0.45, 0.8, 2.}) {
    policy.faces = std::lround(share * 2 * static_cast<double>(points.size()));
    advance(front, policy);
    must(validate(front.surface()).empty(), "a manifold at all times");
    const Surface both = both_sides(front.surface());
    const std::uint32_t n = front.surface().vertex_limit();
    const auto at = [&](Vertex v) {
      return points[front.surface().point(Vertex(v.index() % n)).index()];
    };
    const auto tone = [&](Face f) { return both.org(half_edge(f, 0)).index() >= n ? 1u : 0u; };
    const Characteristic& c = front.surface().characteristic();
    const std::string curves = c.b == 0 ? "closed" : std::to_string(c.b) + " curves";
    figure.panel(dots(points, front, camera) + shaded(both, camera, at, tone),
                 std::to_string(c.f) + " faces, " + curves);
  }
  must(front.surface().characteristic().b == 0 && front.surface().genus() == 0, "a rabbit");
  return figure.svg();
}

}  // namespace clers::figures

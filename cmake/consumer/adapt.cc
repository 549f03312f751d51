// A cube becomes a sphere that is fine around a pole, then around the other.
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <clers/modeling/adaptive_mesh.h>

using Point = std::array<double, 3>;

namespace {

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The surface, sampled at the middle of an edge.
Point on_sphere(const Point& a, const Point& b) {
  Point middle{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  const double length = std::hypot(middle[0], middle[1], middle[2]);
  for (double& x : middle) x /= length;
  return middle;
}

}  // namespace

int main() {
  const std::vector<std::uint32_t> sizes(6, 4);
  const std::vector<std::uint32_t> corners{0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                           2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  std::vector<Point> points;
  const double a = 1 / std::sqrt(3.);
  for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? a : -a, i & 2 ? a : -a, i & 4 ? a : -a});

  auto mesh = clers::adaptive_mesh<Point>(on_sphere);
  auto base = clers::surface_of_polygons(sizes, corners, 8, [](auto...) { return false; });
  if (!base || !mesh.read(*std::move(base), std::move(points), distance)) return 1;

  for (const double pole : {1., -1.}) {
    // How long an edge at this point may be.
    const auto wanted = [&](const Point& p) { return 0.02 + 0.4 * distance(p, {0, 0, pole}); };
    const auto ends = [](const auto& m, clers::HalfEdge h) {
      return std::pair(m[m.surface().org(h)], m[m.surface().dest(h)]);
    };
    const auto done = mesh.adapt(
        [&](const auto& m, clers::HalfEdge h) {
          const auto [p, q] = ends(m, h);
          return distance(p, q) > wanted(on_sphere(p, q));
        },
        [&](const auto& m, clers::Vertex v) {
          for (const clers::Vertex u : m.surface().adjacent_vertices(v))
            if (2 * distance(m[u], m[v]) > wanted(m[v])) return false;
          return true;
        });
    if (!done.complete() || done.refined == 0 || mesh.surface().genus() != 0) return 1;
  }
  return 0;
}

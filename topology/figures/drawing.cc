#include "topology/figures/drawing.h"

#include <cmath>
#include <numbers>

namespace clers::figures {

Scene patch(const test::Triangles& triangles, std::vector<Place> at) {
  return {test::from_triangles(triangles), std::move(at), {}, {}, {}, {}};
}

HalfEdge between(const Scene& scene, std::uint32_t a, std::uint32_t b) {
  const Surface& s = scene.surface;
  for (const Face f : s.faces())
    for (const HalfEdge h : s.star(f))
      if (s.org(h) == Vertex(a) && s.dest(h) == Vertex(b)) return h;
  must(false, "no such edge");
  return HalfEdge();
}

Place on_circle(double radius, double turns) {
  const double angle = 2 * std::numbers::pi * turns;
  return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

Place mean_of_neighbours(const Scene& scene, Vertex v) {
  Place mean;
  const double n = scene.surface.degree(v);
  for (const HalfEdge h : scene.surface.star(v)) {
    const Place& p = scene.at[scene.surface.other_end(h, v).index()];
    mean.x += p.x / n, mean.y += p.y / n, mean.z += p.z / n;
  }
  return mean;
}

Scene triangle() {
  return patch({{0, 1, 2}}, {{-0.9, -0.6}, {0.9, -0.6}, {0, 0.9}});
}
/// Two triangles about the edge from 0 to 1.
Scene diamond() {
  return patch({{2, 0, 1}, {3, 1, 0}}, {{-1, 0}, {1, 0}, {0, 0.9}, {0, -0.9}});
}

Scene fan(std::uint32_t corners, double radius) {
  test::Triangles triangles;
  std::vector<Place> at{{}};
  for (std::uint32_t i = 0; i < corners; ++i) {
    triangles.push_back({0, 1 + i, 1 + (i + 1) % corners});
    at.push_back(on_circle(radius, i / double(corners)));
  }
  return patch(triangles, at);
}

}  // namespace clers::figures

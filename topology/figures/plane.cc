#include "topology/figures/plane.h"

#include <utility>

#include "topology/figures/drawing.h"
#include "topology/validate.h"

namespace clers::figures {

Plane plane_of(const std::vector<std::array<std::uint32_t, 4>>& quads, std::vector<Place> at) {
  std::vector<std::uint32_t> corners;
  for (const auto& quad : quads) corners.insert(corners.end(), quad.begin(), quad.end());
  const std::vector<std::uint32_t> sizes(quads.size(), 4);
  auto surface = surface_of_polygons(sizes, corners, static_cast<std::uint32_t>(at.size()),
                                     [](auto...) { return false; });
  must(static_cast<bool>(surface), "a base");
  Plane plane{Middle{}};
  must(plane.read(*std::move(surface), std::move(at), distance));
  must(plane.surface().characteristic().f == static_cast<std::int64_t>(2 * quads.size()), "blocks");
  return plane;
}

Plane hexagon() {
  std::vector<Place> at{{0.06, -0.04}};
  for (unsigned i = 0; i < 6; ++i) at.push_back(on_circle(i % 2 == 0 ? 1.02 : 1.1, i / 6. + 0.05));
  return plane_of({{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 1}}, std::move(at));
}

Scene scene_of(const Plane& plane) {
  must(validate(plane.surface()).empty(), "validate");
  Scene s{plane.surface(), plane.values(), {}, {}, {}, {}};
  for (const HalfEdge h : s.surface.edges())
    if (plane.mesh().is_block(h) && !s.surface.is_boundary(h)) s.dashed.push_back(h);
  return s;
}

HalfEdge find(const Scene& s, const std::array<Place, 2>& ends) {
  for (const HalfEdge h : s.surface.edges())
    for (unsigned turn = 0; turn < 2; ++turn)
      if (distance(s.at[s.surface.org(h).index()], ends[turn]) +
              distance(s.at[s.surface.dest(h).index()], ends[1 - turn]) ==
          0)
        return h;
  return {};
}
HalfEdge between(const Scene& s, const std::array<Place, 2>& ends) {
  const HalfEdge h = find(s, ends);
  must(static_cast<bool>(h), "no such edge");
  return h;
}

}  // namespace clers::figures

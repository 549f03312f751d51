#include "topology/modeling/test/bases.h"

#include <string>

#include "topology/modeling/base_mesh.h"
#include "topology/modeling/four_eight.h"
#include "topology/test/meshes.h"

namespace clers::test {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

struct NoGeometry {
  struct Value {};
  Value combine(std::span<const Term>) const { return {}; }
  void set(Vertex, Value) {}
};

Surface tri_quad_of(Surface surface, std::span<const HalfEdge> quads) {
  NoGeometry none;
  Creases smooth;
  const auto length = [](const Surface&, HalfEdge) { return 1.; };
  (void)make_tri_quad(surface, none, smooth, length, quads);
  return surface;
}

/// Quadrilaterals around a vertex, which is corner 0 of the first face of each, or the origin of
/// its split edge.
Surface hub(std::uint32_t quads, bool at_split_edge) {
  Pairs pairs;
  for (std::uint32_t q = 0; q < quads; ++q) {
    const std::uint32_t next = (q + 1) % quads;
    pairs.emplace_back(6 * q + 1, 6 * q + 4);
    // Half-edges to the hub and from it; those of the second face where the split edge ends there.
    if (at_split_edge)
      pairs.emplace_back(6 * q, 6 * next + 5);
    else
      pairs.emplace_back(6 * q + 2, 6 * next);
  }
  return glued(2 * quads, pairs);
}

}  // namespace

const std::vector<std::uint32_t> cube_sizes(6, 4);
const std::vector<std::uint32_t> cube_corners{0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4,
                                              1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};

Surface glued(std::uint32_t faces, std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs) {
  Surface s;
  for (std::uint32_t f = 0; f < faces; ++f) (void)s.create(Point(), Point(), Point());
  for (const auto& [a, b] : pairs) (void)s.glue(HalfEdge(a), HalfEdge(b));
  return s;
}

Surface tri_quad_of(std::span<const std::uint32_t> sizes, std::span<const std::uint32_t> corners,
                    std::uint32_t vertices) {
  auto polygons = surface_of_polygons(sizes, corners, vertices, [](auto...) { return false; });
  return tri_quad_of(std::move(polygons->surface), polygons->quads);
}

Surface tri_quad_of(Surface surface) {
  return tri_quad_of(std::move(surface), {});
}

std::vector<Base> bases() {
  const Pairs block{{1, 4}};
  const auto with = [&](Pairs more) {
    more.insert(more.begin(), block.begin(), block.end());
    return more;
  };
  std::vector<Base> all;
  const auto add = [&](const char* name, Surface s) { all.push_back({name, std::move(s)}); };
  add("half a block", glued(1, {}));
  add("block", glued(2, block));
  add("cone of half a block", glued(1, Pairs{{0, 2}}));
  add("sphere of two faces", glued(2, with({{0, 5}, {2, 3}})));
  add("sphere of two cones", glued(2, with({{0, 2}, {3, 5}})));
  add("torus of one quadrilateral", glued(2, with({{0, 3}, {2, 5}})));
  add("torus of two", glued(4, with({{7, 10}, {5, 8}, {11, 2}, {3, 0}, {9, 6}})));
  add("cylinder of one", glued(2, with({{2, 5}})));
  add("cylinder of two", glued(4, with({{7, 10}, {5, 8}, {11, 2}})));
  add("pillow of two", glued(4, with({{7, 10}, {0, 8}, {2, 6}, {3, 11}, {5, 9}})));
  add("hub", hub(40, false));
  add("hub of split edges", hub(7, true));
  add("cube", tri_quad_of(cube_sizes, cube_corners, 8));
  // Two quadrilaterals in a row; a triangle beside two.
  add("strip", tri_quad_of(std::vector<std::uint32_t>{4, 4},
                           std::vector<std::uint32_t>{0, 1, 4, 5, 1, 2, 3, 4}, 6));
  add("mixed", tri_quad_of(std::vector<std::uint32_t>{4, 4, 3},
                           std::vector<std::uint32_t>{0, 1, 4, 5, 1, 2, 3, 4, 5, 4, 6}, 7));
  // A tetrahedron, a grid and a quadrilateral apart.
  add("components", tri_quad_of(std::vector<std::uint32_t>{3, 3, 3, 3, 4, 3, 3},
                                std::vector<std::uint32_t>{0, 1, 2, 0, 3, 1, 1,  3, 2,  2, 3, 0,  //
                                                           4, 5, 6, 7, 8, 9, 10, 8, 10, 11},
                                12));
  add("triangle", tri_quad_of(from_triangles({{0, 1, 2}})));
  add("grid", tri_quad_of(grid(3, 2)));
  add("torus", tri_quad_of(torus(3, 3)));
  add("genus 2", tri_quad_of(chain_of_tori(2, 3)));
  return all;
}

Surface random_base(std::span<const std::uint16_t> choices) {
  const std::uint32_t faces = 1 + (choices.empty() ? 0u : choices[0] % 9u);
  Surface s = glued(faces, {});
  std::size_t next = 1;
  const auto choose = [&](std::size_t n) -> std::size_t {
    return next < choices.size() ? choices[next++] % n : 0;
  };
  for (const bool sides : {false, true}) {
    std::vector<std::uint32_t> left;
    for (std::uint32_t h = 0; h < 3 * faces; ++h)
      if ((h % 3 != 1) == sides) left.push_back(h);
    while (left.size() > 1) {
      const std::uint32_t h = left.back();
      left.pop_back();
      const std::size_t i = choose(left.size() + 1);
      if (i == 0) continue;  // stays on the boundary
      (void)s.glue(HalfEdge(h), HalfEdge(left[i - 1]));
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i - 1));
    }
  }
  return s;
}

}  // namespace clers::test

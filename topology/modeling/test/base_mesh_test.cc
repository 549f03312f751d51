// Polygons that are no surface, and what make_tri_quad does with quadrilaterals.
#include "topology/modeling/base_mesh.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <vector>

#include "topology/dump.h"
#include "topology/modeling/four_eight.h"
#include "topology/modeling/test/bases.h"
#include "topology/validate.h"

namespace clers {
namespace {

using List = std::vector<std::uint32_t>;
const auto never = [](auto...) { return false; };

BrokenRule error_of(const List& sizes, const List& corners, std::uint32_t n) {
  const auto surface = surface_of_polygons(sizes, corners, n, [&](auto... v) {
    EXPECT_TRUE(((v < n) && ...));  // a caller looks up its points
    return true;
  });
  EXPECT_FALSE(surface);
  return surface ? BrokenRule{} : surface.error();
}

TEST(BaseMesh, SaysWhatIsWrongWithPolygons) {
  const auto rule = [](FaceRule r, std::uint32_t element) { return BrokenRule{r, element}; };
  EXPECT_EQ(error_of({2}, {0, 1}, 2), rule(FaceRule::array_sizes, 0));
  EXPECT_EQ(error_of({3, 0}, {0, 1, 2}, 3), rule(FaceRule::array_sizes, 1));
  EXPECT_EQ(error_of({3, 4}, {0, 1, 2, 0, 2, 3}, 4), rule(FaceRule::array_sizes, 1));
  EXPECT_EQ(error_of({3}, {0, 1, 2, 0}, 3), rule(FaceRule::array_sizes, 1));
  EXPECT_EQ(error_of({}, {0}, 1), rule(FaceRule::array_sizes, 0));
  EXPECT_EQ(error_of({0xffffffffu}, {0, 1, 2}, 3), rule(FaceRule::array_sizes, 0));
  EXPECT_EQ(error_of({3, 4}, {0, 1, 2, 0, 2, 7, 1}, 4).rule, FaceRule::vertex_in_range);
  EXPECT_EQ(error_of({4}, {0, 1, 2, 0xffffffffu}, 3).rule, FaceRule::vertex_in_range);
  EXPECT_EQ(error_of({4}, {0, 1, 0, 2}, 3).rule, FaceRule::distinct_corners);
  EXPECT_EQ(error_of({3, 3, 3}, {0, 1, 2, 1, 0, 3, 0, 1, 4}, 5).rule, FaceRule::at_most_two_faces);
  EXPECT_EQ(error_of({3, 3}, {0, 1, 2, 0, 1, 3}, 4).rule, FaceRule::opposite_directions);
  EXPECT_EQ(error_of({3, 3}, {0, 1, 2, 0, 3, 4}, 5).rule, FaceRule::one_fan);
  // Nothing is a surface, too.
  const auto none = surface_of_polygons({}, {}, 0, never);
  ASSERT_TRUE(none);
  EXPECT_EQ(none->surface.characteristic().f, 0);
}

TEST(BaseMesh, CutsPolygonsFromTheFirstCorner) {
  const auto made =
      surface_of_polygons(List{5, 4, 3}, List{0, 1, 2, 3, 4, 0, 4, 5, 6, 4, 3, 7}, 8, never);
  ASSERT_TRUE(made);
  ASSERT_EQ(made->surface.characteristic().f, 3 + 2 + 1);
  ASSERT_EQ(made->quads, (std::vector<HalfEdge>{half_edge(Face(3), 1)}));
  const std::uint32_t corners[6][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4},
                                       {0, 4, 6}, {5, 6, 4}, {4, 3, 7}};
  for (std::uint32_t f = 0; f < 6; ++f)
    for (unsigned i = 0; i < 3; ++i)
      EXPECT_EQ(made->surface.org(half_edge(Face(f), i)), Vertex(corners[f][i])) << f;
}

struct Counts {
  struct Value {};
  int set_count = 0;
  Value combine(std::span<const Term>) const { return {}; }
  void set(Vertex, Value) { ++set_count; }
};
const auto equal = [](const Surface&, HalfEdge) { return 1.; };

TEST(BaseMesh, QuadrilateralsAreBlocksOrPairs) {
  PolygonSurface cube = *surface_of_polygons(test::cube_sizes, test::cube_corners, 8, never);
  const std::string before = dump(cube.surface);
  Counts counts;
  Creases none;
  ASSERT_TRUE(make_tri_quad(cube.surface, counts, none, equal, cube.quads));
  EXPECT_EQ(dump(cube.surface), before);
  // One of them not named: then no face is a block, and all come in pairs.
  PolygonSurface some = *surface_of_polygons(test::cube_sizes, test::cube_corners, 8, never);
  some.quads.pop_back();
  ASSERT_TRUE(make_tri_quad(some.surface, counts, none, equal, some.quads));
  EXPECT_EQ(some.surface.characteristic().f, 24);
  EXPECT_EQ(counts.set_count, 6);
  EXPECT_TRUE(check_tri_quad(some.surface));
}

TEST(BaseMesh, AQuadrilateralNamedTwiceCountsOnce) {
  auto mixed = *surface_of_polygons(List{4, 3}, List{0, 1, 2, 3, 1, 4, 2}, 5, never);
  const HalfEdge quad = mixed.quads[0];
  mixed.quads = {quad, quad, mixed.surface.sym(quad)};
  Counts counts;
  Creases none;
  ASSERT_TRUE(make_tri_quad(mixed.surface, counts, none, equal, mixed.quads));
  EXPECT_TRUE(check_tri_quad(mixed.surface));
  EXPECT_EQ(mixed.surface.characteristic().f, 7);
  EXPECT_EQ(counts.set_count, 2);
}

TEST(BaseMesh, RefusesQuadrilateralsThatAreNone) {
  const auto base = *surface_of_polygons(List{4, 3}, List{0, 1, 2, 3, 1, 4, 2}, 5, never);
  for (const HalfEdge bad : {HalfEdge(0), HalfEdge(5), HalfEdge(99), HalfEdge()}) {
    Surface surface = base.surface;
    Counts counts;
    Creases none;
    const auto refused = make_tri_quad(surface, counts, none, equal, {&bad, 1});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error(), (Violation{Precondition::tri_quad, bad.index()}));
    EXPECT_EQ(dump(surface), dump(base.surface));
  }
}

}  // namespace
}  // namespace clers

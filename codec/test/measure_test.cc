#include <gtest/gtest.h>

#include "codec/inspect.h"
#include "corpus/generate.h"

namespace clers::internal {
namespace {

struct Row {
  const char* what;
  Mesh mesh;
  std::uint64_t components, curves, genus, edges, vertices, misoriented;
};

TEST(Measure, KnownShapes) {
  const Row rows[] = {
      {"sphere", corpus::icosphere(2), 1, 0, 0, 0, 0, 0},
      {"torus", corpus::torus(5, 6), 1, 0, 1, 0, 0, 0},
      {"disc", corpus::grid(4, 5), 1, 1, 0, 0, 0, 0},
      {"annulus", corpus::cylinder(6, 2), 1, 2, 0, 0, 0, 0},
      {"four handles and one", corpus::gyroid(1, 1, 1, 10, corpus::Ends::periodic), 1, 0, 5, 0, 0,
       0},
      {"moebius", corpus::moebius_strip(6, 1), 1, 1, 0, 0, 0, 1},
      {"three faces at an edge", corpus::book(3), 3, 3, 0, 1, 2, 0},
      {"chessboard", corpus::chessboard(3), 5, 5, 0, 0, 4, 0},
      {"loose", corpus::loose_triangles(4), 4, 4, 0, 0, 0, 0},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.what);
    for (const Mesh& m : {row.mesh, corpus::shuffle(row.mesh, 5)}) {
      auto s = measure(m);
      ASSERT_TRUE(s.ok());
      EXPECT_EQ(s->surface.components, row.components);
      EXPECT_EQ(s->surface.boundary_curves, row.curves);
      EXPECT_EQ(s->surface.genus, row.genus);
      EXPECT_EQ(s->nonmanifold_edges, row.edges);
      EXPECT_EQ(s->nonmanifold_vertices, row.vertices);
      EXPECT_EQ(s->misoriented_edges > 0, row.misoriented > 0);
      EXPECT_EQ(s->triangles, m.face_count());
    }
  }
}

TEST(Measure, PolygonsDegenerateFacesAndIsolatedVertices) {
  Mesh m;
  m.vertex_count = 9;
  m.face_sizes = {4, 3, 5, 3};
  m.corners = {0, 1, 2, 3, 1, 0, 4, 5, 6, 7, 6, 1, 2, 2, 1};
  auto s = measure(m);
  ASSERT_TRUE(s.ok()) << describe(s.error());
  EXPECT_EQ(s->faces, 4u);
  EXPECT_EQ(s->triangles, 2u + 1 + 3 + 1);
  EXPECT_EQ(s->degenerate_faces, 2u);
  EXPECT_EQ(s->isolated_vertices, 1u);
  EXPECT_EQ(s->surface.components, 1u);
  EXPECT_EQ(s->surface.boundary_curves, 1u);

  m.corners.pop_back();
  EXPECT_FALSE(measure(m).ok());
}

}  // namespace
}  // namespace clers::internal

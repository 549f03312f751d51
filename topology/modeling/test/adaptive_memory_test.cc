// Memory that runs out while meshes adapt: whichever allocation fails, the mesh is valid, and what
// is kept by element fits it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <vector>

#include "topology/dump.h"
#include "topology/modeling/adaptive_mesh.h"
#include "topology/modeling/dynamic_adaptation.h"
#include "topology/modeling/test/bases.h"
#include "topology/test/scarce_memory.h"
#include "topology/validate.h"

namespace clers {
namespace {

using Place = std::array<double, 3>;
Place place(const Label& at) {
  return {double(at.block), at.u(), at.v()};
}
using Mesh = AdaptiveMesh<Place, decltype(&place)>;

Mesh cube() {
  Mesh mesh(&place);
  auto base =
      surface_of_polygons(test::cube_sizes, test::cube_corners, 8, [](auto...) { return false; });
  (void)mesh.read(std::move(*base), std::vector<Place>(8), [](auto&&...) { return 1.; });
  return mesh;
}

/// Every vertex is where its label says, and no two are at one place.
void expect_whole(const Mesh& mesh, const VertexData<int>& marks) {
  ASSERT_TRUE(validate(mesh.surface()).empty());
  ASSERT_EQ(marks.values().size(), mesh.surface().vertex_limit());
  std::vector<Place> places;
  for (const Vertex v : mesh.surface().vertices()) {
    if (v.index() < 8) continue;
    ASSERT_EQ(mesh[v], place(mesh.label(v)));
    places.push_back(mesh[v]);
  }
  std::sort(places.begin(), places.end());
  EXPECT_EQ(std::adjacent_find(places.begin(), places.end()), places.end());
}

/// With ever more memory until it succeeds: how many allocations it took. What was done before
/// memory ran out stays.
template <class Run>
int starve(Mesh& mesh, const VertexData<int>& marks, Run run) {
  for (int allocations = 0;; ++allocations) {
    bool failed = false;
    test::memory::remaining = allocations;
    try {
      run();
    } catch (const std::bad_alloc&) {
      failed = true;
    }
    test::memory::remaining = -1;
    expect_whole(mesh, marks);
    if (!failed || testing::Test::HasFatalFailure()) return allocations;
  }
}

TEST(AdaptiveMemory, RunsOutWhereverItMay) {
  // Nothing has room to spare in a mesh that was just read.
  for (unsigned level = 1; level < 9; ++level) {
    Mesh mesh = cube();
    const auto marks = mesh.mesh().attach<VertexData<int>>(1);
    const auto need = [&](const Mesh& m, HalfEdge h) { return m.level(h) < level; };
    const int taken = starve(mesh, marks, [&] { (void)mesh.adapt_refine(need); });
    EXPECT_GE(taken, 3);
    EXPECT_EQ(mesh.surface().characteristic().f, 12 << level);
    EXPECT_EQ(starve(mesh, marks, [&] { (void)mesh.adapt_refine(need); }), 0);
    (void)starve(mesh, marks,
                 [&] { (void)mesh.adapt_simplify([](const Mesh&, Vertex) { return true; }); });
    EXPECT_EQ(mesh.surface().characteristic().f, 12);
  }
}

TEST(AdaptiveMemory, OneRefinementFailsBetweenSplits) {
  // Along the chain of splits of one call.
  for (int allocations = 0; allocations < 60; ++allocations) {
    Mesh mesh = cube();
    const auto marks = mesh.mesh().attach<VertexData<int>>(1);
    NoObserver none;
    auto observer = mesh.follow(none);
    for (int i = 0; i < 12; ++i)
      (void)mesh.mesh().refine(half_edge(left(mesh.surface().star_half_edge(Vertex(0))), 1),
                               observer);
    HalfEdge finest;
    for (const Face f : mesh.surface().faces())
      if (!finest || mesh.mesh().level(f) > mesh.level(finest)) finest = half_edge(f, 0);
    const std::int64_t before = mesh.surface().characteristic().f;
    const unsigned makes = mesh.mesh().growth(finest).faces;
    test::memory::remaining = allocations;
    bool failed = false;
    try {
      (void)mesh.mesh().refine(finest, observer);
    } catch (const std::bad_alloc&) {
      failed = true;
    }
    test::memory::remaining = -1;
    expect_whole(mesh, marks);
    if (failed)
      EXPECT_LT(mesh.surface().characteristic().f, before + makes);
    else
      EXPECT_EQ(mesh.surface().characteristic().f, before + makes);
  }
}

TEST(AdaptiveMemory, AnAdaptationGoesOnAfterwards) {
  Mesh mesh = cube();
  const auto marks = mesh.mesh().attach<VertexData<int>>(1);
  double target = 6;
  const auto priority = [&](const MultiTriangulation& m, auto id) {
    if constexpr (std::is_same_v<decltype(id), Vertex>)
      return target - m.level(id) + 0.5;
    else
      return target - m.level(left(id)) - 0.5;
  };
  DynamicAdaptation dynamic(mesh.mesh(), priority, Thresholds{0, 0});
  NoObserver none;
  auto observer = mesh.follow(none);
  for (const double level : {6., 3., 7., 0.}) {
    target = level;
    dynamic.all_changed();
    (void)starve(mesh, marks, [&] { (void)dynamic.adapt({}, observer); });
    EXPECT_EQ(mesh.surface().characteristic().f, 12 << int(level));
  }
}

}  // namespace
}  // namespace clers

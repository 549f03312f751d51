// The paper's three functions: values sampled where vertices are made, bases of polygons,
// observers.
#include "topology/modeling/adaptive_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "topology/dump.h"
#include "topology/modeling/dynamic_adaptation.h"
#include "topology/modeling/test/bases.h"
#include "topology/validate.h"

namespace clers {
namespace {

using Values = std::vector<double>;

/// Where a vertex came from, as text: the sample between a and b is (a b).
std::string between(const std::string& a, const std::string& b) {
  return "(" + a + " " + b + ")";
}
PolygonSurface polygons(const std::vector<std::uint32_t>& sizes,
                        const std::vector<std::uint32_t>& corners, std::uint32_t n) {
  return *surface_of_polygons(sizes, corners, n, [](auto...) { return false; });
}
PolygonSurface cube() {
  return polygons(test::cube_sizes, test::cube_corners, 8);
}
const auto equal_lengths = [](const auto&, const auto&) { return 1.; };
const auto to_level = [](unsigned level) {
  return [level](const auto& mesh, HalfEdge h) { return mesh.level(h) < level; };
};
const auto from_level = [](unsigned level) {
  return [level](const auto& mesh, Vertex v) { return mesh.level(v) > level; };
};

TEST(AdaptiveMesh, SamplesBetweenTheEnds) {
  auto mesh = adaptive_mesh<std::string>(between);
  ASSERT_TRUE(mesh.read(polygons({4}, {0, 1, 2, 3}, 4), {"a", "b", "c", "d"},
                        [](const auto&, const auto&) { return 1.; }));
  EXPECT_EQ(mesh.adapt_refine(to_level(1)).refined, 1u);
  EXPECT_EQ(mesh[Vertex(4)], "(b d)");
  EXPECT_EQ(mesh.adapt_refine(to_level(2)).refined, 4u);
  std::vector<std::string> sides(mesh.values().begin() + 5, mesh.values().end());
  for (std::string& s : sides)
    if (s[1] > s[3]) std::swap(s[1], s[3]);
  std::sort(sides.begin(), sides.end());
  EXPECT_EQ(sides, (std::vector<std::string>{"(a b)", "(a d)", "(b c)", "(c d)"}));
  // What a sample would be is what it is.
  const HalfEdge h = half_edge(*mesh.surface().faces().begin(), 1);
  const std::string would = mesh.sample(h);
  NoObserver none;
  const Vertex v = *mesh.mesh().refine(h, mesh.follow(none));
  EXPECT_EQ(mesh[v], would);
  // Ids are given again, and values with them.
  EXPECT_EQ(mesh.adapt_simplify(from_level(0)).simplified, 6u);
  mesh[Vertex(1)] = "B";
  EXPECT_EQ(mesh.adapt_refine(to_level(1)).refined, 1u);
  std::size_t at_middle = 0;
  for (const Vertex x : mesh.surface().vertices()) at_middle += mesh[x] == "(B d)";
  EXPECT_EQ(at_middle, 1u);
}

TEST(AdaptiveMesh, QuadrilateralsAreBlocksAsTheyAre) {
  auto mesh = adaptive_mesh<std::string>(between);
  ASSERT_TRUE(mesh.read(cube(), std::vector<std::string>(8, "x"), equal_lengths));
  EXPECT_EQ(mesh.surface().characteristic().f, 12);
  for (const Vertex v : mesh.surface().vertices()) EXPECT_EQ(mesh.level(v), 0u);
  const PolygonSurface same = cube();
  EXPECT_EQ(dump(mesh.surface()), dump(same.surface));
  ASSERT_EQ(same.quads.size(), 6u);
  for (std::uint32_t q = 0; q < 6; ++q) {
    EXPECT_EQ(left(same.quads[q]), Face(2 * q));
    EXPECT_TRUE(is_split_edge(same.surface, same.quads[q]));
    const Vertex b(test::cube_corners[4 * q + 1]), d(test::cube_corners[4 * q + 3]);
    EXPECT_EQ(same.surface.org(same.quads[q]), b);
    EXPECT_EQ(same.surface.dest(same.quads[q]), d);
  }
}

/// A triangle beside quadrilaterals: all are split, each quadrilateral at its diagonal.
TEST(AdaptiveMesh, MixedMeshesAreSplitOnce) {
  for (const bool across : {false, true}) {
    auto base = *surface_of_polygons(std::vector<std::uint32_t>{4, 3, 4, 3},
                                     std::vector<std::uint32_t>{0, 1, 2, 3, 1, 4, 2,  //
                                                                5, 6, 7, 8, 9, 10, 11},
                                     12, [&](auto...) { return across; });
    auto mesh = adaptive_mesh<std::string>(between);
    std::vector<std::string> names;
    for (const char c : std::string("abcdefghijkl")) names.emplace_back(1, c);
    ASSERT_TRUE(mesh.read(std::move(base), names, equal_lengths));
    ASSERT_TRUE(check_tri_quad(mesh.surface()));
    ASSERT_TRUE(validate(mesh.surface()).empty());
    // A quadrilateral and a triangle together: 4 + 3. A quadrilateral alone: 2. A triangle: 3.
    EXPECT_EQ(mesh.surface().characteristic().f, 4 + 3 + 2 + 3);
    EXPECT_EQ(mesh.values().size(), 15u);
    EXPECT_EQ(mesh[Vertex(12)], across ? "(c a)" : "(b d)");
    EXPECT_EQ(mesh[Vertex(13)], "(b (e c))");
    EXPECT_EQ(mesh[Vertex(14)], "(j (k l))");
  }
}

TEST(AdaptiveMesh, SamplesByLabel) {
  const auto place = [](const Label& at) {
    return std::array<double, 3>{double(at.block), at.u(), at.v()};
  };
  using Place = std::array<double, 3>;
  auto mesh = adaptive_mesh<Place>(place);
  ASSERT_TRUE(mesh.read(cube(), std::vector<Place>(8, Place{-1, 0, 0}), equal_lengths));
  std::mt19937 random(4);
  NoObserver none;
  auto observer = mesh.follow(none);
  for (int i = 0; i < 3000; ++i) {
    const HalfEdge h(static_cast<std::uint32_t>(random()) % mesh.surface().half_edge_limit());
    const Vertex v(static_cast<std::uint32_t>(random()) % mesh.surface().vertex_limit());
    if (random() % 16 != 0 && mesh.surface().is_live(h) && mesh.level(h) < 15)
      (void)mesh.mesh().refine(h, observer);
    else if (mesh.surface().is_live(v) && mesh.level(v) > 3)
      (void)mesh.mesh().simplify(v, observer);
  }
  std::map<Place, Vertex> at;
  for (const Vertex v : mesh.surface().vertices()) {
    if (v.index() < 8) {
      EXPECT_EQ(mesh[v][0], -1);  // given, not sampled
      continue;
    }
    EXPECT_EQ(mesh[v], place(mesh.label(v)));
    EXPECT_TRUE(at.emplace(mesh[v], v).second);
  }
  EXPECT_GT(at.size(), 200u);
}

/// Program 5 gives the ids of vertices that no face has; those are sampled, too.
TEST(AdaptiveMesh, VerticesThatNoFaceHadAreSampledByLabel) {
  auto mesh = adaptive_mesh<int>([](const Label& at) { return 100 + int(at.block); });
  ASSERT_TRUE(mesh.read(polygons({3}, {0, 1, 3}, 5), {0, 1, 2, 3, 4}, equal_lengths));
  for (const Vertex v : mesh.surface().vertices()) {
    const bool given = v == Vertex(0) || v == Vertex(1) || v == Vertex(3);
    EXPECT_EQ(mesh[v] >= 100, !given) << v.index();
  }
}

/// Change, then Refined or Simplified; containers follow all by themselves.
TEST(AdaptiveMesh, ObserversHearInOrder) {
  auto mesh = adaptive_mesh<std::string>(between);
  ASSERT_TRUE(mesh.read(cube(), std::vector<std::string>(8, "x"), equal_lengths));
  auto marks = mesh.mesh().attach<VertexData<int>>(7);
  auto blocks = mesh.mesh().attach<FaceData<std::uint32_t>>();
  auto sides = mesh.mesh().attach<HalfEdgeData<int>>(0);
  for (const Face f : mesh.surface().faces()) blocks[f] = f.index();
  struct Hears {
    AdaptiveMesh<std::string, decltype(&between)>& mesh;
    std::vector<std::string> log;
    Vertex pending;
    void operator()(const Change& change) {
      pending = change.made() ? change.made() : change.gone();
      log.push_back(change.made() ? "split" : "weld");
    }
    void operator()(const Refined& refined) {
      EXPECT_EQ(pending, refined.made);
      EXPECT_EQ(mesh[refined.made], between(mesh[refined.a], mesh[refined.b]));
      EXPECT_GT(mesh.level(refined.made), std::max(mesh.level(refined.a), mesh.level(refined.b)));
      log.push_back("refined");
    }
    void operator()(const Simplified& simplified) {
      EXPECT_EQ(pending, simplified.gone);
      EXPECT_FALSE(mesh.surface().is_live(simplified.gone));
      EXPECT_TRUE(mesh.mesh().is_block(simplified.edge));
      log.push_back("simplified");
    }
  };
  auto adaptive = adaptive_mesh<std::string>(&between);
  ASSERT_TRUE(adaptive.read(cube(), std::vector<std::string>(8, "x"), equal_lengths));
  Hears hears{adaptive, {}, {}};
  const Adapted done = adaptive.adapt(to_level(3), from_level(3), {}, hears);
  EXPECT_EQ(done.refined, 42u);
  EXPECT_EQ(adaptive.adapt(to_level(1), from_level(1), {}, hears).simplified, 36u);
  ASSERT_EQ(hears.log.size(), 2u * (42 + 36));
  for (std::size_t i = 0; i < hears.log.size(); i += 2) {
    EXPECT_EQ(hears.log[i], i < 84 ? "split" : "weld");
    EXPECT_EQ(hears.log[i + 1], i < 84 ? "refined" : "simplified");
  }
  // Containers: parts are of the base's face; new vertices have the initial value.
  marks[Vertex(3)] = 5;
  (void)mesh.adapt_refine(to_level(5));
  EXPECT_EQ(marks[Vertex(3)], 5);
  EXPECT_EQ(marks[Vertex(30)], 7);
  std::map<std::uint32_t, int> parts;
  for (const Face f : mesh.surface().faces()) ++parts[blocks[f]];
  EXPECT_EQ(parts.size(), 12u);
  for (const auto& [face, count] : parts) EXPECT_EQ(count, 32) << face;
  EXPECT_EQ(sides.values().size(), mesh.surface().half_edge_limit());
}

TEST(AdaptiveMesh, ReadsAgainAfterABaseThatItRefused) {
  auto mesh = adaptive_mesh<std::string>(between);
  const std::vector<std::string> names(8, "x");
  PolygonSurface bad = cube();
  bad.quads[3] = half_edge(Face(7), 0);
  const auto refused = mesh.read(std::move(bad), names, equal_lengths);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(), (Violation{Precondition::tri_quad, 21}));
  for (int time = 0; time < 2; ++time) {
    ASSERT_TRUE(mesh.read(cube(), names, equal_lengths));
    EXPECT_EQ(mesh.values(), names);
    EXPECT_EQ(mesh.adapt_refine(to_level(4)).refined, 90u);
  }
}

/// A sample that throws leaves a valid mesh with a value for every vertex.
TEST(AdaptiveMesh, SamplesMayThrow) {
  int left = 0;
  auto mesh = adaptive_mesh<double>([&](double a, double b) {
    if (--left == 0) throw std::string("no sample");
    return (a + b) / 2;
  });
  ASSERT_TRUE(mesh.read(cube(), Values(8, 1.), [](double, double) { return 1.; }));
  for (int after = 1; after < 60; after += 7) {
    left = after;
    EXPECT_THROW((void)mesh.adapt_refine(to_level(9)), std::string);
    ASSERT_EQ(mesh.values().size(), mesh.surface().vertex_limit());
    ASSERT_TRUE(validate(mesh.surface()).empty());
  }
  left = -1;
  (void)mesh.adapt_refine(to_level(4));
  for (const Vertex v : mesh.surface().vertices()) EXPECT_EQ(mesh[v], 1.);
}

TEST(AdaptiveMesh, FollowsAPriority) {
  const auto on_sphere = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
    std::array<double, 3> m{};
    for (std::size_t i = 0; i < 3; ++i) m[i] = a[i] + b[i];
    const double length = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    for (double& x : m) x /= length;
    return m;
  };
  using Place = std::array<double, 3>;
  auto mesh = adaptive_mesh<Place>(on_sphere);
  std::vector<Place> values;
  for (const int i : {0, 1, 3, 2, 4, 5, 7, 6}) {
    const double s = 1 / std::sqrt(3.);
    values.push_back({i & 1 ? s : -s, i & 2 ? s : -s, i & 4 ? s : -s});
  }
  ASSERT_TRUE(mesh.read(cube(), values, equal_lengths));
  // Edges near a point that moves are to be short. Of a vertex: of the edge that its weld restores.
  Place focus{1, 0, 0};
  const auto of_edge = [&](const Place& a, const Place& b, const Place& m) {
    double length = 0, distance = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      length += (a[i] - b[i]) * (a[i] - b[i]);
      distance += (m[i] - focus[i]) * (m[i] - focus[i]);
    }
    return std::sqrt(length) / (0.03 + 0.5 * std::sqrt(distance));
  };
  const auto priority = [&](const MultiTriangulation& m, auto id) {
    const Surface& s = m.surface();
    if constexpr (std::is_same_v<decltype(id), HalfEdge>)
      return of_edge(mesh[s.org(id)], mesh[s.dest(id)],
                     on_sphere(mesh[s.org(id)], mesh[s.dest(id)]));
    else {
      std::array<Vertex, 4> ring;
      std::size_t i = 0;
      for (const Vertex u : s.adjacent_vertices(id)) ring[i++] = u;
      return of_edge(mesh[ring[0]], mesh[ring[2]], mesh[id]);
    }
  };
  DynamicAdaptation dynamic(mesh.mesh(), priority, Thresholds{1, 0.7});
  NoObserver none;
  auto observer = mesh.follow(none);
  std::uint64_t refined = 0, simplified = 0;
  for (int frame = 0; frame < 30; ++frame) {
    focus = {std::cos(0.1 * frame), std::sin(0.1 * frame), 0};
    dynamic.all_changed();
    const Adapted done = dynamic.adapt({}, observer);
    refined += done.refined, simplified += done.simplified;
    for (const Face f : mesh.surface().faces()) {
      const HalfEdge h = half_edge(f, 1);
      EXPECT_LE(priority(mesh.mesh(), mesh.mesh().is_block(h) ? mesh.surface().edge(h) : h), 1);
    }
    for (const Vertex v : mesh.surface().vertices()) {
      EXPECT_NEAR(std::hypot(mesh[v][0], mesh[v][1], mesh[v][2]), 1, 1e-9);
    }
  }
  EXPECT_GT(refined, 1000u);
  EXPECT_GT(simplified, 800u);
  EXPECT_LT(mesh.surface().characteristic().f, 4000);
  EXPECT_TRUE(validate(mesh.surface()).empty());
}

}  // namespace
}  // namespace clers

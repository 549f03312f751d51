// Algorithm 5: fewer vertices where they were, the same topology, round triangles.
#include "topology/modeling/clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "topology/dump.h"
#include "topology/modeling/operator_log.h"
#include "topology/modeling/test/solids.h"
#include "topology/test/meshes.h"
#include "topology/validate.h"

namespace clers::test {
namespace {

bool is_simplicial(const Surface& s) {
  for (const Vertex v : s.vertices()) {
    std::vector<Vertex> around;
    for (const Vertex u : s.adjacent_vertices(v)) around.push_back(u);
    std::sort(around.begin(), around.end());
    if (std::adjacent_find(around.begin(), around.end()) != around.end()) return false;
    if (std::binary_search(around.begin(), around.end(), v)) return false;
  }
  return true;
}

/// The radius ratio that a twentieth of the faces fall short of: 1 equilateral.
double worst_twentieth(const Solid& s) {
  std::vector<double> ratios;
  for (const Face f : s.surface.faces()) {
    std::array<double, 3> l{};
    for (unsigned i = 0; i < 3; ++i) {
      const Position3 &a = s.at[s.surface.org(half_edge(f, i)).index()],
                      &b = s.at[s.surface.dest(half_edge(f, i)).index()];
      l[i] = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    ratios.push_back((l[0] + l[1] - l[2]) * (l[1] + l[2] - l[0]) * (l[2] + l[0] - l[1]) /
                     (l[0] * l[1] * l[2]));
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios[ratios.size() / 20];
}

TEST(Clusters, KeepTopologyAndPositionsAtAnySize) {
  Creases none;
  for (const Solid& whole : solids_of_each_kind()) {
    const Characteristic before = whole.surface.characteristic();
    for (const std::int64_t percent : {50, 10, 0}) {
      Solid s = whole;
      const auto done =
          simplify_by_clusters(s.surface, s.at, none, {.faces = before.f * percent / 100});
      ASSERT_TRUE(done);
      const Characteristic& now = s.surface.characteristic();
      EXPECT_TRUE(validate(s.surface).empty());
      EXPECT_TRUE(is_simplicial(s.surface));
      EXPECT_EQ(now.g, before.g);
      EXPECT_EQ(now.b, before.b);
      EXPECT_EQ(now.s, before.s);
      EXPECT_EQ(done->contracted, static_cast<std::uint64_t>(before.v - now.v));
      if (done->ended == SimplifyEnd::faces)
        EXPECT_LE(now.f, before.f * percent / 100);
      else
        EXPECT_EQ(done->ended, SimplifyEnd::smallest);
    }
  }
}

TEST(Clusters, AreRounderThanByErrorAlone) {
  // Columns four times as wide as rows are high.
  const Solid whole = round_torus(40, 80);
  Solid clusters = whole, edges = whole;
  Creases none;
  ASSERT_TRUE(simplify_by_clusters(clusters.surface, clusters.at, none, {.faces = 1600}));
  ASSERT_TRUE(simplify(edges.surface, edges.at, {.faces = 1600}));
  EXPECT_GT(worst_twentieth(clusters), 0.25);
  EXPECT_GT(worst_twentieth(clusters), worst_twentieth(whole));
  for (const Face f : clusters.surface.faces()) {
    Position3 middle{};
    for (const HalfEdge h : clusters.surface.star(f))
      for (std::size_t i = 0; i < 3; ++i)
        middle[i] += clusters.at[clusters.surface.org(h).index()][i] / 3;
    EXPECT_LT(std::fabs(std::hypot(std::hypot(middle[0], middle[1]) - 2, middle[2]) - 1), 0.05);
  }
}

TEST(Clusters, StopAtAnError) {
  Solid s = field(16, [](double x, double y) { return x > 8 ? (x - 8) * (x - 8) / 8 : 0 * y; });
  Creases none;
  const auto done = simplify_by_clusters(s.surface, s.at, none, {.error = 1e-3});
  ASSERT_TRUE(done);
  EXPECT_EQ(done->ended, SimplifyEnd::error);
  EXPECT_LE(done->error, 1e-3);
  std::size_t flat = 0, bent = 0;
  for (const Vertex v : s.surface.vertices())
    if (!s.surface.is_boundary(v)) ++(s.at[v.index()][0] < 8 ? flat : bent);
  EXPECT_LT(flat, 10u);
  EXPECT_EQ(bent, 8u * 15u);
}

TEST(Clusters, GoIndependently) {
  // Those of a step share no face; which it is, is said by steps().
  Solid s = round_torus(24, 16);
  Creases none;
  ClusterSimplification clusters(s.surface, s.at, none, {.faces = 200});
  std::vector<std::uint32_t> touched(s.at.size(), 0);
  std::uint64_t removals = 0;
  while (const auto r = clusters.next()) {
    EXPECT_NE(touched[r->vertex.index()], clusters.steps());
    for (const Vertex u : s.surface.adjacent_vertices(r->vertex))
      touched[u.index()] = clusters.steps();
    remove(s.surface, none, *r);
    clusters.removed(*r);
    EXPECT_FALSE(s.surface.is_live(r->vertex));
    ++removals;
  }
  EXPECT_GT(clusters.steps(), 2u);
  EXPECT_GT(removals, 4u * clusters.steps());
}

TEST(Clusters, LeaveCreasesAndCanBeUndone) {
  Solid s = field(12, [](double x, double) { return 6 - std::fabs(x - 6); });
  Creases ridge;
  for (const HalfEdge h : edges_of(s.surface))
    if (s.at[s.surface.org(h).index()][0] == 6 && s.at[s.surface.dest(h).index()][0] == 6)
      ridge.mark(s.surface, h);
  const std::string before = dump(s.surface);
  OperatorLog log;
  ASSERT_TRUE(simplify_by_clusters(s.surface, s.at, ridge, {.faces = 80}, log));
  std::size_t on_ridge = 0;
  for (const Vertex v : s.surface.vertices()) on_ridge += s.at[v.index()][0] == 6;
  EXPECT_EQ(on_ridge, 13u);
  std::size_t sharp = 0;
  for (const HalfEdge h : edges_of(s.surface))
    if (!s.surface.is_boundary(h) && ridge.is_sharp(s.surface, h)) {
      EXPECT_EQ(s.at[s.surface.org(h).index()][0], 6);
      EXPECT_EQ(s.at[s.surface.dest(h).index()][0], 6);
      ++sharp;
    }
  EXPECT_EQ(sharp, 12u);
  while (log.place() != 0) log.undo(s.surface);
  EXPECT_EQ(dump(s.surface), before);
}

TEST(Clusters, RefuseWhatTheyCannotUse) {
  Solid s = round_torus(5, 4);
  Creases none;
  EXPECT_EQ(simplify_by_clusters(s.surface, s.at, none, {.faces = -1}).error().rule,
            SimplifyRule::option);
  s.at[3][0] = std::nan("");
  EXPECT_EQ(simplify_by_clusters(s.surface, s.at, none, {}).error().vertex, 3u);
}

}  // namespace
}  // namespace clers::test

// Surfaces from triangles: what is accepted, and what is named when they are no manifold.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string>

#include "topology/equivalence.h"
#include "topology/stellar.h"
#include "topology/test/meshes.h"
#include "topology/validate.h"

namespace clers {
namespace {

using Corners = std::vector<std::uint32_t>;

std::string built(const Corners& corners, std::uint32_t vertices,
                  const std::vector<Point>& points = {}) {
  const auto s = Surface::from_faces(corners, vertices, points);
  if (!s) return describe(s.error());
  return validate(*s).empty() ? "surface" : "not valid";
}

/// The rules by definition, with maps: the first that the corners break, and where.
std::string judged(const Corners& corners, std::uint32_t vertices) {
  const auto next = [&](std::size_t h) { return corners[h % 3 == 2 ? h - 2 : h + 1]; };
  for (std::size_t h = 0; h < corners.size(); ++h)
    if (corners[h] >= vertices) return "vertex_in_range fails at half-edge " + std::to_string(h);
  for (std::size_t h = 0; h < corners.size(); ++h)
    if (corners[h] == next(h)) return "distinct_corners fails at face " + std::to_string(h / 3);
  std::map<std::set<std::uint32_t>, std::vector<std::size_t>> edges;
  for (std::size_t h = 0; h < corners.size(); ++h) edges[{corners[h], next(h)}].push_back(h);
  std::pair<std::size_t, std::string> first{~std::size_t{0}, ""};
  for (const auto& [ends, sides] : edges) {
    if (sides.size() > 2) first = std::min(first, {sides[2], "at_most_two_faces"});
    if (sides.size() == 2 && corners[sides[0]] == corners[sides[1]])
      first = std::min(first, {sides[1], "opposite_directions"});
  }
  if (!first.second.empty())
    return first.second + " fails at half-edge " + std::to_string(first.first);
  // Faces at a vertex, joined where they share an edge at it.
  for (std::uint32_t v = 0; v < vertices; ++v) {
    std::vector<std::size_t> around;
    for (std::size_t h = 0; h < corners.size(); ++h)
      if (corners[h] == v) around.push_back(h / 3);
    if (around.empty()) continue;
    std::set<std::size_t> reached{around[0]};
    for (bool more = true; more;) {
      more = false;
      for (const auto& [ends, sides] : edges)
        if (ends.count(v) && sides.size() == 2)
          if (reached.count(sides[0] / 3) != reached.count(sides[1] / 3)) {
            reached.insert({sides[0] / 3, sides[1] / 3});
            more = true;
          }
    }
    if (reached.size() != around.size()) return "one_fan fails at vertex " + std::to_string(v);
  }
  return "surface";
}

TEST(FromFaces, NamesTheFirstOffender) {
  EXPECT_EQ(built({}, 0), "surface");
  EXPECT_EQ(built({0, 1, 2}, 3), "surface");
  EXPECT_EQ(built({0, 1}, 3), "array_sizes fails at size 2");
  EXPECT_EQ(built({0, 1, 2}, 3, {Point(0)}), "array_sizes fails at size 1");
  EXPECT_EQ(built({0, 1, 3}, 3), "vertex_in_range fails at half-edge 2");
  EXPECT_EQ(built({0, 1, 2, 3, 1, 3}, 4), "distinct_corners fails at face 1");
  EXPECT_EQ(built({0, 1, 2, 1, 0, 3, 0, 1, 4}, 5), "at_most_two_faces fails at half-edge 6");
  EXPECT_EQ(built({0, 1, 2, 0, 1, 3}, 4), "opposite_directions fails at half-edge 3");
  EXPECT_EQ(built({0, 1, 2, 0, 3, 4}, 5), "one_fan fails at vertex 0");
  // A moebius strip cannot be oriented.
  EXPECT_EQ(built({0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 0, 4, 0, 1}, 5),
            "opposite_directions fails at half-edge 13");
}

TEST(FromFaces, JudgesAsTheRulesDo) {
  std::mt19937 random(3);
  std::map<std::string, int> seen;
  for (int i = 0; i < 30'000; ++i) {
    const std::uint32_t vertices = 4 + static_cast<std::uint32_t>(random() % 4);
    Corners corners;
    const std::size_t faces = 1 + random() % 5;
    for (std::size_t h = 0; h < 3 * faces; ++h)
      corners.push_back(static_cast<std::uint32_t>(random() % (vertices + (i % 50 == 0))));
    if (i % 20 != 0)  // no degenerate faces, that other rules are met
      for (std::size_t h = 0; h < corners.size(); h += 3) {
        corners[h + 1] = (corners[h] + 1 + static_cast<std::uint32_t>(random() % 2)) % vertices;
        corners[h + 2] = (corners[h] + 3) % vertices;
      }
    const std::string expected = judged(corners, vertices);
    ASSERT_EQ(built(corners, vertices), expected);
    ++seen[expected.substr(0, expected.find(' '))];
  }
  for (const char* rule : {"surface", "vertex_in_range", "distinct_corners", "at_most_two_faces",
                           "opposite_directions", "one_fan"})
    EXPECT_GT(seen[rule], 20) << rule;
}

TEST(FromFaces, GivesBackTheFacesOfSurfaces) {
  for (const Surface& s : {test::grid(7, 5), test::torus(6, 5), test::chain_of_tori(3, 5)}) {
    Surface dense = s;
    dense.compress();
    Corners corners;
    for (const Vertex v : dense.origins()) corners.push_back(v.index());
    const auto again = Surface::from_faces(corners, dense.vertex_limit(), dense.points());
    ASSERT_TRUE(again);
    EXPECT_TRUE(validate(*again).empty());
    EXPECT_TRUE(std::ranges::equal(again->origins(), dense.origins()));
    EXPECT_TRUE(std::ranges::equal(again->twins(), dense.twins()));
    EXPECT_TRUE(std::ranges::equal(again->points(), dense.points()));
    EXPECT_EQ(again->characteristic(), s.characteristic());
  }
}

}  // namespace
}  // namespace clers

// Faces that repeat others: found as by comparing all cycles, and left away as if they had never
// been.
#include "codec/soup/distinct_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

#include "corpus/generate.h"

namespace clers::internal {
namespace {

/// The least of all rotations of a face and of its reverse.
std::vector<std::uint32_t> canonical(std::span<const std::uint32_t> cycle) {
  std::vector<std::uint32_t> c(cycle.begin(), cycle.end()), least = c;
  for (int way = 0; way < 2; ++way) {
    for (std::size_t i = 0; i < c.size(); ++i) {
      std::rotate(c.begin(), c.begin() + 1, c.end());
      least = std::min(least, c);
    }
    std::reverse(c.begin(), c.end());
  }
  return least;
}

std::uint32_t below(std::mt19937& random, std::size_t n) {
  return static_cast<std::uint32_t>(random() % n);
}

/// Faces of 3 to `most` different corners, some of them there again, reversed and rotated.
Mesh with_repeats(std::mt19937& random, std::uint32_t most) {
  Mesh mesh = corpus::grid(3 + below(random, 5), 3 + below(random, 4));
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::size_t h = 0; h < mesh.corners.size(); h += 3)
    faces.push_back({mesh.corners[h], mesh.corners[h + 1], mesh.corners[h + 2]});
  for (int i = 0; i < 4 && most > 3; ++i) {
    std::vector<std::uint32_t> polygon;
    for (std::uint32_t v = below(random, 3); v < mesh.vertex_count && polygon.size() < most;
         v += 1 + below(random, 3))
      polygon.push_back(v);
    if (polygon.size() >= 3) faces.push_back(polygon);
  }
  const std::size_t distinct = faces.size();
  for (std::size_t i = 0; i < distinct; ++i) {
    if (below(random, 3) != 0) continue;
    std::vector<std::uint32_t> face = faces[i];
    std::rotate(face.begin(), face.begin() + below(random, face.size()), face.end());
    if (below(random, 2)) std::reverse(face.begin(), face.end());
    faces.insert(faces.begin() + below(random, faces.size() + 1), face);
  }
  mesh.corners.clear();
  for (const auto& face : faces) {
    mesh.corners.insert(mesh.corners.end(), face.begin(), face.end());
    if (most > 3) mesh.face_sizes.push_back(static_cast<std::uint32_t>(face.size()));
  }
  return mesh;
}

TEST(Repeats, RepeatTheFirstOfTheirCycle) {
  std::size_t found = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Mesh mesh = with_repeats(random, seed % 2 ? 3 : 6);
    const Faces faces(mesh.corners, mesh.face_sizes);
    std::map<std::vector<std::uint32_t>, std::uint32_t> first;
    for (std::uint32_t f = 0; f < faces.count(); ++f) first.insert({canonical(faces.cycle(f)), f});
    std::uint32_t last = 0;  // repeats come by ascending face, and face 0 repeats none
    for (const Repeat& r : find_repeats(faces, match_edges(faces, mesh.vertex_count))) {
      EXPECT_EQ(first.at(canonical(faces.cycle(r.face))), r.base);
      EXPECT_LT(r.base, r.face);
      EXPECT_GT(r.face, last);
      last = r.face;
      ++found;
    }
  }
  EXPECT_GT(found, 5000u);
}

TEST(Repeats, LeaveTheAdjacencyOfTheOthers) {
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Mesh mesh = with_repeats(random, seed % 2 ? 3 : 6);
    const Faces all(mesh.corners, mesh.face_sizes);
    Adjacency of_all = match_edges(all, mesh.vertex_count);
    // Any faces may go, not only those that repeat some.
    std::vector<Repeat> gone = find_repeats(all, of_all);
    if (seed % 3 == 0) {
      gone.clear();
      for (std::uint32_t f = 1; f < all.count(); ++f)
        if (below(random, 5) == 0) gone.push_back({f, 0});
    }
    const DistinctFaces distinct(all, gone);
    const Faces faces(distinct.corners, distinct.sizes);
    const Adjacency expected = match_edges(faces, mesh.vertex_count);
    const Adjacency found = distinct.adjacency(all, std::move(of_all));
    ASSERT_EQ(found.twins, expected.twins);
    ASSERT_EQ(found.sides, expected.sides);
    ASSERT_EQ(found.ends, expected.ends);
  }
}

}  // namespace
}  // namespace clers::internal

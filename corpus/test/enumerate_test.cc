#include "corpus/enumerate.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <vector>

#include "corpus/test/recount.h"

namespace clers::corpus {
namespace {

// 2 (4m-3)! / (m! (3m-1)!), m = n - 2 (Tutte 1962).
std::uint64_t tutte(std::uint64_t n) {
  const std::uint64_t m = n - 2;
  double count = 2;  // exact: all intermediate values are far below 2^53
  for (std::uint64_t k = 3 * m; k <= 4 * m - 3; ++k) count *= static_cast<double>(k);
  for (std::uint64_t k = 2; k <= m; ++k) count /= static_cast<double>(k);
  return static_cast<std::uint64_t>(count + 0.5);
}

TEST(Enumerate, CountsAreTuttes) {
  const std::vector<std::uint64_t> known = {1, 3, 13, 68, 399, 2530, 16965};
  for (std::uint32_t n = 4; n <= 10; ++n) {
    std::set<std::vector<std::uint32_t>> codes;
    std::uint64_t visits = 0;
    for_each_sphere_triangulation(n, [&](const Mesh& mesh) {
      ++visits;
      codes.insert(mesh.corners);
    });
    EXPECT_EQ(visits, known[n - 4]);
    EXPECT_EQ(visits, tutte(n));
    EXPECT_EQ(codes.size(), visits);
  }
}

TEST(Enumerate, EachIsASimpleSphereRootedAtItsFirstCorner) {
  for (std::uint32_t n = 4; n <= 9; ++n)
    for_each_sphere_triangulation(n, [&](const Mesh& mesh) {
      const Figures figures = recount(mesh);
      ASSERT_TRUE(figures.closed_surface());
      ASSERT_EQ(figures.vertices, n);
      ASSERT_EQ(figures.edges, 3 * n - 6);
      ASSERT_EQ(figures.faces, 2 * n - 4);
      ASSERT_EQ(figures.components, 1);
      ASSERT_EQ(figures.genus, 0);
      ASSERT_EQ(mesh.corners[0], 0u);
      ASSERT_EQ(mesh.corners[1], 1u);
    });
}

}  // namespace
}  // namespace clers::corpus

// Every way to glue a few triangles: all partial matchings of their half-edges, each glued in
// several orders, recounted by the oracle, unbuilt and built again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "topology/equivalence.h"
#include "topology/handlebody.h"
#include "topology/test/matchings.h"
#include "topology/test/oracle.h"
#include "topology/validate.h"

namespace clers {
namespace {

using test::Matching;
using test::Oracle;

struct Built {
  Surface surface;
  Oracle oracle;
};

Built triangles(std::uint32_t count) {
  Built b;
  for (std::uint32_t f = 0; f < count; ++f) {
    EXPECT_TRUE(b.surface.create(Point(3 * f), Point(3 * f + 1), Point(3 * f + 2)));
    b.oracle.create(f);
  }
  return b;
}

/// Glues the pairs in their order; the oracle judges every step if `each`, else the result.
Built glue_all(std::uint32_t faces, const Matching& pairs, bool each) {
  Built b = triangles(faces);
  for (const auto& [h0, h1] : pairs) {
    EXPECT_TRUE(b.surface.glue(HalfEdge(h0), HalfEdge(h1)));
    b.oracle.glue(h0, h1);
    if (each) {
      EXPECT_EQ(b.oracle.compare(b.surface), "");
    }
  }
  EXPECT_EQ(b.oracle.compare(b.surface), "");
  EXPECT_TRUE(validate(b.surface).empty());
  return b;
}

/// The same from arrays, with the oracle's vertices.
Surface from_oracle(const Oracle& oracle, const Matching& pairs) {
  const Oracle::Account account = oracle.recount();
  std::vector<Vertex> org;
  for (const int v : account.vertex_of) org.emplace_back(static_cast<std::uint32_t>(v));
  std::vector<HalfEdge> twin(org.size());
  for (const auto& [h0, h1] : pairs) {
    twin[h0] = HalfEdge(h1);
    twin[h1] = HalfEdge(h0);
  }
  auto s = Surface::from_twins(org, twin, static_cast<std::uint32_t>(account.total.v));
  EXPECT_TRUE(s);
  return s ? *std::move(s) : Surface();
}

/// Every stride-th matching of the half-edges of `faces` triangles; how many there are.
std::size_t check_matchings(std::uint32_t faces, int orders, bool each, std::size_t stride) {
  std::mt19937 random(7);
  std::size_t count = 0;
  test::for_each_matching(faces, [&](const Matching& matching) {
    if (count++ % stride != 0 || testing::Test::HasFailure()) return;
    Built first = glue_all(faces, matching, each);
    Matching shuffled = matching;
    for (int order = 1; order < orders; ++order) {
      std::shuffle(shuffled.begin(), shuffled.end(), random);
      for (auto& [h0, h1] : shuffled)
        if (random() % 2 == 0) std::swap(h0, h1);
      EXPECT_TRUE(equivalent(first.surface, glue_all(faces, shuffled, each).surface));
    }
    const Surface arrays = from_oracle(first.oracle, matching);
    EXPECT_TRUE(validate(arrays).empty());
    EXPECT_EQ(first.oracle.compare(arrays), "");
    EXPECT_TRUE(equivalent(first.surface, arrays));

    // Theorem 11, and back.
    const Characteristic counted = first.surface.characteristic();
    const Surface whole = first.surface;
    const Handlebody handlebody = unbuild(first.surface);
    EXPECT_EQ(first.surface.characteristic(), Characteristic{});
    EXPECT_TRUE(validate(first.surface).empty());
    EXPECT_EQ(lambda(handlebody.counts()), counted);
    const auto again = build(handlebody);
    ASSERT_TRUE(again);
    EXPECT_TRUE(equivalent(*again, whole));
  });
  return count;
}

bool long_run() {
  return std::getenv("CLERS_LONG") != nullptr;
}

TEST(Gluings, OfOneTriangle) {
  EXPECT_EQ(check_matchings(1, 4, true, 1), 4u);
}
TEST(Gluings, OfTwoTriangles) {
  EXPECT_EQ(check_matchings(2, 6, true, 1), 76u);
}
TEST(Gluings, OfThreeTriangles) {
  EXPECT_EQ(check_matchings(3, 4, true, 1), 2620u);
}
TEST(Gluings, OfFourTriangles) {
  EXPECT_EQ(check_matchings(4, 3, false, long_run() ? 1 : 17), 140152u);
}

}  // namespace
}  // namespace clers

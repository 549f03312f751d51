// From where values are predicted without twins: by definition, and both forms of the search alike.
#include "codec/attributes/hexagon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <set>

#include "codec/test/coded_arrays.h"
#include "corpus/generate.h"

namespace clers::internal {
namespace {

using test::any_triangles;
using test::coded_without_twins;

/// Both forms of the search for steps are the same, and lead from lesser vertices.
void check_steps(const CodedSurface& surface, std::size_t count) {
  for (unsigned p = 0; p < order_predictors; ++p) {
    OrderSteps one(surface, static_cast<OrderPredictor>(p)), many(one);
    for_each_step(many, 0, count, [&](std::size_t v, const OrderStep<std::uint32_t>& s) {
      one.find(static_cast<std::uint32_t>(v), 1);
      const OrderStep<std::uint32_t> same = one[0];
      EXPECT_EQ(s.from, same.from);
      EXPECT_EQ(s.to, same.to);
      EXPECT_EQ(s.origin, same.origin);
      EXPECT_EQ(s.halving, same.halving);
      EXPECT_LT(s.from, v);
      EXPECT_LT(s.to, v);
      EXPECT_LT(s.origin, v);
      EXPECT_LT(s.halving, 2u);
    });
  }
}

TEST(Hexagon, FourAtATimeAsOneByOne) {
  std::mt19937_64 random(5);
  for (const std::uint32_t vertices : {1u, 2u, 3u, 5u, 20u, 300u, 1000u})
    for (const std::uint32_t triangles : {0u, 1u, 2u, 3u, vertices, 2 * vertices})
      check_steps(any_triangles(vertices, triangles, random).view(), vertices + 9);
  for (const Mesh& mesh : {corpus::icosphere(3), corpus::grid(30, 20), corpus::torus(20, 30),
                           corpus::loose_triangles(50), corpus::strip(60),
                           corpus::flip_edges(corpus::icosphere(3), 2000, 1)}) {
    const CodedArrays arrays = coded_without_twins(mesh);
    check_steps(arrays.view(), arrays.introduced_by.size());
  }
}

TEST(Hexagon, IsWhatItsPictureSays) {
  const CodedArrays arrays = coded_without_twins(corpus::torus(40, 30));
  const CodedSurface surface = arrays.view();
  using Triple = std::array<std::uint32_t, 3>;
  std::set<Triple> faces;
  const auto sorted = [](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    Triple t{a, b, c};
    std::sort(t.begin(), t.end());
    return t;
  };
  for (std::size_t h = 0; h < surface.corners.size(); h += 3)
    faces.insert(sorted(surface.corners[h], surface.corners[h + 1], surface.corners[h + 2]));
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return faces.count(sorted(a, b, c)) != 0;
  };
  const std::size_t count = surface.introduced_by.size();
  std::size_t parallelograms = 0, hexagons = 0;
  OrderSteps steps(surface, OrderPredictor::hexagon);
  for_each_step(steps, 0, count, [&](std::size_t i, const OrderStep<std::uint32_t>& s) {
    const auto v = static_cast<std::uint32_t>(i);
    if (s.halving == 0) {
      parallelograms += face(s.from, s.to, s.origin) && face(s.from, s.to, v);
    } else {
      for (std::uint32_t pivot = 0; pivot < count; ++pivot)
        hexagons += face(s.origin, s.from, pivot) && face(s.from, v, pivot) &&
                    face(v, s.to, pivot) && s.origin != v;
    }
  });
  EXPECT_GT(hexagons, count / 2);
  EXPECT_GT(parallelograms + hexagons, count * 9 / 10);
}

}  // namespace
}  // namespace clers::internal

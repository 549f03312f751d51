// Copies of components, by maps that are known; and the fit of maps alone.
#include "codec/attributes/copies.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "codec/test/coded_surfaces.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

using test::coded;

using Map = std::array<std::array<double, 4>, 3>;

/// Components that are one rough shape, each mapped by one of the maps and rounded.
template <class Int>
std::vector<Int> rows_of(const Originals& originals, std::size_t vertices, double size,
                         const std::vector<Map>& maps) {
  std::vector<Int> rows(3 * vertices);
  std::vector<std::array<double, 3>> shape(vertices);
  corpus::Random random(1);
  // Originals come before their copies in no order of numbers.
  const auto place = [&](auto self, std::uint32_t v) -> std::array<double, 3> {
    if (originals.of[v] != Originals::none) return self(self, originals.of[v]);
    if (shape[v] == std::array<double, 3>())
      for (double& x : shape[v]) x = size * (random.below(1000) + 1) / 1000.;
    return shape[v];
  };
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const auto x = place(place, v);
    const Map& m = maps[originals.component[v]];
    for (std::size_t i = 0; i < 3; ++i)
      rows[3 * std::size_t(v) + i] =
          static_cast<Int>(m[i][0] * x[0] + m[i][1] * x[1] + m[i][2] * x[2] + m[i][3] + .5);
  }
  return rows;
}

struct Met {
  std::size_t guessed = 0, near = 0;
  std::vector<std::int64_t> guesses;
};

/// Meets the vertices in coded order. Before one is known nobody may look at its row.
template <class Int>
Met meet(const CodedSurface& surface, const Originals& originals, const std::vector<Int>& rows,
         std::uint64_t top, Int near) {
  std::vector<Int> known(rows.size(), Int(-1));
  const std::array<Axis, 3> axes = {Axis{top}, Axis{top}, Axis{top}};
  Copies<Int> copies(originals, known.data(), axes);
  Met met;
  for_each_introduced(surface, [&](std::uint32_t t, unsigned i) {
    const std::uint32_t* c = &surface.corners[3 * std::size_t(t)];
    const HalfEdge across = surface.twins[3 * std::size_t(t)];
    std::array<Int, 3> place = {};
    if (i == 2) {
      const bool guessed = copies.guess(
          c[2], c[0], c[1], across ? surface.corners[lprev(across).index()] : Originals::none,
          place.data());
      bool is_near = guessed;
      for (std::size_t k = 0; guessed && k < 3; ++k) {
        EXPECT_GE(place[k], 0);
        EXPECT_LE(std::uint64_t(place[k]), top);
        const Int off = place[k] - rows[3 * c[2] + k];
        is_near = is_near && off >= -near && off <= near;
        met.guesses.push_back(place[k]);
      }
      met.guessed += guessed;
      met.near += is_near;
    }
    const auto row = rows.begin() + 3 * std::ptrdiff_t(c[i]);
    std::copy(row, row + 3, known.begin() + 3 * std::ptrdiff_t(c[i]));
    copies.known(c[i]);
  });
  return met;
}

/// Moved, turned by a quarter, mirrored; turned by 3-4-5 triangles and stretched.
const std::vector<Map> maps = {
    Map{{{1, 0, 0, 500}, {0, 1, 0, 900}, {0, 0, 1, 0}}},
    Map{{{1, 0, 0, 900}, {0, 1, 0, 70}, {0, 0, 1, 1000}}},
    Map{{{0, 1, 0, 700}, {-1, 0, 0, 2000}, {0, 0, 1, 10}}},
    Map{{{1, 0, 0, 100}, {0, 1, 0, 100}, {0, 0, -1, 3000}}},
    Map{{{.6, .8, 0, 500}, {-.8, .6, 0, 1500}, {0, 0, 1, 100}}},
    Map{{{.9, 1.2, 0, 500}, {-1.2, .9, 0, 1800}, {.3, 0, 1.5, 100}}},
};

TEST(Copies, FindsComponentsOfTheSameConnectivity) {
  const std::array<Mesh, 3> meshes = {corpus::icosphere(2), corpus::copies(corpus::torus(9, 7), 3),
                                      corpus::icosphere(2)};
  const CodedArrays arrays = coded(corpus::disjoint_union(meshes));
  const Originals originals = find_originals(arrays.view());
  EXPECT_EQ(originals.count, 162u + 2 * 63);
  for (std::uint32_t v = 0; v < originals.of.size(); ++v)
    if (const std::uint32_t w = originals.of[v]; w != Originals::none) {
      EXPECT_LT(originals.component[w], originals.component[v]);
    }
  // What follows from it: corner by corner, faces are those of the original.
  const auto faces = static_cast<std::uint32_t>(arrays.corners.size() / 3);
  std::size_t matched = 0;
  for (std::uint32_t t = 0; t < faces; ++t) {
    const std::uint32_t w = originals.of[arrays.corners[3 * t]];
    if (w == Originals::none) continue;
    for (std::uint32_t u = 0; u < faces; ++u) {
      bool same = true;
      for (std::uint32_t i = 0; i < 3; ++i)
        same = same && arrays.corners[3 * u + i] == originals.of[arrays.corners[3 * t + i]];
      matched += same;
    }
  }
  EXPECT_EQ(matched, 320u + 2 * 126);
  EXPECT_EQ(find_originals({arrays.corners, {}, arrays.introduced_by}).count, 0u);
  EXPECT_EQ(find_originals({}).count, 0u);
}

TEST(Copies, AreGuessedWhateverTheMap) {
  const CodedArrays arrays =
      coded(corpus::copies(corpus::icosphere(2), static_cast<std::uint32_t>(maps.size())));
  const CodedSurface surface = arrays.view();
  const Originals originals = find_originals(surface);
  const std::size_t vertices = arrays.introduced_by.size();
  ASSERT_EQ(originals.count, vertices / maps.size() * (maps.size() - 1));
  const auto rows = rows_of<std::int32_t>(originals, vertices, 1000, maps);
  const Met met = meet(surface, originals, rows, 4095, 2);
  EXPECT_GT(met.guessed, originals.count * 9 / 10);
  EXPECT_GT(met.near, originals.count * 9 / 10);
  const std::array<Axis, 3> axes = {Axis{4095}, Axis{4095}, Axis{4095}};
  auto owned = rows;
  EXPECT_TRUE(copies_pay<std::int32_t>(surface, originals, {owned, axes}));
  // The same in wide integers; and far larger ones, of which the fit knows the upper bits.
  const std::vector<std::int64_t> wide(rows.begin(), rows.end());
  EXPECT_EQ(meet<std::int64_t>(surface, originals, wide, 4095, 2).guesses, met.guesses);
  auto large = wide;
  for (std::int64_t& x : large) x *= std::int64_t(1) << 40;
  EXPECT_GT(meet<std::int64_t>(surface, originals, large, (std::uint64_t(1) << 52) - 1,
                               std::int64_t(8) << 40)
                .near,
            originals.count * 9 / 10);
}

TEST(Copies, AreGuessedWithinTheTopsWhateverTheIntegers) {
  const CodedArrays arrays = coded(corpus::copies(corpus::icosphere(2), 4));
  const Originals originals = find_originals(arrays.view());
  corpus::Random random(3);
  for (const std::uint64_t top : {std::uint64_t(0), std::uint64_t(4095), most_wide}) {
    std::vector<std::int64_t> rows(3 * arrays.introduced_by.size());
    for (std::int64_t& x : rows) x = std::int64_t(random.next() % (top + 1));
    const Met met = meet<std::int64_t>(arrays.view(), originals, rows, top, 0);
    EXPECT_GT(met.guessed, 0u);
    const std::array<Axis, 3> axes = {Axis{top}, Axis{top}, Axis{top}};
    EXPECT_EQ(copies_pay<std::int64_t>(arrays.view(), originals, {rows, axes}), top > 0);
    EXPECT_FALSE(copies_pay<std::int64_t>(arrays.view(), {}, {rows, axes}));
  }
  // Narrow ones at the greatest top.
  std::vector<std::int32_t> rows(3 * arrays.introduced_by.size());
  for (std::int32_t& x : rows) x = std::int32_t(random.next() % (most_narrow + 1));
  EXPECT_GT(meet<std::int32_t>(arrays.view(), originals, rows, most_narrow, 0).guessed, 0u);
}

TEST(Copies, WithoutTwinsNothingIsGuessed) {
  const CodedArrays arrays = coded(corpus::copies(corpus::icosphere(1), 2));
  const CodedSurface bare = {arrays.corners, {}, arrays.introduced_by};
  const Originals originals = find_originals(bare);
  const std::vector<std::int32_t> rows(3 * arrays.introduced_by.size());
  const std::array<Axis, 3> axes = {Axis{1}, Axis{1}, Axis{1}};
  Copies<std::int32_t> copies(originals, rows.data(), axes);
  std::array<std::int32_t, 3> place;
  for (std::uint32_t v = 2; v < arrays.introduced_by.size(); ++v) {
    EXPECT_FALSE(copies.guess(v, v - 1, v - 2, Originals::none, place.data()));
    copies.known(v);
  }
}

TEST(Copies, FitFindsTheMap) {
  corpus::Random random(5);
  const auto number = [&](unsigned bits) {
    const std::int64_t most = std::int64_t(1) << bits;
    return std::int64_t(random.next() % std::uint64_t(2 * most + 1)) - most;
  };
  for (int round = 0; round < 200; ++round) {
    std::array<LinearFit::Vector, 3> map;
    for (auto& r : map)
      for (std::int64_t& x : r) x = number(15);
    LinearFit fit;
    for (int n = 0; n < 40; ++n) {
      LinearFit::Vector from, to = {};
      for (std::int64_t& x : from) x = number(12);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) to[i] += map[i][j] * from[j];
      for (std::int64_t& x : to) x = (x + (1 << 13)) >> 14;
      fit.add(from, to);
    }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        EXPECT_NEAR(double(fit.map()[i][j]), double(map[i][j]), 64) << i << j;
    fit.clear();
    EXPECT_EQ(fit.map()[0], (LinearFit::Vector{1 << 14, 0, 0}));
    // On a line, in a plane, opposite, all extremes: no entry is beyond all.
    const LinearFit::Vector most = {1 << 20, -(1 << 20), 1 << 20};
    for (int n = 0; n < 300; ++n) {
      LinearFit::Vector from = most, to = most;
      if (round % 3 == 1) from = {0, number(20), 0};
      if (round % 3 == 2) from = {number(1), number(20), number(20)};
      if (round % 2 == 1)
        for (std::int64_t& x : to) x = number(20);
      fit.add(from, to);
      for (const auto& r : fit.map())
        for (const std::int64_t x : r) EXPECT_LE(std::abs(x), 1 << LinearFit::most_bits);
    }
  }
}

}  // namespace
}  // namespace clers::internal

// Positions in contexts of sizes: any integers along any surface come back, and no bytes do harm.
#include "codec/attributes/sized_positions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "codec/attributes/residual_sizes.h"
#include "codec/connectivity/connectivity.h"
#include "codec/soup/adjacency.h"
#include "codec/test/coded_surfaces.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

constexpr VisitOrder orders[] = {VisitOrder::introduction, VisitOrder::parallelograms};

template <class Int>
struct Positions {
  std::vector<Int> rows;
  std::vector<Axis> axes;

  Lattice<Int> lattice() { return {rows, axes}; }
};

/// A random number of at most so many bits, each length alike.
std::uint64_t any(corpus::Random& random, std::uint64_t top) {
  const std::uint64_t bits = std::uint64_t(random.below(1u << 30)) << 30 | random.below(1u << 30);
  return std::min(bits >> random.below(60), top);
}

/// Axes of all kinds with tops up to this.
std::vector<Axis> any_axes(corpus::Random& random, std::uint64_t top) {
  std::vector<Axis> axes(3);
  const bool equal = random.below(2) == 0;
  for (Axis& axis : axes) {
    axis.top = equal ? top : any(random, top);
    if (equal) continue;
    axis.scale = 1 + random.below(random.below(2) == 0 ? 4 : 65535);
    if (random.below(3) > 0) continue;
    for (unsigned n = 1 + random.below(20); n > 0; --n)
      axis.palette.push_back(any(random, axis.top));
    std::sort(axis.palette.begin(), axis.palette.end());
    axis.palette.erase(std::unique(axis.palette.begin(), axis.palette.end()), axis.palette.end());
  }
  return axes;
}

/// Integers that are far apart, near each other, and at the ends.
template <class Int>
Positions<Int> any_positions(corpus::Random& random, std::size_t count, std::vector<Axis> axes) {
  Positions<Int> p{std::vector<Int>(3 * count), std::move(axes)};
  const unsigned kind = random.below(3);
  for (std::size_t i = 0; i < p.rows.size(); ++i) {
    const Axis& axis = p.axes[i % 3];
    std::uint64_t x = kind == 0   ? any(random, axis.top)
                      : kind == 1 ? (random.below(2) == 0 ? 0 : axis.top)
                                  : std::min(axis.top / 2 + random.below(9), axis.top);
    if (!axis.palette.empty())
      x = axis.palette[random.below(static_cast<std::uint32_t>(axis.palette.size()))];
    p.rows[i] = static_cast<Int>(x);
  }
  return p;
}

template <class Int>
void check_range(const Positions<Int>& p) {
  for (std::size_t i = 0; i < p.rows.size(); ++i) {
    const Axis& axis = p.axes[i % 3];
    ASSERT_LE(static_cast<std::uint64_t>(p.rows[i]), axis.top);
  }
}

/// Encodes and decodes; then decodes what was changed and what was cut off.
template <class Int>
void check(const CodedSurface& surface, Positions<Int> p, VisitOrder order,
           corpus::Random& random) {
  const Bytes bytes = encode_sized_positions(surface, p.lattice(), order);
  Positions<Int> out = p;
  for (Int& x : out.rows) x = static_cast<Int>(~any(random, most_wide));
  const auto done = decode_sized_positions(bytes, 0, surface, out.lattice());
  ASSERT_TRUE(done.ok()) << done.error().what;
  ASSERT_EQ(out.rows, p.rows);
  ASSERT_EQ(encode_sized_positions(surface, out.lattice(), order), bytes);
  for (unsigned i = 0; i < 4; ++i) {
    Bytes changed = bytes;
    if (i < 2)
      changed[random.below(static_cast<std::uint32_t>(bytes.size()))] ^=
          static_cast<std::byte>(1 + random.below(255));
    else if (i == 2)
      changed.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
    else
      changed.push_back(static_cast<std::byte>(random.below(256)));
    const auto result = decode_sized_positions(changed, 7, surface, out.lattice());
    ASSERT_TRUE(i < 2 || !result.ok());
    if (result.ok()) check_range(out);
  }
}

TEST(SizedPositions, ComeBackAlongAnySurface) {
  corpus::Random random(1);
  for (const CodedArrays& s : test::coded_surfaces()) {
    CodedSurface surface = s.view();
    const std::size_t count = s.introduced_by.size() + random.below(4);
    if (random.below(4) == 0) surface.twins = {};
    for (const VisitOrder order : orders) {
      const std::uint64_t top = any(random, most_narrow);
      check(surface, any_positions<std::int32_t>(random, count, any_axes(random, top)), order,
            random);
      check(surface,
            any_positions<std::int64_t>(random, count, any_axes(random, any(random, most_wide))),
            order, random);
    }
  }
}

TEST(SizedPositions, ComeBackAtTheEndsOfRanges) {
  corpus::Random random(2);
  const CodedArrays s = test::coded(corpus::torus(20, 15));
  for (const std::uint64_t top :
       {std::uint64_t(0), std::uint64_t(1), (std::uint64_t(1) << 14) - 1, std::uint64_t(1) << 14,
        (std::uint64_t(1) << 26) - 1, std::uint64_t(1) << 26, most_narrow})
    for (unsigned i = 0; i < 6; ++i) {
      Axis axis{top};
      axis.scale = i == 5 ? 65535 : 1;
      check(s.view(), any_positions<std::int32_t>(random, 300, {axis, axis, {top}}), orders[i % 2],
            random);
      axis.top = most_wide;
      check(s.view(), any_positions<std::int64_t>(random, 300, {axis, axis, axis}), orders[i % 2],
            random);
    }
}

TEST(SizedPositions, ComeBackWithoutTriangles) {
  corpus::Random random(3);
  for (const std::size_t count : {0u, 1u, 2u, 100u}) {
    check({}, any_positions<std::int32_t>(random, count, any_axes(random, 5000)),
          VisitOrder::parallelograms, random);
    check({}, any_positions<std::int64_t>(random, count, any_axes(random, most_wide)),
          VisitOrder::introduction, random);
  }
}

/// A sphere on 12 bits: fewer than 13 of 36 bits a vertex.
TEST(SizedPositions, AreSmallWhereSurfacesAreSmooth) {
  const Mesh mesh = corpus::icosphere(4);
  auto twins = find_twins({mesh.corners, {}}, mesh.vertex_count);
  const auto coded = encode_connectivity({mesh.corners, *twins, mesh.vertex_count}, 5);
  const CodedArrays s = test::decoded(coded->bytes);
  Positions<std::int32_t> p{{}, std::vector<Axis>(3, Axis{4095})};
  for (const std::uint32_t v : coded->vertices)
    for (std::size_t i = 0; i < 3; ++i) {
      float x = 0;
      std::memcpy(&x, mesh.attributes[0].data.data() + 4 * (3 * std::size_t(v) + i), 4);
      p.rows.push_back(std::clamp(static_cast<int>((x + 1) * 2047.5f), 0, 4095));
    }
  for (const VisitOrder order : orders)
    EXPECT_LT(8 * encode_sized_positions(s.view(), p.lattice(), order).size(),
              13 * s.introduced_by.size());
}

/// Copies of half a sphere, of which each is its own mirror image: far smaller than one by one, and
/// no bytes do harm there either.
TEST(SizedPositions, UseCopiesAndImages) {
  corpus::Random random(5);
  const Mesh mesh = corpus::copies(corpus::icosphere(3), 4);
  auto twins = find_twins({mesh.corners, {}}, mesh.vertex_count);
  const auto coded = encode_connectivity({mesh.corners, *twins, mesh.vertex_count}, 5);
  const CodedArrays s = test::decoded(coded->bytes);
  const std::uint32_t each = mesh.vertex_count / 4;
  Positions<std::int32_t> p{{}, std::vector<Axis>(3, Axis{1 << 15})};
  for (const std::uint32_t v : coded->vertices)
    for (std::size_t i = 0; i < 3; ++i) {
      float x = 0;
      std::memcpy(&x, mesh.attributes[0].data.data() + 4 * (3 * std::size_t(v % each) + i), 4);
      p.rows.push_back(static_cast<int>(std::lround(x * 2000) + (i == 0 ? 5000 * (v / each) : 0)) +
                       4000);
    }
  for (const VisitOrder order : orders) {
    EXPECT_LT(8 * encode_sized_positions(s.view(), p.lattice(), order).size(),
              9 * s.introduced_by.size());
    for (unsigned i = 0; i < 5; ++i) check(s.view(), p, order, random);
  }
}

unsigned repetition(const Bytes& bytes) {
  return std::to_integer<unsigned>(bytes[0]) >> 2;
}

template <class Int>
void expect_profiles_to_repeat(unsigned bits) {
  corpus::Random random(6);
  const auto [s, rows] = test::moved_profile<Int>(bits);
  const Positions<Int> p{rows, std::vector<Axis>(3, Axis{(std::uint64_t(1) << bits) - 1})};
  for (const VisitOrder order : orders) {
    auto lattice = p;
    const Bytes bytes = encode_sized_positions(s.view(), lattice.lattice(), order);
    EXPECT_NE(repetition(bytes), 0u);
    // Forty and sixty different numbers, and little to say which.
    EXPECT_LT(8 * bytes.size(), s.introduced_by.size() * 2 + 120 * std::size_t(bits + 6));
    for (unsigned i = 0; i < 20; ++i) check(s.view(), p, order, random);
  }
}
TEST(SizedPositions, ProfilesRepeatThemselves) {
  expect_profiles_to_repeat<std::int32_t>(12);
  expect_profiles_to_repeat<std::int32_t>(28);
  expect_profiles_to_repeat<std::int64_t>(55);
}

/// Two sides of a rough plate, far from each other along the surface: x and z of the second are
/// those of the first, y is not. Takes less than where they are others.
TEST(SizedPositions, LinesAreFound) {
  corpus::Random random(7);
  const auto plate = [](bool same) {
    return test::coded_torus<std::int32_t>(40, 30, [same](std::uint32_t i, std::uint32_t j) {
      const std::uint32_t k = std::min(i, 39 - i), place = 30 * (same ? k : i) + j;
      return std::array{190 * k + test::rough(place, 6), test::rough(10000 + 30 * i + j, 12),
                        130 * j + test::rough(20000 + place, 6)};
    });
  };
  const std::vector<Axis> axes(3, Axis{8191});
  const auto [s, rows] = plate(true);
  Positions<std::int32_t> p{rows, axes}, other{plate(false).second, axes};
  for (const VisitOrder order : orders) {
    const Bytes bytes = encode_sized_positions(s.view(), p.lattice(), order);
    EXPECT_EQ(repetition(bytes), 2u);
    EXPECT_LT(bytes.size() * 100,
              encode_sized_positions(s.view(), other.lattice(), order).size() * 90);
    for (unsigned i = 0; i < 20; ++i) check(s.view(), p, order, random);
  }
}

/// Places that come again with any period, at the ends of what numbers can be.
TEST(SizedPositions, PeriodsComeBack) {
  corpus::Random random(8);
  const CodedArrays s = test::coded(corpus::torus(20, 15));
  const auto repeated = [](auto p, std::size_t period) {
    for (std::size_t i = 3 * period; i < p.rows.size(); ++i) p.rows[i] = p.rows[i - 3 * period];
    return p;
  };
  for (const std::size_t period : {1u, 2u, 3u, 20u, 151u})
    for (const VisitOrder order : orders)
      for (const std::uint64_t top : {std::uint64_t(1), std::uint64_t(1) << 13, most_narrow}) {
        check(s.view(),
              repeated(any_positions<std::int32_t>(random, 300, any_axes(random, top)), period),
              order, random);
        check(s.view(),
              repeated(any_positions<std::int64_t>(random, 300, std::vector<Axis>(3, {most_wide})),
                       period),
              order, random);
      }
}

TEST(SizedPositions, NothingIsAskedWhereNothingRepeats) {
  for (const VisitOrder order : orders) {
    const auto [s, rows] =
        test::coded_torus<std::int32_t>(40, 30, [](std::uint32_t i, std::uint32_t j) {
          return std::array<std::uint64_t, 3>{50 * i + test::rough(i * 30 + j, 3),
                                              90 * j + test::rough(40 * j + i, 4),
                                              2 * i * j + test::rough(7 * i + j, 2)};
        });
    Positions<std::int32_t> p{rows, std::vector<Axis>(3, Axis{4095})};
    EXPECT_EQ(repetition(encode_sized_positions(s.view(), p.lattice(), order)), 0u);
  }
}

TEST(ResidualSizes, GrowByQuarterOctaves) {
  EXPECT_EQ(size_of(0), 0u);
  EXPECT_EQ(size_of(4), 4u);
  EXPECT_EQ(size_of(12), 8u);
  EXPECT_EQ(size_of(28), 12u);
  EXPECT_LE(size_of((std::uint64_t(1) << 62) - 1), 240u);
  for (std::uint64_t x = 0; x < 5000; ++x) ASSERT_LE(size_of(x), size_of(x + 1));
}

}  // namespace
}  // namespace clers::internal

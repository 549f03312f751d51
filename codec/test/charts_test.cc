// Values of charts: any integers along any surface come back, and no bytes do harm; charts of known
// kinds take next to nothing.
#include "codec/attributes/charts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "codec/attributes/parallelograms.h"
#include "codec/attributes/places.h"
#include "codec/attributes/unfolding.h"
#include "codec/test/coded_surfaces.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

template <class T>
Attribute positions(const std::vector<T>& values, std::uint8_t components = 3) {
  Attribute a{position_name, Domain::vertex, scalar_of<T>(), components, {}};
  a.data.resize(values.size() * sizeof(T));
  if (!values.empty()) std::memcpy(a.data.data(), values.data(), a.data.size());
  return a;
}

/// A random number of at most so many bits, each length alike.
std::uint64_t any(corpus::Random& random, std::uint64_t top) {
  const std::uint64_t bits = std::uint64_t(random.below(1u << 30)) << 30 | random.below(1u << 30);
  return std::min(bits >> random.below(60), top);
}

std::vector<Axis> any_axes(corpus::Random& random, std::uint64_t top) {
  std::vector<Axis> axes(2);
  for (Axis& axis : axes) {
    axis.top = any(random, top);
    axis.scale = 1 + random.below(random.chance(50) ? 4 : 65535);
    if (random.chance(70)) continue;
    for (unsigned n = 1 + random.below(20); n > 0; --n)
      axis.palette.push_back(any(random, axis.top));
    std::sort(axis.palette.begin(), axis.palette.end());
    axis.palette.erase(std::unique(axis.palette.begin(), axis.palette.end()), axis.palette.end());
  }
  return axes;
}

/// Integers that are far apart, at the ends, near each other, and few.
template <class Int>
std::vector<Int> any_rows(corpus::Random& random, std::size_t count, std::span<const Axis> axes) {
  std::vector<Int> rows(2 * count);
  const unsigned kind = random.below(4);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Axis& axis = axes[i % 2];
    std::uint64_t x = kind == 0   ? any(random, axis.top)
                      : kind == 1 ? (random.chance(50) ? 0 : axis.top)
                      : kind == 2 ? std::min(axis.top / 2 + random.below(9), axis.top)
                                  : std::min<std::uint64_t>(random.below(3), axis.top);
    if (!axis.palette.empty())
      x = axis.palette[random.below(static_cast<std::uint32_t>(axis.palette.size()))];
    rows[i] = static_cast<Int>(x);
  }
  return rows;
}

/// Encodes and decodes; then decodes what was changed and what was cut off.
template <class Int>
void check(const ValueSurface& along, std::size_t count, std::uint64_t top, int level,
           corpus::Random& random) {
  const std::vector<Axis> axes = any_axes(random, top);
  std::vector<Int> rows = any_rows<Int>(random, count, axes);
  const std::vector<Int> given = rows;
  const Bytes bytes = encode_charts(Lattice<Int>{rows, axes}, along, level);
  ASSERT_EQ(rows, given);
  std::vector<Int> out(rows.size());
  for (Int& x : out) x = static_cast<Int>(random.next());
  const auto done = decode_charts<Int>(bytes, 0, axes, along, out);
  ASSERT_TRUE(done.ok()) << done.error().what;
  ASSERT_EQ(out, given);
  if (bytes.empty()) return;
  for (unsigned i = 0; i < 6; ++i) {
    Bytes changed = bytes;
    if (i < 4)
      changed[random.below(std::min<std::uint32_t>(static_cast<std::uint32_t>(bytes.size()),
                                                   i < 2 ? 1u << 20 : 24))] ^=
          static_cast<std::byte>(1 + random.below(255));
    else if (i == 4)
      changed.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
    else
      changed.push_back(static_cast<std::byte>(random.below(256)));
    const auto result = decode_charts<Int>(changed, 7, axes, along, out);
    ASSERT_TRUE(i < 4 || !result.ok());
    if (!result.ok()) {
      ASSERT_GE(result.error().at, 7u);
      continue;
    }
    for (std::size_t k = 0; k < out.size(); ++k) {
      const Axis& axis = axes[k % 2];
      ASSERT_LE(static_cast<std::uint64_t>(out[k]), axis.top);
      ASSERT_TRUE(axis.palette.empty() ||
                  std::binary_search(axis.palette.begin(), axis.palette.end(),
                                     static_cast<std::uint64_t>(out[k])));
    }
  }
}

/// Some sides are seams, and each fan of corners between them has a value of its own; or a few are
/// made one.
struct CutSurface {
  CodedArrays arrays;
  std::vector<std::uint32_t> vertex_of;
};
CutSurface cut(CodedArrays s, unsigned percent, corpus::Random& random) {
  const std::vector<std::uint32_t> vertices = s.corners;
  CutSurface result;
  for (std::uint32_t h = 0; h < s.twins.size(); ++h)
    if (const HalfEdge twin = s.twins[h]; twin && random.chance(percent))
      s.twins[h] = s.twins[twin.index()] = HalfEdge();
  std::vector<bool> done(s.corners.size());
  for (std::uint32_t first = 0; first < s.corners.size(); ++first) {
    if (done[first]) continue;
    const auto value = static_cast<std::uint32_t>(result.vertex_of.size());
    result.vertex_of.push_back(vertices[first]);
    for_each_around(CodedSurface{s.corners, s.twins, s.introduced_by}, HalfEdge(first),
                    [&](HalfEdge h) {
                      done[h.index()] = true;
                      s.corners[h.index()] = value;
                    });
  }
  s.introduced_by.resize(result.vertex_of.size());
  find_introducing(s.corners, s.introduced_by);
  result.arrays = std::move(s);
  return result;
}

TEST(Charts, ComeBackAlongAnySurface) {
  corpus::Random random(1);
  for (const CodedArrays& s : test::coded_surfaces()) {
    std::uint32_t vertices = 0;
    for (const std::uint32_t v : s.corners) vertices = std::max(vertices, v + 1);
    const CutSurface c = cut(s, random.below(3) * 30, random);
    std::vector<float> place(3 * vertices);
    for (float& x : place) x = static_cast<float>(random.below(1000)) * (random.chance(90) ? 1 : 0);
    const Attribute position = positions(place);
    ValueSurface along{c.arrays.view(), c.vertex_of, &position};
    if (random.chance(20)) along.surface.twins = {};
    if (random.chance(20)) along.position = nullptr;
    const int level = random.chance(50) ? 5 : 9;
    check<std::int32_t>(along, c.vertex_of.size(), any(random, most_narrow), level, random);
    check<std::int64_t>(along, c.vertex_of.size(), any(random, most_wide), level, random);
    // Of vertices, and some in no triangle.
    along = {s.view(), {}, &position};
    check<std::int32_t>(along, s.introduced_by.size() + random.below(4), 4095, level, random);
  }
}

TEST(Charts, ComeBackAtTheEndsOfRanges) {
  corpus::Random random(2);
  const CodedArrays s = test::coded(corpus::torus(12, 9));
  std::vector<double> place(3 * s.introduced_by.size());
  for (double& x : place) x = static_cast<double>(random.below(100));
  const Attribute position = positions(place);
  for (const std::uint64_t top : {std::uint64_t(0), std::uint64_t(1), std::uint64_t(1) << 20,
                                  most_narrow, std::uint64_t(1) << 35, most_wide})
    for (int i = 0; i < 6; ++i) {
      const ValueSurface along{s.view(), {}, &position};
      if (top <= most_narrow) check<std::int32_t>(along, 108, top, 5 + 4 * (i % 2), random);
      check<std::int64_t>(along, 108, top, 5 + 4 * (i % 2), random);
    }
}

TEST(Charts, ComeBackWithoutTriangles) {
  corpus::Random random(3);
  for (const std::size_t count : {0u, 1u, 2u, 100u}) {
    check<std::int32_t>({}, count, 5000, 9, random);
    check<std::int64_t>({}, count, most_wide, 5, random);
  }
}

TEST(Charts, OtherThanTwoComponentsAndNoValuesAreRefused) {
  const std::vector<Axis> axes(2, Axis{5}), three(3, Axis{5});
  std::vector<std::int32_t> out;
  const Bytes byte{std::byte(0)};
  EXPECT_FALSE(decode_charts<std::int32_t>(byte, 0, axes, {}, out).ok());
  EXPECT_TRUE(decode_charts<std::int32_t>({}, 0, axes, {}, out).ok());
  EXPECT_FALSE(decode_charts<std::int32_t>({}, 0, three, {}, out).ok());
  out.resize(2);
  EXPECT_FALSE(decode_charts<std::int32_t>({}, 0, axes, {}, out).ok());
  // An order of visit and values that are alike, without twins; a mirror beyond all values.
  for (const Bytes& options : {Bytes{std::byte(1), std::byte(0)}, Bytes{std::byte(0), std::byte(1)},
                               Bytes{std::byte(0), std::byte(2), std::byte(11)},
                               Bytes{std::byte(0), std::byte(4), std::byte(1)}}) {
    Bytes bytes = options;
    bytes.resize(bytes.size() + 30);
    const auto done = decode_charts<std::int32_t>(bytes, 0, axes, {}, out);
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().code, ErrorCode::invalid);
  }
}

TEST(Charts, ThirdComponentsThatAreTheSameEverywhere) {
  const CodedArrays s = test::coded(corpus::torus(12, 9));
  const std::vector<Axis> axes = {Axis{50}, Axis{60}, Axis{0}, Axis{9, 1, {7}}};
  corpus::Random random(8);
  std::vector<std::int32_t> rows;
  for (std::size_t v = 0; v < s.introduced_by.size(); ++v)
    rows.insert(rows.end(), {static_cast<std::int32_t>(random.below(51)),
                             static_cast<std::int32_t>(random.below(61)), 0, 7});
  EXPECT_TRUE(may_be_charts(axes));
  EXPECT_FALSE(may_be_charts(std::span(axes).first(1)));
  const Bytes bytes = encode_charts(Lattice<std::int32_t>{rows, axes}, {s.view(), {}, nullptr}, 5);
  std::vector<std::int32_t> out(rows.size(), -1);
  ASSERT_TRUE(decode_charts<std::int32_t>(bytes, 0, axes, {s.view(), {}, nullptr}, out).ok());
  EXPECT_EQ(out, rows);
}

TEST(Charts, ShapeSaysWhatIsInThem) {
  // A grid whose vertices were moved at random in its plane, tilted in space, and the plane laid
  // flat and stretched: parallelograms do not know the chart, the shape does.
  const CodedArrays s = test::coded(corpus::grid(40, 30));
  const std::size_t count = s.introduced_by.size();
  std::vector<std::array<std::int32_t, 2>> at(count);
  for_each_introduced(s.view(), [&](std::uint32_t t, unsigned i) {
    const std::uint32_t *c = &s.corners[3 * std::size_t(t)], v = c[i];
    const HalfEdge over = s.twins[3 * std::size_t(t)];
    if (i < 2 || !over)
      at[v] = {i == 1, i == 2};
    else
      for (std::size_t k = 0; k < 2; ++k)
        at[v][k] = at[c[0]][k] + at[c[1]][k] - at[s.corners[lprev(over).index()]][k];
  });
  corpus::Random random(4);
  std::vector<float> place;
  std::vector<std::int32_t> rows;
  for (const auto& [i, j] : at) {
    const auto moved = [&](std::int32_t k) {
      return static_cast<float>(10 * k + static_cast<std::int32_t>(random.below(4)));
    };
    const float x = moved(i), y = moved(j);
    place.insert(place.end(), {x, y, 0.5f * x - 2 * y});
    rows.push_back(2000 + static_cast<std::int32_t>(std::lround(2 * x + y)));
    rows.push_back(2000 + static_cast<std::int32_t>(std::lround(3 * y)));
  }
  const std::vector<Axis> axes(2, Axis{4095});
  const auto bits = [&](const Attribute* position) {
    return 8 * encode_charts(Lattice<std::int32_t>{rows, axes}, {s.view(), {}, position}, 5).size();
  };
  for (const std::int32_t x : rows) ASSERT_TRUE(x >= 0 && x < 4096);
  const Attribute position = positions(place);
  EXPECT_LT(bits(&position), count * 5);
  EXPECT_GT(bits(nullptr), count * 8);
}

TEST(Charts, ThatLieOnOthersOrMirrorThemSave) {
  // Two grids, one after the other, the same rough values on both, or those of a mirror.
  const CodedArrays s = test::coded(corpus::copies(corpus::grid(30, 20), 2));
  const std::size_t half = s.introduced_by.size() / 2;
  std::vector<std::uint32_t> order;
  for_each_introduced(s.view(),
                      [&](std::uint32_t t, unsigned i) { order.push_back(s.corners[3 * t + i]); });
  ASSERT_EQ(order.size(), 2 * half);
  for (const bool mirrored : {false, true}) {
    corpus::Random random(5);
    std::vector<std::int32_t> rows(4 * half);
    for (std::size_t i = 0; i < half; ++i) {
      const auto u = static_cast<std::int32_t>(random.below(4096)),
                 v = static_cast<std::int32_t>(random.below(4096));
      const std::size_t one = 2 * std::size_t(order[i]), two = 2 * std::size_t(order[half + i]);
      rows[one] = u;
      rows[two] = mirrored ? 4095 - u : u;
      rows[one + 1] = rows[two + 1] = v;
    }
    const std::vector<Axis> axes(2, Axis{4095});
    const std::size_t bits =
        8 * encode_charts(Lattice<std::int32_t>{rows, axes}, {s.view(), {}, nullptr}, 5).size();
    EXPECT_LT(bits, half * 29) << mirrored;
  }
}

TEST(Charts, OfOneTriangleEachAreShapes) {
  // Triangles of two shapes at random places: 2 times 12 bits each.
  corpus::Random random(6);
  const CutSurface c = cut(test::coded(corpus::torus(30, 20)), 100, random);
  std::vector<std::int32_t> rows(2 * c.vertex_of.size());
  for (std::size_t t = 0; t < rows.size() / 6; ++t) {
    const auto u = static_cast<std::int32_t>(random.below(4000)),
               v = static_cast<std::int32_t>(random.below(4000));
    const bool flipped = random.chance(50);
    const std::int32_t du[3] = {0, 8, flipped ? 0 : 8}, dv[3] = {0, flipped ? 8 : 0, 8};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t value = 2 * std::size_t(c.arrays.corners[3 * t + i]);
      rows[value] = u + du[i];
      rows[value + 1] = v + dv[i];
    }
  }
  const std::vector<Axis> axes(2, Axis{4095});
  const std::size_t bits = 8 * encode_charts(Lattice<std::int32_t>{rows, axes},
                                             {c.arrays.view(), c.vertex_of, nullptr}, 5)
                                   .size();
  EXPECT_LT(bits, rows.size() / 6 * 30);
}

TEST(Places, AreOnAGridWhateverTheTypeAndTheRange) {
  const auto ends = [](const Attribute& a) {
    const std::vector<GridPlace> places = places_of(&a);
    for (const GridPlace& p : places)
      for (const std::int32_t x : p) EXPECT_TRUE(x >= 0 && x < 1 << place_bits);
    return places.back()[0];
  };
  EXPECT_EQ(ends(positions<float>({0, 0, 0, 1, 2, 3})), (1 << place_bits) / 4);
  EXPECT_GE(ends(positions<double>({1e300, 0, 0, -1e300, 0, 0, 1e300, 1, 1})),
            1 << (place_bits - 1));
  EXPECT_EQ(ends(positions<double>({0, 0, 0, 5e-324, 0, 0})), 0);
  EXPECT_GE(ends(positions<float>({6000000, 0, 0, 6000001, 0, 0})), 1 << (place_bits - 1));
  EXPECT_GE(ends(positions<std::int64_t>({std::numeric_limits<std::int64_t>::min(), 0, 0,
                                          std::numeric_limits<std::int64_t>::max(), 0, 0})),
            1 << (place_bits - 1));
  EXPECT_GE(
      ends(positions<std::uint64_t>({0, 0, 0, std::numeric_limits<std::uint64_t>::max(), 0, 0})),
      1 << (place_bits - 1));
  EXPECT_GE(ends(positions<std::int8_t>({-128, 0, 0, 127, 0, 0})), 1 << (place_bits - 1));
  const double inf = std::numeric_limits<double>::infinity();
  ends(positions<double>({inf, -inf, std::nan(""), 1, 2, 3}));
  EXPECT_EQ(ends(positions<float>({7, 7, 7})), 0);
  EXPECT_GE(ends(positions<float>({1, 2}, 1)), 1 << (place_bits - 1));
  EXPECT_TRUE(places_of(nullptr).empty());
}

TEST(Unfolding, IsTheAffineMap) {
  // Of a plane, the map is that of the plane: b - a and o - a add up to v - a.
  corpus::Random random(7);
  for (int i = 0; i < 2000; ++i) {
    GridPlace a, b, o, v;
    const auto coordinate = [&] { return static_cast<std::int32_t>(random.below(1 << 18)); };
    for (unsigned c = 0; c < 2; ++c) {
      a[c] = coordinate(), b[c] = coordinate(), o[c] = coordinate(), v[c] = coordinate();
    }
    for (GridPlace* p : {&a, &b, &o, &v}) (*p)[2] = ((*p)[0] + (*p)[1]) & ~1;
    const auto side = [&](const GridPlace& p) {
      return std::int64_t(b[0] - a[0]) * (p[1] - a[1]) - std::int64_t(b[1] - a[1]) * (p[0] - a[0]);
    };
    Unfolded flat;
    if (!unfold(a, b, o, v, flat) || (side(o) > 0) == (side(v) > 0)) continue;
    const double q = double(flat.q) / 65536, r = double(flat.r) / 65536;
    for (unsigned c = 0; c < 2; ++c)
      EXPECT_NEAR(v[c] - a[c], q * (b[c] - a[c]) - r * (o[c] - a[c]), 2000) << i;
  }
  Unfolded flat;
  EXPECT_FALSE(unfold({1, 2, 3}, {1, 2, 3}, {5, 6, 7}, {8, 8, 8}, flat));
  EXPECT_FALSE(unfold({0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {8, 8, 8}, flat));
  EXPECT_FALSE(unfold_alike({1, 2, 3}, {1, 2, 3}, {5, 6, 7}, flat));
  const std::int32_t far = (1 << place_bits) - 1;
  EXPECT_FALSE(unfold({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {far, far, far}, flat));
  ASSERT_TRUE(unfold({0, 0, 0}, {far, far, far}, {0, 0, far}, {far, 0, far}, flat));
  ASSERT_TRUE(unfold_alike({0, 0, 0}, {far, 0, 0}, {far, far, 0}, flat));
  EXPECT_EQ(flat.q, 65536);
  EXPECT_NEAR(double(flat.r), 65536, 64);
}

TEST(Unfolding, RootsAreExact) {
  for (const std::int64_t r : {0, 1, 2, 3, 65535, 47453132, 47453133, (1 << 26) - 1, 1 << 26}) {
    EXPECT_EQ(square_root(r * r), r);
    EXPECT_EQ(square_root(r * r - (r > 0)), r - (r > 0));
  }
}

}  // namespace
}  // namespace clers::internal

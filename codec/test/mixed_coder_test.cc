// Positions coded by a mix of experts: they come back, and no bytes do harm.
#include "codec/attributes/mixed_coder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/attributes/distribution.h"
#include "codec/attributes/fixed_point.h"
#include "codec/entropy/mixer.h"
#include "codec/test/coded_surfaces.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

using corpus::Random;

std::vector<Axis> axes(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return {{x, 1, {}}, {y, 1, {}}, {z, 1, {}}};
}

/// Integers that lie on a smooth surface or nearly so, or anywhere, or are all the same.
template <class Int>
std::vector<Int> integers(std::span<const Axis> axes, std::size_t values, Random& random) {
  std::vector<Int> rows(3 * values);
  const std::uint32_t kind = random.below(4);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Axis& axis = axes[i % 3];
    const double wave = .5 + .45 * std::sin(.07 * double(i / 3) + double(i % 3));
    std::uint64_t k = kind == 0 ? axis.top / 3 : random.next() % (axis.top + 1);
    if (kind == 1) k = static_cast<std::uint64_t>(wave * double(axis.top));
    if (kind == 2)
      k = static_cast<std::uint64_t>(wave * double(axis.top)) + random.below(3) * (axis.top > 3);
    k = std::min(k, axis.top);
    if (!axis.palette.empty()) k = axis.palette[k % axis.palette.size()];
    rows[i] = static_cast<Int>(k);
  }
  return rows;
}

template <class Int>
void comes_back(const CodedSurface& surface, std::span<const Axis> axes, std::vector<Int> rows) {
  const Bytes bytes = encode_mixed(surface, Lattice<Int>{rows, axes});
  std::vector<Int> decoded(rows.size(), Int(-1));
  const auto done = decode_mixed(bytes, 0, surface, Lattice<Int>{decoded, axes});
  ASSERT_TRUE(done.ok()) << done.error().what;
  EXPECT_EQ(decoded, rows);
}

std::vector<std::vector<Axis>> all_axes() {
  std::vector<std::vector<Axis>> all = {axes(0, 0, 0),
                                        axes(1, 0, 1),
                                        axes(2047, 2047, 1300),
                                        axes(16383, 1, 70),
                                        axes(most_narrow, most_narrow, most_narrow),
                                        axes(most_narrow, 0, 3)};
  all.push_back(axes(3000, 4000, 900));
  all.back()[0].scale = all.back()[1].scale = 30;
  all.push_back(axes(most_narrow, most_narrow, 5));
  all.back()[0].scale = 65535, all.back()[2].scale = 999;
  all.push_back(axes(5000, most_narrow, 5000));
  all.back()[0].palette = {3, 4, 700, 5000};
  all.back()[1].palette = {0, most_narrow};
  all.back()[2].palette = {17};
  return all;
}

std::vector<std::vector<Axis>> wide_axes() {
  std::vector<std::vector<Axis>> all = {axes(most_wide, most_wide, most_wide),
                                        axes(most_wide, 0, 1),
                                        axes(std::uint64_t(1) << 40, 1u << 30, 7)};
  all.push_back(axes(most_wide, most_wide, 1000));
  all.back()[0].scale = 65535, all.back()[1].scale = 3;
  all.push_back(axes(most_wide, most_wide, 9));
  all.back()[0].palette = {0, 1, most_wide / 2, most_wide};
  return all;
}

TEST(MixedCoder, Returns) {
  Random random(1);
  const auto narrow = all_axes(), wide = wide_axes();
  std::size_t next = 0;
  for (const CodedArrays& arrays : test::coded_surfaces(90)) {
    const std::size_t isolated = random.below(4);
    const std::size_t values = arrays.introduced_by.size() + isolated;
    CodedSurface surface = arrays.view();
    for (unsigned i = 0; i < 4; ++i, ++next) {
      if (i == 3) surface.twins = {};
      const auto& a = narrow[next % narrow.size()];
      comes_back(surface, a, integers<std::int32_t>(a, values, random));
      const auto& b = next % 2 == 0 ? a : wide[next % wide.size()];
      comes_back(surface, b, integers<std::int64_t>(b, values, random));
    }
  }
}

TEST(MixedCoder, ReturnsWhatNoTriangleHas) {
  Random random(2);
  for (const std::size_t values : {0u, 1u, 2u, 300u})
    for (const auto& a : all_axes())
      comes_back(CodedSurface{}, a, integers<std::int32_t>(a, values, random));
  // Holes in the numbers of those that have triangles.
  const std::vector<std::uint32_t> corners = {1, 4, 6, 6, 4, 2, 2, 2, 9};
  std::vector<std::uint32_t> introduced_by(11);
  find_introducing(corners, introduced_by);
  const auto a = axes(1000, 1000, 1000);
  comes_back(CodedSurface{corners, {}, introduced_by}, a, integers<std::int32_t>(a, 12, random));
}

/// Whatever the bytes, an error or integers that axes allow.
template <class Int>
void does_no_harm(const Bytes& bytes, const CodedSurface& surface, std::span<const Axis> axes,
                  std::size_t values) {
  std::vector<Int> rows(3 * values);
  const auto done = decode_mixed(bytes, 7, surface, Lattice<Int>{rows, axes});
  if (!done.ok()) {
    EXPECT_TRUE(done.error().code == ErrorCode::invalid ||
                (done.error().code == ErrorCode::truncated && bytes.size() < 12));
    EXPECT_GE(done.error().at, 7u);
    return;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Axis& axis = axes[i % 3];
    EXPECT_LE(static_cast<std::uint64_t>(rows[i]), axis.top);
    EXPECT_TRUE(axis.palette.empty() || std::binary_search(axis.palette.begin(), axis.palette.end(),
                                                           static_cast<std::uint64_t>(rows[i])));
  }
}

/// What repeats is asked for, takes less than a third of what it is, and harms nobody.
template <class Int>
void repeats_itself(unsigned bits, Random& random) {
  const auto [arrays, rows] = test::moved_profile<Int>(bits);
  const std::uint64_t top = (std::uint64_t(1) << bits) - 1;
  const auto all = axes(top, top, top);
  std::vector<Int> given = rows;
  const Bytes bytes = encode_mixed(arrays.view(), Lattice<Int>{given, all});
  EXPECT_NE(std::to_integer<unsigned>(bytes[1]) >> 1, 0u);  // no symmetry, then this
  EXPECT_LT(8 * bytes.size(), rows.size() * bits / 3);
  comes_back(arrays.view(), all, rows);
  for (unsigned i = 0; i < 40; ++i) {
    Bytes changed = bytes;
    changed[random.below(static_cast<std::uint32_t>(bytes.size()))] ^=
        static_cast<std::byte>(1 + random.below(255));
    if (i % 4 == 0) changed.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
    does_no_harm<Int>(changed, arrays.view(), all, rows.size() / 3);
  }
}
TEST(MixedCoder, ProfilesRepeatThemselves) {
  Random random(3);
  repeats_itself<std::int32_t>(12, random);
  repeats_itself<std::int64_t>(50, random);
}

template <class Int>
void bears_any_bytes(const std::vector<std::vector<Axis>>& all, Random& random) {
  for (const CodedArrays& arrays : test::coded_surfaces(90)) {
    const CodedSurface surface = arrays.view();
    const std::size_t values = arrays.introduced_by.size() + 2;
    const auto& a = all[random.below(static_cast<std::uint32_t>(all.size()))];
    auto rows = integers<Int>(a, values, random);
    const Bytes bytes = encode_mixed(surface, Lattice<Int>{rows, a});
    for (unsigned i = 0; i < 9; ++i) {
      Bytes other = bytes;
      if (i % 3 == 0) other.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
      if (i % 3 == 1) other.push_back(static_cast<std::byte>(random.below(256)));
      for (unsigned k = 0; k < i && !other.empty(); ++k)
        other[random.below(static_cast<std::uint32_t>(other.size()))] =
            static_cast<std::byte>(random.below(256));
      does_no_harm<Int>(other, surface, a, values);
    }
  }
}

TEST(MixedCoder, BearsAnyBytes) {
  Random random(3);
  bears_any_bytes<std::int32_t>(all_axes(), random);
  bears_any_bytes<std::int64_t>(wide_axes(), random);
}

TEST(MixedCoder, EndsWhereItsBytesEnd) {
  Random random(4);
  const CodedArrays arrays = test::coded(corpus::torus(9, 7));
  const auto a = axes(2047, 2047, 2047);
  auto rows = integers<std::int32_t>(a, 63, random);
  Bytes bytes = encode_mixed(arrays.view(), Lattice<std::int32_t>{rows, a});
  bytes.push_back(std::byte(1));
  bytes.push_back(std::byte(1));
  EXPECT_FALSE(decode_mixed(bytes, 0, arrays.view(), Lattice<std::int32_t>{rows, a}).ok());
}

/// What no compiler or machine may change.
TEST(MixedCoder, BytesAreTheSameEverywhere) {
  const CodedArrays arrays = test::coded(corpus::punch_holes(corpus::torus(20, 15), 12, 1));
  const auto a = axes(16383, 16383, 16383);
  Random random(5);
  std::vector<std::int32_t> rows;
  std::int32_t at[3] = {8000, 8000, 8000};
  for (std::size_t i = 0; i < 3 * arrays.introduced_by.size(); ++i) {
    at[i % 3] =
        std::clamp(at[i % 3] + static_cast<std::int32_t>(random.below(401)) - 200, 0, 16383);
    rows.push_back(at[i % 3]);
  }
  std::uint64_t hash = 0;
  for (const std::byte b : encode_mixed(arrays.view(), Lattice<std::int32_t>{rows, a}))
    hash = (hash ^ std::to_integer<std::uint64_t>(b)) * 0x100000001b3;
  EXPECT_EQ(hash, 11551141412282627693u);
}

TEST(Mixer, LearnsTheSameWithAndWithoutVectors) {
  Random random(6);
  alignas(16) std::int16_t x[16];
  alignas(16) std::int32_t w[16], other[16];
  for (unsigned i = 0; i < 16; ++i) {
    x[i] = static_cast<std::int16_t>(random.next());
    w[i] = other[i] = static_cast<std::int32_t>(random.next());
  }
  for (unsigned i = 0; i < 1000; ++i) {
    const auto e = static_cast<std::int16_t>(random.next());
    mixer::train<6>(x, w, 16, e);
    mixer::portable::train<6>(x, other, 16, e);
    EXPECT_TRUE(std::equal(w, w + 16, other));
    EXPECT_EQ(mixer::dot(x, w, 16), mixer::portable::dot(x, w, 16));
  }
}

TEST(FixedPoint, IsNearTheTruth) {
  for (double x = 1; x < 1.8e19; x = 1.013 * x + 1) {
    const auto k = static_cast<std::uint64_t>(x);
    EXPECT_NEAR(fixed::log2(k), 256 * std::log2(double(k)), 1.5);
  }
  for (int log = -2048; log < 40 * 256; log += 7)
    EXPECT_NEAR(double(fixed::exp2(log)), 65536 * std::exp2(log / 256.),
                1 + 65536 * std::exp2(log / 256.) * 2e-5);
  for (double x = 1 << 28; x < 4294967295.; x *= 1.001)
    EXPECT_NEAR(double(fixed::inverse_root(static_cast<std::uint64_t>(x))) * std::sqrt(x),
                double(1 << 30), double(1 << 30) / 8192);
  EXPECT_EQ(fixed::multiply_high(~std::uint64_t(0), ~std::uint64_t(0)), ~std::uint64_t(1));
}

TEST(MissDistribution, IsNearTheTruth) {
  const MissDistribution& tables = MissDistribution::tables();
  const auto survival = [](double z) {
    return .85 / (1 + std::exp(1.9 * z)) + .15 / (1 + std::exp(.7 * z));
  };
  const auto logistic = [](double k, double z) {
    const double a = std::exp(-k * std::abs(z));
    return k * a / (1 + a) / (1 + a);
  };
  const auto density = [&](double z) { return .85 * logistic(1.9, z) + .15 * logistic(.7, z); };
  const auto limited = [](double logit) { return std::clamp(256 * logit, -2815., 2815.); };
  const int top = tables.log_density(0);
  for (int z = -MissDistribution::most; z <= MissDistribution::most; ++z) {
    const double x = z / 128.;
    EXPECT_NEAR(tables.survival(z), 4096 * std::log(survival(x)), 1.1);
    EXPECT_NEAR(tables.log_density(z) - top, 256 * std::log(density(x) / density(0)), 1.6);
    for (int to = z + 3; to <= std::min(z + 700, MissDistribution::most); to += 41) {
      const double r = std::log(survival(x) / survival(to / 128.));
      if (r < .02) continue;
      EXPECT_NEAR(tables.odds(tables.survival(z) - tables.survival(to)),
                  limited(-std::log(std::expm1(r))), 6);
    }
  }
  EXPECT_EQ(tables.odds(0), 2815);
  EXPECT_EQ(tables.odds(1 << 20), -2815);
}

}  // namespace
}  // namespace clers::internal

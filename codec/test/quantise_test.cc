// Values on grids: what comes out, by how much it is off, and what cannot be on any.
#include "codec/numbers/quantise.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "codec/base/difference.h"
#include "codec/numbers/floating_maps.h"
#include "codec/numbers/number_encoder.h"
#include "codec/numbers/number_format.h"

namespace clers::internal {
namespace {

template <class T>
AttributeView view_of(const std::vector<T>& values, std::uint8_t components) {
  return attribute_view("position", values, components);
}

/// The values that are decoded of integers.
template <class T>
std::vector<T> values_of_integers(const QuantisedValues& quantised) {
  if constexpr (std::is_floating_point_v<T>) {
    const AttributePlan& plan = quantised.plan;
    EXPECT_EQ(plan.integers_of, scalar_of<T>());
    std::vector<std::int32_t> ks(quantised.values.size() / sizeof(std::int32_t));
    std::memcpy(ks.data(), quantised.values.data(), quantised.values.size());
    std::vector<T> values;
    for (std::size_t i = 0; i < ks.size(); ++i) {
      const NumberSystem& s = plan.systems[i % plan.systems.size()];
      EXPECT_FALSE(has_refinements(s));
      const std::int64_t n = s.first + ks[i] * static_cast<std::int64_t>(s.step);
      with_map<T>(s, scalar_of<T>(),
                  [&](const auto& map) { values.push_back(std::bit_cast<T>(map.word(n, 0))); });
    }
    return values;
  } else {
    ADD_FAILURE() << "integers of integers";
    return {};
  }
}

/// The values that come out; those that went in where nothing is changed.
template <class T>
std::vector<T> values_of(const QuantisedValues& quantised, const std::vector<T>& given) {
  if (quantised.plan.integers_of) return values_of_integers<T>(quantised);
  std::vector<T> values = given;
  if (!quantised.values.empty()) {
    EXPECT_EQ(quantised.values.size(), given.size() * sizeof(T));
    std::memcpy(values.data(), quantised.values.data(), quantised.values.size());
  }
  return values;
}

template <class T>
double largest_difference(const std::vector<T>& a, const std::vector<T>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, difference(a[i], b[i]));
  return largest;
}

/// Quantises, and looks whether the error that is stated is there.
template <class T>
std::vector<T> quantised(const std::vector<T>& values, std::uint8_t components,
                         const Precision& precision, double* error = nullptr) {
  const auto out = quantise(view_of(values, components), precision);
  EXPECT_TRUE(out.ok()) << (out ? "" : describe(out.error()));
  if (!out) return values;
  const std::vector<T> moved = values_of(*out, values);
  EXPECT_EQ(out->plan.error, largest_difference(values, moved));
  if (out->plan.error == 0) {
    EXPECT_TRUE(out->values.empty());
    EXPECT_TRUE(out->plan.systems.empty());
  } else if (!out->plan.systems.empty()) {  // those of extreme numbers are found later
    EXPECT_EQ(out->plan.systems.size(), components);
  }
  if (error != nullptr) *error = out->plan.error;
  return moved;
}

/// What a type rounds numbers as large as x by, and arithmetic of doubles.
template <class T>
double rounding(double x) {
  const double unit = std::nextafter(x, std::numeric_limits<double>::infinity()) - x;
  if constexpr (!std::is_floating_point_v<T>) return .5 + 2 * unit;
  const T t = static_cast<T>(x);
  return 2 * unit +
         .5 * (static_cast<double>(std::nextafter(t, std::numeric_limits<T>::infinity())) -
               static_cast<double>(t));
}

template <class T>
std::vector<T> random_values(std::size_t count, double from, double to, std::mt19937& random) {
  std::vector<T> values(count);
  for (T& x : values) x = static_cast<T>(std::uniform_real_distribution<double>(from, to)(random));
  return values;
}

template <class T>
class QuantiseTyped : public testing::Test {};
using Types = testing::Types<float, double, std::int8_t, std::uint16_t, std::int32_t, std::int64_t>;
TYPED_TEST_SUITE(QuantiseTyped, Types);

TYPED_TEST(QuantiseTyped, BitsAreThoseOfTheBoundingBox) {
  using T = TypeParam;
  std::mt19937 random(1);
  const bool small = sizeof(T) == 1;
  for (int bits = min_bits; bits <= max_bits; ++bits)
    for (const double from : {0., small ? -100. : 0., sizeof(T) > 2 ? 5e6 : 0.}) {
      const double to = from + (small ? 120 : sizeof(T) == 2 ? 60000 : 977);
      const std::vector<T> values = random_values<T>(300, from, to, random);
      T least[3], greatest[3];
      double longest = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        least[c] = greatest[c] = values[c];
        for (std::size_t i = c; i < values.size(); i += 3) {
          least[c] = std::min(least[c], values[i]);
          greatest[c] = std::max(greatest[c], values[i]);
        }
        longest = std::max(longest, difference(least[c], greatest[c]));
      }
      const double steps = std::ldexp(1., bits) - 1, step = longest / steps;
      double error = 0;
      const std::vector<T> moved = quantised(values, 3, Precision::of_bits(bits), &error);
      EXPECT_LE(error, step / 2 + rounding<T>(std::max(std::fabs(from), std::fabs(to))));
      if (error == 0) continue;
      for (std::size_t i = 0; i < moved.size(); ++i) {
        const double origin = static_cast<double>(least[i % 3]);
        const double k = std::round((static_cast<double>(moved[i]) - origin) / step);
        ASSERT_GE(k, 0);
        ASSERT_LE(k, steps);
        const double place = origin + k * step;
        const T expected =
            static_cast<T>(std::is_floating_point_v<T> ? place : std::floor(place + .5));
        ASSERT_EQ(moved[i], expected) << bits << " bits";
      }
    }
}

TYPED_TEST(QuantiseTyped, NeverOffByMoreThanTheErrorAskedFor) {
  using T = TypeParam;
  std::mt19937 random(2);
  for (double error = 3e-9; error < 50; error *= 3)
    for (const double from : {0., sizeof(T) > 2 ? 1e5 : 0.}) {
      const std::vector<T> values = random_values<T>(999, from, from + 100, random);
      double found = 0;
      quantised(values, 3, Precision::of_error(error), &found);
      EXPECT_LE(found, error);
    }
}

TEST(Quantise, AnErrorIsUsedWhereTheTypeAllowsIt) {
  std::mt19937 random(3);
  const std::vector<float> values = random_values<float>(3000, 1000, 1001, random);
  double found = 0;
  // A float is 6e-5 apart from the next one there.
  quantised(values, 3, Precision::of_error(1e-3), &found);
  EXPECT_GT(found, 8e-4);
  quantised(values, 3, Precision::of_error(2e-5), &found);
  EXPECT_EQ(found, 0);
}

TEST(Quantise, StepsOfDecimalsGiveDecimals) {
  const std::vector<double> values = {.0712, -.0688, 1234.5678, 0, 99.995001},
                            hundredths = {.07, -.07, 1234.57, 0, 100.};
  EXPECT_EQ(quantised(values, 1, Precision::of_step(.01)), hundredths);
  const std::vector<double> of_three = {.06, -.06, 1234.56, 0, 99.99};
  EXPECT_EQ(quantised(values, 1, Precision::of_step(.03)), of_three);
  const std::vector<double> thirds = {0, 0, 3704. / 3, 0, 100.};
  EXPECT_EQ(quantised(values, 1, Precision::of_step(1. / 3)), thirds);
}

TEST(Quantise, HalvesGoDown) {
  const std::vector<float> values = {-1.5, -.5, .5, 1.5, 2.5, 2.75}, moved = {-2, -1, 0, 1, 2, 3};
  EXPECT_EQ(quantised(values, 1, Precision::of_step(1)), moved);
  // The last point is the last number of the type.
  const std::vector<std::int16_t> integers = {-3, -1, 1, 3, 32767, -32768},
                                  even = {-4, -2, 0, 2, 32767, -32768};
  EXPECT_EQ(quantised(integers, 1, Precision::of_step(2)), even);
}

TEST(Quantise, IntegersStayInTheirType) {
  const std::vector<std::uint8_t> values = {0, 3, 250, 255};
  double error = 0;
  quantised(values, 1, Precision::of_step(8), &error);
  EXPECT_LE(error, 4);
  quantised(values, 1, Precision::of_error(.5), &error);
  EXPECT_EQ(error, 0);
  quantised(values, 1, Precision::of_step(1000), &error);
  EXPECT_LE(error, 255);
}

TEST(Quantise, TilesOnOneGridShareTheirBorder) {
  // A terrain of two tiles, whose least and greatest places differ.
  std::mt19937 random(4);
  for (const Precision& precision :
       {Precision::of_step(.37), Precision::on_grid({250001.3, 5.1e6, -17}, .37),
        Precision::on_grid({1e-3}, .01)}) {
    std::vector<float> border, west, east;
    for (int i = 0; i < 400; ++i)
      for (const double x :
           {250300., 5e6 + 30. * i, std::uniform_real_distribution<double>(0, 2500)(random)})
        border.push_back(static_cast<float>(x));
    border[4] = -0.f;
    west = random_values<float>(900, 2e5, 5e6, random);
    east = random_values<float>(60, -3, 9e6, random);
    west.insert(west.end(), border.begin(), border.end());
    east.insert(east.end(), border.begin(), border.end());
    west = quantised(west, 3, precision);
    east = quantised(east, 3, precision);
    EXPECT_EQ(std::memcmp(west.data() + 900, east.data() + 60, border.size() * sizeof(float)), 0);
  }
}

TEST(Quantise, WhatIsOnTheGridStaysBitForBit) {
  const std::vector<float> values = {-0.f, .5f, -2.f, 0.f};
  const auto out = quantise(view_of(values, 2), Precision::of_step(.25));
  ASSERT_TRUE(out.ok());
  EXPECT_EQ(out->plan.error, 0);
  EXPECT_TRUE(out->values.empty());
}

TEST(Quantise, IntegersAreThoseOfTheValues) {
  std::mt19937 random(13);
  std::vector<float> values;
  for (int i = 0; i < 3000; ++i)
    values.push_back(static_cast<float>(random() % 100000) / 7 - (i % 3 == 1 ? 9000.f : 0.f));
  // A component on a coarser grid, and one of few numbers.
  for (std::size_t i = 0; i < values.size(); i += 3) {
    values[i] = std::floor(values[i] / 64) * 32;
    values[i + 2] = std::floor(values[i + 2] / 1000) * 1000 / 3;
  }
  for (const Precision& precision :
       {Precision::of_bits(5), Precision::of_bits(11), Precision::of_bits(16),
        Precision::of_step(.3), Precision::of_error(4), Precision::on_grid({1.5}, 2)}) {
    const auto out = quantise(view_of(values, 3), precision);
    ASSERT_TRUE(out.ok());
    ASSERT_TRUE(out->plan.integers_of.has_value());
    const std::vector<float> moved = values_of(*out, values);
    const NumberedValues of_integers =
        put_integers(out->values, Scalar::float32, out->plan.systems);
    const NumberedValues of_values =
        put_into_systems(std::as_bytes(std::span(moved)), Scalar::float32, out->plan.systems, 5);
    EXPECT_EQ(of_integers.bytes, of_values.bytes);
    EXPECT_EQ(of_integers.narrow, of_values.narrow);
    EXPECT_EQ(of_integers.numbers.systems, of_values.numbers.systems);
  }
}

TEST(Quantise, ValuesStayWhereIntegersDoNotSayAll) {
  const std::vector<std::vector<float>> all = {
      {-0.f, .1f, 2, 0},        // the sign of zero
      {1e8f, 1e8f + 8, .1f, 0}  // steps that the type rounds to each other
  };
  for (const std::vector<float>& values : all) {
    const auto out = quantise(view_of(values, 1), Precision::of_step(.25));
    ASSERT_TRUE(out.ok());
    EXPECT_FALSE(out->plan.integers_of.has_value());
    std::vector<float> moved = values_of(*out, values);
    EXPECT_EQ(std::signbit(moved[0]), std::signbit(values[0]));
  }
}

TEST(Quantise, ACoarserGridIsKept) {
  std::mt19937 random(9);
  std::vector<float> terrain;
  std::vector<double> printed;
  for (int i = 0; i < 2000; ++i) {
    for (const unsigned unit : {30u, 30u, 1u})
      terrain.push_back(5e5f + static_cast<float>(unit * (random() % 900)));
    // Steps of 1 / 783, with six decimals.
    for (int c = 0; c < 3; ++c)
      printed.push_back(std::floor(1e6 * static_cast<double>(random() % 783) / 783 + .5) / 1e6);
  }
  double error = 0;
  // The longest side has 26970 metres, or steps of 1.6.
  auto out = quantise(view_of(terrain, 3), Precision::of_bits(14));
  ASSERT_TRUE(out.ok());
  ASSERT_EQ(out->plan.systems.size(), 3u);
  EXPECT_EQ(spacing(out->plan.systems[0]), 30);
  std::vector<float> moved = values_of(*out, terrain);
  for (std::size_t i = 0; i < moved.size(); ++i)
    if (i % 3 != 2) {
      EXPECT_EQ(moved[i], terrain[i]);
    }
  EXPECT_EQ(quantised(terrain, 3, Precision::of_error(.4), &error), terrain);
  EXPECT_EQ(error, 0);

  // 511 steps are longer than theirs, 1023 and 2047 are not.
  for (const int bits : {9, 10, 11}) {
    quantised(printed, 3, Precision::of_bits(bits), &error);
    EXPECT_EQ(error<1e-6, bits> 9);
  }
  // Nobody else would know these steps.
  quantised(printed, 3, Precision::of_step(1. / 512), &error);
  EXPECT_GT(error, 1e-4);
}

TEST(Quantise, FewValues) {
  for (const Precision& precision :
       {Precision::of_bits(1), Precision::of_bits(30), Precision::of_step(1e-30),
        Precision::of_error(1e-30), Precision::of_error(1e300), Precision::on_grid({7}, 3)}) {
    EXPECT_EQ(quantised(std::vector<float>(), 3, precision).size(), 0u);
    if (precision.kind == Precision::Kind::grid || precision.kind == Precision::Kind::step)
      continue;
    const std::vector<float> one = {1, 2, 3}, same = {5e-39f, 5e-39f, 5e-39f};
    quantised(one, 3, precision);
    quantised(same, 1, precision);
  }
  const std::vector<double> constant(99, .1);
  EXPECT_EQ(quantised(constant, 3, Precision::of_bits(8)), constant);
}

TEST(Quantise, ExtremeRanges) {
  constexpr float tiny = std::numeric_limits<float>::denorm_min(),
                  huge = std::numeric_limits<float>::max();
  for (int bits = min_bits; bits <= max_bits; ++bits) {
    double error = 0;
    quantised(std::vector<float>{-huge, huge, 1, 0}, 1, Precision::of_bits(bits), &error);
    EXPECT_LE(error, 1.0001 * double(huge) / (std::ldexp(1., bits) - 1));
    quantised(std::vector<float>{0, tiny, 3 * tiny, 7 * tiny}, 1, Precision::of_bits(bits), &error);
    EXPECT_LE(error, 4 * double(tiny));
    quantised(std::vector<double>{0, 5e-324, 5e-323}, 1, Precision::of_bits(bits));
    quantised(std::vector<double>{0, 1.7e308, 1, -1e300}, 1, Precision::of_bits(bits), &error);
    EXPECT_LE(error, .87e308 / (std::ldexp(1., bits) - 1));
  }
  double error = 0;
  quantised(std::vector<float>{huge, -huge}, 1, Precision::of_step(3e38), &error);
  EXPECT_LE(error, 1.5e38);
  using Limits = std::numeric_limits<std::int64_t>;
  quantised(std::vector<std::int64_t>{Limits::min(), Limits::max(), 0}, 1, Precision::of_bits(30),
            &error);
  EXPECT_LE(error, 1e10);
  const std::vector<double> far = {-1.7e308, 1.7e308};
  EXPECT_EQ(quantise(view_of(far, 1), Precision::of_bits(8)).error().code, ErrorCode::not_on_grid);
}

TEST(Quantise, NotOnAnyGrid) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                  inf = std::numeric_limits<float>::infinity();
  for (const float wrong : {nan, inf, -inf}) {
    const std::vector<float> values = {0, 1, 2, 3, 4, wrong, wrong, 7, 8};
    for (const Precision& precision : {Precision::of_bits(8), Precision::of_step(1),
                                       Precision::of_error(1), Precision::on_grid({0}, 1)}) {
      const auto out = quantise(view_of(values, 3), precision);
      ASSERT_FALSE(out.ok());
      EXPECT_EQ(out.error().code, ErrorCode::not_on_grid);
      EXPECT_EQ(out.error().place, Place::vertex);
      EXPECT_EQ(out.error().at, 1u);
      EXPECT_NE(out.error().what.find("position"), std::string::npos);
    }
    const auto exact = quantise(view_of(values, 3), Precision::lossless());
    ASSERT_TRUE(exact.ok());
    EXPECT_TRUE(exact->plan.systems.empty());
  }
  const std::vector<float> values = {0, 1, 1e9f, 0};
  for (const Precision& precision : {Precision::of_step(1e-12), Precision::on_grid({5}, 1e-12)}) {
    const auto out = quantise(view_of(values, 2), precision);
    ASSERT_FALSE(out.ok());
    EXPECT_EQ(out.error().code, ErrorCode::not_on_grid);
  }
  const auto out = quantise(view_of(values, 2), Precision::on_grid({1, 2, 3}, 1));
  ASSERT_FALSE(out.ok());
  EXPECT_EQ(out.error().code, ErrorCode::bad_option);
}

TEST(Quantise, FaultsOfPrecisions) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const Precision& precision :
       {Precision::of_bits(0), Precision::of_bits(31), Precision::of_step(0),
        Precision::of_step(-1), Precision::of_step(nan), Precision::of_error(0),
        Precision::of_error(inf), Precision::on_grid({0}, 0), Precision::on_grid({0, nan}, 1),
        Precision::on_grid({inf}, 1)})
    EXPECT_NE(precision_fault(precision), "");
  for (const Precision& precision : {Precision::lossless(), Precision::of_bits(1),
                                     Precision::of_bits(30), Precision::of_step(1e-300)})
    EXPECT_EQ(precision_fault(precision), "");
}

TEST(Quantise, OutliersThatWasteBits) {
  std::mt19937 random(6);
  std::vector<float> values = random_values<float>(3000, 0, 1, random);
  const auto outliers = [&] {
    return quantise(view_of(values, 3), Precision::of_bits(12))->outliers;
  };
  EXPECT_FALSE(outliers());
  values[3 * 417 + 1] = 3.5f;
  EXPECT_FALSE(outliers());
  values[3 * 417 + 1] = 40;
  ASSERT_TRUE(outliers());
  EXPECT_EQ(outliers()->farthest, 417u);
  EXPECT_EQ(outliers()->bits, 7);
  // Two far away are more than a thousandth.
  values[3 * 500 + 1] = 40;
  EXPECT_FALSE(outliers());
}

RC_GTEST_PROP(Quantise, TheErrorStatedIsTheErrorFound, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const auto pick = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  std::vector<float> values(3 * (1 + pick(40)));
  for (float& x : values) do {
      const auto word = static_cast<std::uint32_t>(random());
      std::memcpy(&x, &word, sizeof x);
    } while (!std::isfinite(x));
  const int bits = min_bits + static_cast<int>(pick(max_bits));
  double error = 0, longest = 0, largest = 0;
  quantised(values, 3, Precision::of_bits(bits), &error);
  for (std::size_t i = 0; i < values.size(); ++i) {
    largest = std::max(largest, std::fabs(double(values[i])));
    for (std::size_t j = i % 3; j < i; j += 3)
      longest = std::max(longest, difference(values[i], values[j]));
  }
  const double step = longest / (std::ldexp(1., bits) - 1);
  const bool in_range = largest + step / 2 <= double(std::numeric_limits<float>::max());
  const double rounded =
      2 *
      rounding<float>(std::min(largest + step / 2, double(std::numeric_limits<float>::max()) / 2));
  RC_ASSERT(error <= (in_range ? step / 2 : step) + rounded);
}

}  // namespace
}  // namespace clers::internal

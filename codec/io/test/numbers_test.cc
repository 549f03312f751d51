// The C library's strtof, strtod and printf say what is right.
#include "codec/io/numbers.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>

#include "codec/io/test/meshes.h"

namespace clers::io {
namespace {

Attribute read_numbers(const std::string& file) {
  Text text(file);
  Numbers numbers;
  while (!text.at_end())
    if (!numbers.read(text)) {
      ADD_FAILURE() << "no number in " << file;
      break;
    }
  const auto components = static_cast<unsigned>(numbers.size());
  return numbers.take("numbers", Domain::vertex, components);
}

std::string printed(int digits, double value, char style = 'g') {
  char text[400];
  const std::string format = std::string("%.*") + style;
  std::snprintf(text, sizeof text, format.c_str(), digits, value);
  return text;
}

std::vector<float> some_floats() {
  std::vector<float> values;
  for (int k = -149; k < 128; ++k)
    for (const float step : {-1.f, 0.f, 1.f}) {
      const float power = std::ldexp(1.f, k);
      values.push_back(std::nextafter(power, power + step * power));
    }
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (std::isfinite(value)) values.push_back(value);
    values.push_back(std::ldexp(static_cast<float>(random() >> 8), -20));
  }
  values.push_back(-0.f);
  return values;
}

TEST(Numbers, WhatWasPrintedFromFloat32IsFloat32) {
  for (const float value : some_floats()) {
    for (int digits = 1; digits <= 20; ++digits) {
      const std::string text = printed(digits, static_cast<double>(value));
      if (std::isinf(std::strtof(text.c_str(), nullptr))) continue;  // 3.403e38
      const Attribute read = read_numbers(text);
      ASSERT_EQ(read.scalar, Scalar::float32) << text;
      const float got = values_of<float>(read)[0];
      ASSERT_EQ(std::bit_cast<std::uint32_t>(got),
                std::bit_cast<std::uint32_t>(std::strtof(text.c_str(), nullptr)))
          << text;
      if (digits >= 9) {
        ASSERT_EQ(got, value) << text;
      }
    }
  }
}

TEST(Numbers, FixedPointOfFloat32IsFloat32) {
  std::mt19937 random(2);
  for (int i = 0; i < 20000; ++i) {
    const float value = std::ldexp(static_cast<float>(random() >> 8), -static_cast<int>(i % 24));
    const std::string text = printed(6, static_cast<double>(value), 'f');
    const Attribute read = read_numbers(text);
    ASSERT_EQ(read.scalar, Scalar::float32) << text;
    ASSERT_EQ(values_of<float>(read)[0], std::strtof(text.c_str(), nullptr)) << text;
  }
}

TEST(Numbers, OneThatIsNoFloat32MakesAllFloat64) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value) || value == static_cast<double>(static_cast<float>(value))) continue;
    const Attribute read = read_numbers("0.1 " + printed(17, value));
    ASSERT_EQ(read.scalar, Scalar::float64);
    ASSERT_EQ(values_of<double>(read), (std::vector{0.1, value}));
  }
  EXPECT_EQ(read_numbers("36.99219894409179").scalar, Scalar::float32);
  EXPECT_EQ(read_numbers("16777217").scalar, Scalar::float64);
  EXPECT_EQ(read_numbers("16777216").scalar, Scalar::float32);
  EXPECT_EQ(read_numbers("123.456789").scalar, Scalar::float64);
  EXPECT_EQ(read_numbers("123.456787").scalar, Scalar::float32);
  EXPECT_EQ(read_numbers("1e39").scalar, Scalar::float64);
  EXPECT_EQ(read_numbers("1e-50").scalar, Scalar::float64);
}

// Rounded to float64 this lies in the middle between two float32, but is not there.
TEST(Numbers, AreRoundedOnce) {
  const char* text = "7038531e-32";
  const float once = std::strtof(text, nullptr);
  ASSERT_NE(once, static_cast<float>(std::strtod(text, nullptr)));
  EXPECT_EQ(values_of<float>(read_numbers(text)), std::vector{once});
}

TEST(Numbers, WhatIsPrintedReadsBack) {
  std::mt19937_64 random(4);
  std::vector<double> values{0.1, 1, 1 / 3.0, -0.0, 1e300, 5e-324, 0.1f, 16777217};
  for (int i = 0; i < 50000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (std::isfinite(value)) values.push_back(value);
    // Few digits, as people write them.
    values.push_back(static_cast<double>(random() % 1000000) / std::pow(10, random() % 9));
    // Beside a float32.
    const auto narrow = static_cast<double>(std::ldexp(static_cast<float>(random() >> 40), -18));
    values.push_back(std::nextafter(narrow, i % 2 ? 1e300 : -1e300));
  }
  for (const double value : values) {
    Output out;
    print_untyped(out, attribute<double>("", Domain::vertex, 1, {value}), 0);
    const std::string text = text_of(out.take());
    const Attribute read = read_numbers(text);
    const double got = read.scalar == Scalar::float32
                           ? static_cast<double>(values_of<float>(read)[0])
                           : values_of<double>(read)[0];
    ASSERT_EQ(std::bit_cast<std::uint64_t>(got), std::bit_cast<std::uint64_t>(value)) << text;
  }
  for (const float value : some_floats()) {
    Output out;
    print_untyped(out, attribute<float>("", Domain::vertex, 1, {value}), 0);
    const std::string text = text_of(out.take());
    const Attribute read = read_numbers(text);
    ASSERT_EQ(read.scalar, Scalar::float32) << text;
    ASSERT_EQ(std::bit_cast<std::uint32_t>(values_of<float>(read)[0]),
              std::bit_cast<std::uint32_t>(value))
        << text;
  }
}

TEST(Numbers, OutOfRangeIsZeroOrNoNumber) {
  const auto number = [](std::string_view file) {
    Text text(file);
    float value = 42;
    return text.number(value) ? std::optional(value) : std::nullopt;
  };
  for (const char* tiny :
       {"1e-46", "1e-400", "0.00000000000000000000000000000000000000000000000001",
        "1000e-99999999999999999999", "0.0001e-44", "10e-50"}) {
    ASSERT_TRUE(number(tiny)) << tiny;
    EXPECT_EQ(*number(tiny), 0) << tiny;
    EXPECT_FALSE(std::signbit(*number(tiny)));
    EXPECT_TRUE(std::signbit(*number("-" + std::string(tiny)))) << tiny;
  }
  EXPECT_EQ(number("7.1e-46"), std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(number("0e99999"), 0);
  EXPECT_EQ(number("+1.e0"), 1);
  EXPECT_EQ(number(" .5\t"), .5);
  for (const char* none : {"1e39", "1e400", "1e99999999999999999999", "0.001e50", "", "-", "+", ".",
                           "+-1", "++1", "1,5", "1.2.3", "0x1p3", "1e", "e5", "1e+", "one"})
    EXPECT_FALSE(number(none)) << none;
}

TEST(Numbers, CountsNaNsThatTextCannotTell) {
  const auto nan = [](std::uint32_t bits) { return std::bit_cast<float>(bits); };
  EXPECT_EQ(count_lost_nans(attribute<float>("", Domain::vertex, 1,
                                             {nan(0x7fc00000), nan(0xffc00000), 1, nan(0x7fc00001),
                                              nan(0x7f800001), nan(0xffffffff)})),
            3u);
  EXPECT_EQ(
      count_lost_nans(attribute<double>(
          "", Domain::vertex, 1, {std::bit_cast<double>(0x7ff8000000000001u), NAN, INFINITY})),
      1u);
}

}  // namespace
}  // namespace clers::io

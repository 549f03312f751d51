// Numbers come back bit for bit from whatever system they are put into, and no bytes do harm.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "codec/base/portable.h"
#include "codec/numbers/float_directions.h"
#include "codec/numbers/number_decoder.h"
#include "codec/numbers/number_encoder.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

using corpus::Random;

unsigned long_runs() {
  const char* n = std::getenv("CLERS_LONG");
  return n ? static_cast<unsigned>(std::strtoul(n, nullptr, 10)) : 1;
}

template <class T>
Bytes bytes_of(const std::vector<T>& numbers) {
  Bytes bytes(numbers.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

Expected<Done> values_of(const NumberReader& reader, const NumberedValues& coded,
                         std::span<std::byte> values) {
  return coded.numbers.narrow() ? reader.to_values(std::span(coded.narrow), values)
                                : reader.to_values(std::span(coded.wide), values);
}

template <class Int>
void expect_in_range(const Numbers& numbers, const std::vector<Int>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Axis& axis = numbers.axes[i % numbers.axes.size()];
    ASSERT_GE(rows[i], 0);
    ASSERT_LE(static_cast<std::uint64_t>(rows[i]), axis.top);
    const auto k = static_cast<std::uint64_t>(rows[i]);
    ASSERT_TRUE(axis.palette.empty() ||
                std::binary_search(axis.palette.begin(), axis.palette.end(), k));
  }
}

/// Decodes what was coded, and compares.
void expect_back(const NumberedValues& coded, const Bytes& values, Scalar scalar,
                 std::size_t components) {
  const std::size_t count = values.size() / (components * size_of(scalar));
  ByteReader in(coded.bytes, 0);
  const auto reader = NumberReader::read(in, scalar, components, count);
  ASSERT_TRUE(reader.ok()) << describe(reader.error());
  EXPECT_EQ(in.left(), 0u);
  EXPECT_EQ(reader->numbers().systems, coded.numbers.systems);
  const std::size_t axes = coded.numbers.axes.size();  // two of directions
  ASSERT_EQ(reader->numbers().axes.size(), axes);
  for (std::size_t c = 0; c < axes; ++c) {
    EXPECT_EQ(reader->numbers().axes[c].top, coded.numbers.axes[c].top);
    EXPECT_EQ(reader->numbers().axes[c].scale, coded.numbers.axes[c].scale);
    EXPECT_EQ(reader->numbers().axes[c].palette, coded.numbers.axes[c].palette);
  }
  EXPECT_EQ((coded.numbers.narrow() ? coded.narrow.size() : coded.wide.size()), axes * count);
  expect_in_range(coded.numbers, coded.narrow);
  expect_in_range(coded.numbers, coded.wide);
  Bytes back(values.size());
  const auto done = values_of(*reader, coded, back);
  ASSERT_TRUE(done.ok()) << describe(done.error());
  ASSERT_EQ(back == values, true) << describe(coded.numbers, 0);
}

template <class T>
NumberedValues round_trip(const std::vector<T>& numbers, std::size_t components = 1,
                          int level = 5) {
  const Bytes values = bytes_of(numbers);
  NumberedValues coded = number_values(values, scalar_of<T>(), components, level);
  expect_back(coded, values, scalar_of<T>(), components);
  return coded;
}

template <class T>
std::string system_of(const std::vector<T>& numbers) {
  const NumberedValues coded = round_trip(numbers);
  return coded.numbers.systems.empty() ? "" : describe(coded.numbers, 0);
}

template <class T>
void random_numbers_survive() {
  for (unsigned seed = 0; seed < 40 * long_runs(); ++seed) {
    SCOPED_TRACE(std::string(name(scalar_of<T>())) + ", seed " + std::to_string(seed));
    Random random(seed);
    const std::size_t components = 1 + seed % 4;
    std::vector<T> numbers(components * random.below(seed % 7 == 0 ? 3 : 300));
    const unsigned kept = 1 + random.below(64);
    for (T& x : numbers) {
      const std::uint64_t bits = random.next() >> (64 - kept) << random.below(65 - kept);
      std::memcpy(&x, &bits, sizeof x);
    }
    for (const int level : {1, 5}) round_trip(numbers, components, level);
  }
}

TEST(Numbers, RandomOnesOfAllTypesSurvive) {
  for (unsigned s = 0; s < scalar_count; ++s)
    with_type(static_cast<Scalar>(s), [](auto type) { random_numbers_survive<decltype(type)>(); });
}

TEST(Numbers, FewSurvive) {
  for (unsigned s = 0; s < scalar_count; ++s)
    with_type(static_cast<Scalar>(s), [](auto type) {
      using T = decltype(type);
      for (const std::size_t components : {1u, 3u, 255u}) {
        round_trip(std::vector<T>(), components);
        round_trip(std::vector<T>(components), components);
        round_trip(std::vector<T>(7 * components, T(42)), components);
        round_trip(std::vector<T>(components, std::numeric_limits<T>::max()), components);
        round_trip(std::vector<T>(components, std::numeric_limits<T>::lowest()), components);
      }
      round_trip(std::vector<T>{std::numeric_limits<T>::max(), std::numeric_limits<T>::lowest()});
    });
}

/// The float with the bits of a half.
float half(std::uint32_t bits) {
  const std::uint32_t sign = (bits & 0x8000u) << 16, exponent = bits >> 10 & 31, m = bits & 1023;
  if (exponent == 31) return std::bit_cast<float>(sign | 0x7f800000u | m << 13);
  const float v = exponent == 0 ? std::ldexp(float(m), -24)
                                : std::ldexp(float(1024 + m), static_cast<int>(exponent) - 25);
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(v) | sign);
}

TEST(Numbers, AllHalfFloatsSurvive) {
  std::vector<float> halves;
  for (std::uint32_t bits = 0; bits < 0x10000; ++bits) halves.push_back(half(bits));
  round_trip(halves);
  Random(1).shuffle(halves);
  round_trip(halves);
}

TEST(Numbers, HalfFloatsHaveElevenBits) {
  Random random(2);
  std::vector<float> halves;
  for (int i = 0; i < 3000; ++i) halves.push_back(half(0x3000 + random.below(0xc00)));
  EXPECT_EQ(system_of(halves), "float, 11 bits");
}

/// Systems of every kind, for float32.
std::vector<NumberSystem> some_systems() {
  std::vector<NumberSystem> systems(1);
  const auto add = [&](NumberMap map, const auto& change) {
    NumberSystem s;
    s.map = map;
    change(s);
    systems.push_back(s);
  };
  for (const std::uint64_t divisor : {1ull, 10ull, 1000000ull, 7846ull, 1ull << 20, 1ull << 53})
    add(NumberMap::quotient, [&](NumberSystem& s) {
      s.divisor = divisor;
      s.step = 1 + divisor % 3;
      s.ulps = divisor == 10 ? 3 : divisor == 1000000 ? 255 : 0;
      s.signed_zero = divisor == 7846;
    });
  add(NumberMap::affine, [](NumberSystem& s) { s.origin = 5e5, s.length = .1; });
  add(NumberMap::affine, [](NumberSystem& s) { s.length = 0x1p-140, s.ulps = 2; });
  add(NumberMap::affine, [](NumberSystem& s) { s.origin = 3, s.length = .1, s.single = true; });
  for (const int exponent : {-22, -6, 0, 3})
    add(NumberMap::digits, [&](NumberSystem& s) {
      s.precision = static_cast<std::uint8_t>(exponent == 0 ? 15 : 6);
      s.exponent = static_cast<std::int16_t>(exponent);
    });
  for (const int exponent : {-149, -24, 0, 104})
    add(NumberMap::binary, [&](NumberSystem& s) {
      s.precision = static_cast<std::uint8_t>(exponent == 0 ? 11 : 24);
      s.exponent = static_cast<std::int16_t>(exponent);
    });
  for (const bool decimals : {false, true})
    add(NumberMap::printed, [&](NumberSystem& s) {
      s.divisor = 7846;
      s.precision = 6;
      s.decimals = decimals;
      s.signed_zero = true;
    });
  return systems;
}

TEST(Numbers, FloatsSurviveInAnySystem) {
  const auto systems = some_systems();
  // With CLERS_LONG=1000 10^8 numbers.
  const unsigned rounds = std::max(1u, long_runs() / 10);
  for (unsigned round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < systems.size(); ++i) {
      SCOPED_TRACE("system " + std::to_string(i) + ", round " + std::to_string(round));
      Random random(1000 * round + i);
      std::vector<float> numbers(long_runs() > 1 ? 60000 : 3000);
      for (float& x : numbers) {
        auto word = static_cast<std::uint32_t>(random.next());
        // Most of them near where the system has numbers.
        if (random.chance(70)) word = (word & 0x80ffffffu) | (0x3a + random.below(10)) << 24;
        if (random.chance(30)) word = std::bit_cast<std::uint32_t>(std::floor(float(word >> 22)));
        if (random.chance(5)) word &= 0x80000000u;
        x = std::bit_cast<float>(word);
      }
      const Bytes values = bytes_of(numbers);
      for (const int level : {1, 5})
        expect_back(put_into_systems(values, Scalar::float32, {systems[i]}, level), values,
                    Scalar::float32, 1);
    }
}

TEST(Numbers, SpecialOnesAreStrays) {
  std::vector<double> numbers;
  for (int i = 0; i < 1000; ++i) numbers.push_back(i * .25);
  using Limits = std::numeric_limits<double>;
  for (const double x : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(),
                         std::bit_cast<double>(0x7ff0000000000001u), -0., Limits::denorm_min(),
                         -Limits::min(), Limits::max()})
    numbers.insert(numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 3), x);
  const NumberedValues coded = round_trip(numbers);
  EXPECT_EQ(describe(coded.numbers, 0), "steps of 0.25");
  EXPECT_EQ(coded.numbers.axes[0].top, 999u);
  EXPECT_EQ(system_of(std::vector<float>{0.f, -0.f}), "words");
}

TEST(Numbers, MinusZerosAreCheap) {
  Random random(3);
  std::vector<float> numbers;
  for (int i = 0; i < 3000; ++i)
    numbers.push_back(random.chance(30) ? random.chance(50) ? -0.f : 0.f
                                        : float(double(random.below(20000)) / 1000));
  const NumberedValues coded = round_trip(numbers);
  EXPECT_EQ(describe(coded.numbers, 0), "3 decimals");
  EXPECT_LT(coded.bytes.size(), 3000u * 30 / 100 / 8 + 60);
}

TEST(Numbers, DecimalsAreFound) {
  Random random(4);
  std::vector<float> floats;
  std::vector<double> doubles, digits;
  for (int i = 0; i < 3000; ++i) {
    const double n = double(random.below(2000000)) - 1e6;
    floats.push_back(float(n / 1e3));
    doubles.push_back((n * 1e6 + double(random.below(1000000))) / 1e12);
    digits.push_back((1e5 + double(random.below(900000))) / tens[5 + random.below(3)]);
  }
  EXPECT_EQ(system_of(floats), "3 decimals");
  EXPECT_EQ(system_of(doubles), "12 decimals");
  EXPECT_EQ(system_of(digits), "6 digits");
}

TEST(Numbers, NearDecimalsAreKeptApart) {
  Random random(5);
  std::vector<float> numbers;
  for (int i = 0; i < 4000; ++i) {
    const float x = float((double(random.below(200000)) - 1e5) / 1e3);
    const float beside = std::nextafterf(x, random.chance(50) ? 1e9f : -1e9f);
    numbers.push_back(random.chance(2) ? beside : x);
  }
  EXPECT_EQ(system_of(numbers), "3 decimals +- 1 ulp");
  for (float& x : numbers) x = std::nextafterf(x, 1e9f);
  EXPECT_EQ(system_of(numbers), "3 decimals +- 2 ulps");
}

TEST(Numbers, LargeCoordinatesOnAGridAreFound) {
  Random random(6);
  std::vector<float> metres;
  std::vector<double> decimetres;
  for (int i = 0; i < 3000; ++i) {
    metres.push_back(5012345.f + 30.f * float(random.below(400)));
    decimetres.push_back((53123456 + 3 * double(random.below(100000))) / 10);
  }
  EXPECT_EQ(system_of(metres), "steps of 30");
  EXPECT_EQ(system_of(decimetres), "steps of 0.3");
}

TEST(Numbers, PrintedStepsAreFound) {
  const DoublePrecision doubles;
  for (const char* format : {"%.6g", "%.6f"}) {
    Random random(14);
    std::vector<double> numbers;
    for (int i = 0; i < 3000; ++i) {
      char text[40];
      std::snprintf(text, sizeof text, format, (double(random.below(9000)) - 1200.5) / 7846);
      numbers.push_back(std::strtod(text, nullptr));
    }
    const NumberedValues coded = round_trip(numbers);
    EXPECT_EQ(coded.numbers.systems[0].map, NumberMap::printed);
    EXPECT_EQ(coded.numbers.systems[0].divisor, 2u * 7846);
    EXPECT_LT(coded.numbers.axes[0].top, 9000u);
    EXPECT_LT(coded.bytes.size(), 40u);
  }
}

TEST(Numbers, StepsWithNoiseAreFound) {
  const DoublePrecision doubles;
  Random random(15);
  std::vector<float> numbers;
  for (int i = 0; i < 3000; ++i) {
    const float x = static_cast<float>(.0371 * double(random.below(20000)) - 300);
    numbers.push_back(std::nextafterf(x, random.chance(50) ? 1e9f : -1e9f));
  }
  const NumberedValues coded = round_trip(numbers);
  EXPECT_EQ(coded.numbers.axes[0].top / 10000, 1u);
  EXPECT_LT(coded.bytes.size(), 3000u * 3 / 8);
}

/// As Draco makes floats of integers of 0 .. 2^bits - 1.
std::vector<float> dequantised(float least, float range, unsigned bits, unsigned seed) {
  Random random(seed);
  const std::uint32_t top = (1u << bits) - 1;
  const float length = range / static_cast<float>(top);
  std::vector<float> numbers = {least};
  for (int i = 0; i < 3000; ++i) {
    volatile float product = static_cast<float>(random.below(top + 1)) * length;
    numbers.push_back(product + least);
  }
  std::swap(numbers[0], numbers[1000]);
  return numbers;
}

TEST(Numbers, StepsComputedInFloatsLeaveNothingOpen) {
  unsigned seed = 0;
  for (const float least : {0.f, -1.f, -0.37f, 1234.5f, -1e-5f})
    for (const float range : {1.f, 1.718f, 3e-4f, 5e4f})
      for (const unsigned bits : {8u, 11u, 14u, 16u}) {
        // Steps of some ulps of the numbers are no steps any more.
        if (std::fabs(least) * 0x1p-18f > range / static_cast<float>(1u << bits)) continue;
        SCOPED_TRACE(std::to_string(least) + " " + std::to_string(range) + " " +
                     std::to_string(bits));
        const NumberedValues coded = round_trip(dequantised(least, range, bits, ++seed));
        const NumberSystem& s = coded.numbers.systems[0];
        EXPECT_EQ(s.ulps, 0u) << describe(coded.numbers, 0);
        EXPECT_LE(coded.numbers.axes[0].top, (1u << bits) - 1);
        EXPECT_LT(coded.bytes.size(), 40u);  // no strays
      }
}

/// What Draco's OctahedronToolBox makes of the integers of a direction, by floats.
std::array<float, 3> by_draco(std::int32_t s, std::int32_t t, unsigned bits) {
  const std::int32_t top = (1 << bits) - 2;
  const float scale = 2.f / static_cast<float>(top);
  float y = static_cast<float>(s) * scale - 1.f, z = static_cast<float>(t) * scale - 1.f;
  const float x = 1.f - std::fabs(y) - std::fabs(z);
  const float beyond = x < 0 ? -x : 0;
  y += y < 0 ? beyond : -beyond;
  z += z < 0 ? beyond : -beyond;
  const float d = 1.f / std::sqrt(x * x + y * y + z * z);
  return {x * d, y * d, z * d};
}

TEST(Numbers, DirectionsOfDracoAreFoundAndComeBack) {
  for (const unsigned bits : {5u, 8u, 10u, 14u}) {
    const std::int32_t top = (1 << bits) - 2;
    Random random(bits);
    std::vector<float> numbers;
    const auto add = [&](std::int32_t s, std::int32_t t) {
      for (const float x : by_draco(s, t, bits)) numbers.push_back(x);
    };
    const auto any = [&] { return static_cast<std::int32_t>(random.below(unsigned(top) + 1)); };
    const auto inside = [&] { return 1 + any() % (top - 1); };
    for (int i = 0; i < 2000; ++i) add(inside(), inside());
    // Of places that are one on the border, those that its encoder takes; and corners of the
    // diamond.
    const std::int32_t half = top / 2;
    for (int i = 0; i < 50; ++i) {
      const std::int32_t k = any();
      add(half, k), add(k, half), add(top, std::max(k, half)), add(std::max(k, half), top);
      add(0, std::clamp(k, 1, half)), add(std::clamp(k, 1, half), 0);
    }
    add(top, top), add(half, half);
    const Bytes values = bytes_of(numbers);
    EXPECT_EQ(bits_of_float_directions(values), bits);
    const NumberedValues coded =
        put_into_systems(values, Scalar::float32, octahedral_systems(bits, true), 5);
    EXPECT_EQ(describe(coded.numbers, 0),
              "directions of " + std::to_string(bits) + " bits in floats");
    expect_back(coded, values, Scalar::float32, 3);
    numbers[4] = std::nextafter(numbers[4], 2.f);
    EXPECT_FALSE(bits_of_float_directions(bytes_of(numbers)));
  }
}

TEST(Numbers, OnlyFloatsHaveStepsOfFloats) {
  NumberColumn column;
  column.system.map = NumberMap::affine;
  column.system.single = true;
  EXPECT_EQ(fault_of<float>(column), "");
  EXPECT_NE(fault_of<double>(column), "");
  EXPECT_NE(fault_of<Whole>(column), "");
}

/// The numbers of integers 0 .. top in an affine system of a scalar.
template <class T>
std::vector<T> on_grid(double origin, double length, std::int64_t first, std::uint64_t top) {
  Numbers numbers;
  numbers.scalar = scalar_of<T>();
  numbers.systems.resize(1);
  numbers.systems[0].map = NumberMap::affine;
  numbers.systems[0].origin = origin;
  numbers.systems[0].length = length;
  numbers.systems[0].first = first;
  numbers.axes = {{top, 1, {}}};
  Bytes bytes;
  put_plain_numbers(bytes, numbers);
  ByteReader in(bytes, 0);
  const auto reader = NumberReader::read(in, numbers.scalar, 1, top + 1);
  EXPECT_TRUE(reader.ok()) << describe(reader.error());
  std::vector<std::int64_t> rows(top + 1);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<std::int64_t>(i);
  std::vector<T> made(rows.size());
  EXPECT_TRUE(
      reader
          ->to_values(std::span<const std::int64_t>(rows), std::as_writable_bytes(std::span(made)))
          .ok());
  return made;
}

TEST(Numbers, GridsOfCallersHaveTheirPoints) {
  const DoublePrecision doubles;
  const auto points = on_grid<float>(-5e6, .1, 50000000, 1000);
  for (std::size_t i = 0; i < points.size(); ++i) {
    volatile double product = (50000000. + double(i)) * .1;
    volatile double sum = -5e6 + product;
    EXPECT_EQ(points[i], static_cast<float>(sum));
  }
  EXPECT_EQ(on_grid<std::uint8_t>(-2.5, 100, 0, 4),
            (std::vector<std::uint8_t>{0, 98, 198, 255, 255}));
  EXPECT_EQ(on_grid<std::int8_t>(-200, 99.5, 0, 4),
            (std::vector<std::int8_t>{-128, -100, -1, 99, 127}));
  EXPECT_EQ(on_grid<std::int64_t>(-1e19, 5e18, 0, 4)[0], std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(on_grid<std::uint64_t>(0, 1e19, 0, 2)[2], std::numeric_limits<std::uint64_t>::max());
}

TEST(Numbers, FewFarOutDoNotMakeIntegersWide) {
  Random random(16);
  std::vector<float> numbers;
  for (int i = 0; i < 3000; ++i) numbers.push_back(float(double(random.below(100000)) / 1000));
  numbers[100] = 1e9f;
  numbers[2000] = -4e11f;
  const NumberedValues coded = round_trip(numbers);
  EXPECT_TRUE(coded.numbers.narrow());
  EXPECT_EQ(describe(coded.numbers, 0), "3 decimals");
}

TEST(Numbers, IntegersHaveSteps) {
  Random random(7);
  std::vector<std::int16_t> numbers;
  for (int i = 0; i < 3000; ++i)
    numbers.push_back(static_cast<std::int16_t>(-700 + 7 * int(random.below(900))));
  const NumberedValues coded = round_trip(numbers);
  EXPECT_EQ(describe(coded.numbers, 0), "steps of 7");
}

TEST(Numbers, FewFloatsAreAPalette) {
  Random random(8);
  std::vector<float> some, numbers;
  for (int i = 0; i < 40; ++i)
    some.push_back(std::bit_cast<float>(0x3f000000u + random.below(1 << 24)));
  for (int i = 0; i < 4000; ++i) numbers.push_back(some[random.below(40)]);
  const NumberedValues coded = round_trip(numbers);
  EXPECT_EQ(coded.numbers.axes[0].palette.size(), 40u);
  EXPECT_LT(coded.bytes.size(), 40u * 8);
}

/// Half of the numbers are steps, the others few decimals that come again: as strays they would
/// take four bytes each time.
TEST(Numbers, FewThatAreNoStepsAreAPaletteToo) {
  Random random(9);
  std::vector<float> some, numbers;
  for (int i = 0; i < 100; ++i)
    some.push_back(static_cast<float>(random.below(1000000)) / 1000000.f);
  for (int i = 0; i < 4000; ++i)
    numbers.push_back(i % 3 == 0 ? some[random.below(100)] : float(random.below(64)) / 64.f);
  const NumberedValues coded = round_trip(numbers);
  EXPECT_GT(coded.numbers.axes[0].palette.size(), 140u);
  EXPECT_LT(coded.bytes.size(), 164u * 4);
}

TEST(Numbers, ScalesAreLengthsOfSteps) {
  Random random(9);
  std::vector<float> numbers;
  for (int i = 0; i < 3000; ++i) {
    numbers.push_back(30.f * float(random.below(4000)));
    numbers.push_back(float(random.below(100000)) / 4.f);
    numbers.push_back(float(double(random.below(100000)) / 10));
  }
  const NumberedValues coded = round_trip(numbers, 3);
  // 30 : 1/4 : 1/10 are not multiples of the least.
  EXPECT_EQ(coded.numbers.axes[0].scale, 65535u);
  EXPECT_EQ(coded.numbers.axes[1].scale, 546u);
  EXPECT_EQ(coded.numbers.axes[2].scale, 218u);
}

TEST(Numbers, ScalesOfTheGreatestSteps) {
  Numbers numbers;
  numbers.scalar = Scalar::float64;
  numbers.systems.resize(2);
  numbers.axes.resize(2);
  numbers.systems[0].map = NumberMap::binary;
  numbers.systems[0].exponent = 1020;
  numbers.systems[0].step = 1000;
  numbers.systems[1].map = NumberMap::quotient;
  set_scales(numbers);
  EXPECT_EQ(numbers.axes[0].scale, 65535u);
  EXPECT_EQ(numbers.axes[1].scale, 1u);
}

TEST(Numbers, WideDoublesBecomeNarrow) {
  Random random(10);
  std::vector<double> numbers;
  for (int i = 0; i < 3000; ++i) numbers.push_back(double(random.next() >> 11) * 0x1p-53);
  EXPECT_TRUE(round_trip(numbers).numbers.narrow());
}

/// What any compiler and machine must make of the same numbers.
TEST(Numbers, BytesAreTheSameEverywhere) {
  Random random(11);
  const DoublePrecision doubles;
  std::vector<double> numbers;
  std::vector<float> floats;
  for (int i = 0; i < 2000; ++i) {
    const double n = double(random.below(1000000)) - 5e5;
    numbers.insert(numbers.end(), {n / 7846, n / 1e9, n * .1 + 17, std::ldexp(n * n, -70)});
    for (const double x : {n / 1e3, n * 1.1e-6, std::floor(n / 100) * 30 + 5e6, n / (n + 6e5)})
      floats.push_back(std::bit_cast<float>(std::bit_cast<std::uint32_t>(static_cast<float>(x))));
  }
  std::uint64_t hash = 14695981039346656037u;
  const auto add = [&](std::uint64_t byte) { hash = (hash ^ byte) * 1099511628211u; };
  for (const NumberedValues& coded : {round_trip(numbers, 4), round_trip(floats, 4)}) {
    for (const std::byte b : coded.bytes) add(std::to_integer<std::uint64_t>(b));
    for (const std::int32_t k : coded.narrow) add(static_cast<std::uint32_t>(k));
    for (const std::int64_t k : coded.wide) add(static_cast<std::uint64_t>(k));
  }
  EXPECT_EQ(hash, 8420792279100130962u);
}

/// Bytes of many systems, with what they were made of.
struct Case {
  NumberedValues coded;
  std::size_t count, components;
  Scalar scalar;
};
std::vector<Case> some_cases() {
  std::vector<Case> cases;
  Random random(12);
  for (const NumberSystem& s : some_systems()) {
    std::vector<float> numbers(200);
    for (float& x : numbers) {
      x = float(double(random.below(20000)) / (s.divisor == 7846 ? 7846. : 1000.));
      if (random.chance(30)) x = -0.f;
      if (random.chance(3)) x = std::bit_cast<float>(static_cast<std::uint32_t>(random.next()));
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = numbers[i % 60];
    for (const int level : {1, 9})
      cases.push_back({put_into_systems(bytes_of(numbers), Scalar::float32, {s, s}, level), 100, 2,
                       Scalar::float32});
  }
  return cases;
}

/// Reads bytes, and if they can be read makes values of integers in their range.
bool reads(const Bytes& bytes, const Case& c, Random& random) {
  ByteReader in(bytes, 0);
  const auto reader = NumberReader::read(in, c.scalar, c.components, c.count);
  if (!reader.ok()) {
    EXPECT_TRUE(reader.error().code == ErrorCode::invalid ||
                reader.error().code == ErrorCode::truncated);
    return false;
  }
  Bytes values(c.count * c.components * size_of(c.scalar));
  const auto integer = [&](std::size_t i) {
    const std::uint64_t top = reader->numbers().axes[i % c.components].top;
    return random.chance(10) ? top : random.next() % (top + 1);
  };
  if (reader->numbers().narrow()) {
    std::vector<std::int32_t> rows(c.count * c.components);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<std::int32_t>(integer(i));
    return reader->to_values(std::span<const std::int32_t>(rows), values).ok();
  }
  std::vector<std::int64_t> rows(c.count * c.components);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<std::int64_t>(integer(i));
  return reader->to_values(std::span<const std::int64_t>(rows), values).ok();
}

TEST(Numbers, HostileBytesDoNoHarm) {
  const auto cases = some_cases();
  Random random(13);
  for (std::size_t n = 0; n < cases.size(); ++n) {
    const Case& c = cases[n];
    SCOPED_TRACE("case " + std::to_string(n));
    for (std::size_t size = 0; size < c.coded.bytes.size();
         size += 1 + c.coded.bytes.size() / (40 * long_runs())) {
      Bytes bytes(c.coded.bytes.begin(), c.coded.bytes.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_FALSE(reads(bytes, c, random));
    }
    for (unsigned i = 0; i < 300 * long_runs(); ++i) {
      Bytes bytes = c.coded.bytes;
      for (unsigned flips = 1 + random.below(3); flips > 0; --flips) {
        // Most fields are in the first bytes.
        const std::size_t at = random.chance(60) ? random.below(30) : random.below(1u << 20);
        bytes[at % bytes.size()] = static_cast<std::byte>(random.next());
      }
      reads(bytes, c, random);
    }
  }
}

}  // namespace
}  // namespace clers::internal

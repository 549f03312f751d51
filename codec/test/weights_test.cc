// Weights come back, whatever they are and whatever they lie on; no bytes do harm; and what the
// others leave of 1 takes next to nothing.
#include "codec/attributes/weights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "codec/attributes/named_values_encoder.h"
#include "codec/numbers/number_encoder.h"
#include "codec/test/coded_surfaces.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

template <class T>
NumberedValues numbered(const std::vector<T>& values, std::size_t components) {
  Bytes data(values.size() * sizeof(T));
  if (!values.empty()) std::memcpy(data.data(), values.data(), data.size());
  return number_values(data, scalar_of<T>(), components, 5);
}

template <class Int>
void check(const std::vector<Int>& rows, const Numbers& numbers, const ValueSurface& along,
           corpus::Random& random) {
  ASSERT_TRUE(may_be_weights(numbers));
  const Bytes bytes = encode_weights<Int>(rows, numbers, along);
  std::vector<Int> out(rows.size());
  for (Int& x : out) x = static_cast<Int>(random.next());
  const auto done = decode_weights<Int>(bytes, 0, numbers, along, out);
  ASSERT_TRUE(done.ok()) << done.error().what;
  ASSERT_EQ(out, rows);
  for (unsigned i = 0; i < 6 && !bytes.empty(); ++i) {
    Bytes changed = bytes;
    if (i < 4)
      changed[random.below(static_cast<std::uint32_t>(bytes.size()))] ^=
          static_cast<std::byte>(1 + random.below(255));
    else if (i == 4)
      changed.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
    else
      changed.push_back(static_cast<std::byte>(random.below(256)));
    const auto result = decode_weights<Int>(changed, 5, numbers, along, out);
    ASSERT_TRUE(i < 4 || !result.ok());
    for (std::size_t k = 0; result.ok() && k < out.size(); ++k) {
      const Axis& axis = numbers.axes[k % numbers.axes.size()];
      ASSERT_LE(static_cast<std::uint64_t>(out[k]), axis.top);
      ASSERT_TRUE(axis.palette.empty() ||
                  std::binary_search(axis.palette.begin(), axis.palette.end(),
                                     static_cast<std::uint64_t>(out[k])));
    }
  }
}
void check(const NumberedValues& values, ValueSurface along, corpus::Random& random) {
  // Of joints, too.
  const std::size_t width = values.numbers.axes.size(),
                    count = (values.narrow.size() + values.wide.size()) / width;
  Attribute joints{"JOINTS_0",
                   Domain::vertex,
                   random.chance(50) ? Scalar::uint8 : Scalar::uint16,
                   static_cast<std::uint8_t>(width),
                   {}};
  for (std::size_t i = 0; i < count * joints.stride(); ++i)
    joints.data.push_back(static_cast<std::byte>(random.below(3)));
  if (random.chance(50)) along.joints = &joints;
  if (values.numbers.narrow())
    check(values.narrow, values.numbers, along, random);
  else
    check(values.wide, values.numbers, along, random);
}

TEST(Weights, ComeBack) {
  corpus::Random random(1);
  unsigned kind = 0;
  for (const CodedArrays& s : test::coded_surfaces()) {
    if (kind++ % 4 != 0) continue;
    ValueSurface along{s.view()};
    const std::size_t count = s.introduced_by.size() + random.below(3), width = 2 + random.below(4);
    // Some at the vertex of another one.
    std::vector<std::uint32_t> vertex_of(count);
    for (std::uint32_t& v : vertex_of) v = random.below(static_cast<std::uint32_t>(count));
    if (random.chance(50)) along.vertex_of = vertex_of;
    if (random.chance(20)) along.surface.twins = {};
    std::vector<float> floats;
    std::vector<double> doubles;
    std::vector<std::uint8_t> bytes;
    std::vector<std::int16_t> shorts;
    for (std::size_t i = 0; i < count * width; ++i) {
      const double x = random.chance(40) ? 0 : random.below(1000) / 1000.;
      floats.push_back(static_cast<float>(x));
      // True floats, of any magnitude, and what is no number.
      doubles.push_back(random.chance(5)    ? std::numeric_limits<double>::quiet_NaN()
                        : random.chance(5)  ? -std::numeric_limits<double>::infinity()
                        : random.chance(10) ? 1e300
                                            : x * std::sqrt(double(random.below(1000))));
      bytes.push_back(static_cast<std::uint8_t>(random.below(256)));
      shorts.push_back(static_cast<std::int16_t>(random.below(3)));
    }
    check(numbered(floats, width), along, random);
    check(numbered(doubles, width), along, random);
    check(numbered(bytes, width), along, random);
    check(numbered(shorts, width), along, random);
  }
  check(numbered(std::vector<float>{1, 0, .5f, .5f, .25f, .75f}, 2), {}, random);
}

TEST(Weights, OthersAreRefused) {
  const Numbers one = numbered(std::vector<float>{1, 2, 3}, 1).numbers,
                words = numbered(std::vector<std::int32_t>{1, 2, 3, 4}, 2).numbers,
                two = numbered(std::vector<float>{0, 1, .5f, .5f}, 2).numbers;
  EXPECT_FALSE(may_be_weights(one));
  EXPECT_FALSE(may_be_weights(words));
  std::vector<std::int32_t> out(4);
  EXPECT_FALSE(decode_weights<std::int32_t>({}, 0, one, {}, out).ok());
  EXPECT_FALSE(decode_weights<std::int32_t>({}, 0, two, {}, out).ok());
  out.clear();
  EXPECT_TRUE(decode_weights<std::int32_t>({}, 0, two, {}, out).ok());
  const Attribute three{"JOINTS_0", Domain::vertex, Scalar::uint8, 3, Bytes(6)},
      floats{"JOINTS_0", Domain::vertex, Scalar::float32, 2, Bytes(16)},
      short_ones{"JOINTS_0", Domain::vertex, Scalar::uint8, 2, Bytes(2)};
  out.resize(4);
  for (const Attribute* joints : {&three, &floats, &short_ones}) {
    ValueSurface along;
    along.joints = joints;
    EXPECT_FALSE(decode_weights<std::int32_t>({}, 0, two, along, out).ok());
  }
  out.clear();
  const Bytes byte{std::byte(0)};
  EXPECT_FALSE(decode_weights<std::int32_t>(byte, 0, two, {}, out).ok());
}

TEST(Weights, WhatIsLeftOfOneSaves) {
  // Two or three of four, in steps of 2^-16, at random: the last takes next to nothing.
  const CodedArrays s = test::coded(corpus::torus(40, 30));
  corpus::Random random(2);
  std::vector<float> values;
  std::size_t free = 0;
  for (std::size_t v = 0; v < s.introduced_by.size(); ++v) {
    const bool three = random.chance(50);
    const std::uint32_t a = 1 + random.below(30000),
                        b = three ? 1 + random.below(30000) : 65536 - a;
    for (const std::uint32_t x : {a, b, three ? 65536 - a - b : 0u, 0u})
      values.push_back(static_cast<float>(x) / 65536);
    free += three ? 2 : 1;
  }
  const NumberedValues given = numbered(values, 4);
  ASSERT_TRUE(given.numbers.narrow());
  const std::span<const std::int32_t> rows(given.narrow);
  EXPECT_TRUE(look_like_weights(rows, given.numbers));
  const std::size_t bytes = encode_weights(rows, given.numbers, {s.view()}).size();
  EXPECT_LT(8 * bytes, free * 17 + s.introduced_by.size() * 3);
  values[0] += 1;
  for (float& x : values) x = x / 2;
  const NumberedValues half = numbered(values, 4);
  EXPECT_FALSE(look_like_weights(std::span<const std::int32_t>(half.narrow), half.numbers));
}

}  // namespace
}  // namespace clers::internal

// Angles, and directions on an octahedron: what grids have, what is moved to them, what is said of
// it.
#include "codec/numbers/directions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "codec/base/direction.h"
#include "codec/base/portable.h"
#include "codec/compare.h"
#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/numbers/number_decoder.h"
#include "codec/numbers/number_encoder.h"
#include "codec/numbers/octahedral.h"
#include "codec/test/attribute.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

using test::attribute;

constexpr char normal[] = "normal";

/// Any direction, not of length 1.
Vector3 any_vector(corpus::Random& random) {
  Vector3 v;
  do
    for (double& x : v) x = double(random.below(2000001)) / 1e6 - 1;
  while (dot(v, v) < 1e-3);
  return v;
}

TEST(Directions, AnglesAreThoseOfTheLibrary) {
  const DoublePrecision doubles;
  corpus::Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const double x = std::scalbn(double(random.below(2001)) - 1000, int(random.below(60)) - 30),
                 y = std::scalbn(double(random.below(1001)), int(random.below(60)) - 30);
    if (x == 0 && y == 0) continue;
    EXPECT_NEAR(angle_of(x, y), std::atan2(y, x), 1e-15 * (1 + std::atan2(y, x)));
  }
  EXPECT_EQ(degrees_between({1, 0, 0}, {0, 1, 0}), 90);
  EXPECT_EQ(degrees_between({1, 0, 0}, {-2, 0, 0}), 180);
  EXPECT_EQ(degrees_between({1, 2, 3}, {2, 4, 6}), 0);
  EXPECT_NEAR(degrees_between({1, 0, 0}, {1, 1e-9, 0}), 1e-9 * 57.29577951308232, 1e-22);
  EXPECT_NEAR(degrees_between({1e300, 0, 0}, {1e-310, 1e-310, 0}), 45, 1e-12);
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  EXPECT_EQ(degrees_between({0, 0, 0}, {0, 0, 0}), 0);
  EXPECT_EQ(degrees_between({nan, 0, 0}, {0, nan, 0}), 0);
  for (const Vector3& none : {Vector3{0, 0, 0}, {nan, 0, 0}, {0, infinity, 0}})
    EXPECT_EQ(degrees_between(none, {1, 0, 0}), infinity);
}

TEST(Directions, FewBitsHaveEachPointOnce) {
  for (unsigned bits = min_direction_bits; bits <= 6; ++bits) {
    const OctahedralGrid grid(bits);
    std::set<std::array<std::int32_t, 3>> points;
    const auto top = static_cast<std::int64_t>(grid.top());
    for (std::int64_t u = 0; u <= top; ++u)
      for (std::int64_t v = 0; v <= top; ++v) {
        const OctahedralPoint p = grid.point(u, v);
        ASSERT_EQ(std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]), grid.size());
        const auto [x, y] = grid.integers(p);
        ASSERT_EQ(grid.point(x, y), p);
        // Two places of the border are one point.
        if (x != u || y != v) {
          ASSERT_TRUE(u == 0 || u == top || v == 0 || v == top);
        }
        ASSERT_EQ(grid.nearest(grid.project(OctahedralGrid::direction(p))), p);
        points.insert(p.at);
      }
    EXPECT_EQ(points.size(),
              std::size_t(4) * std::size_t(grid.size()) * std::size_t(grid.size()) + 2);
  }
}

TEST(Directions, ThePointIsTheNearest) {
  corpus::Random random(2);
  for (unsigned bits = min_direction_bits; bits <= 5; ++bits) {
    const OctahedralGrid grid(bits);
    for (int i = 0; i < 500; ++i) {
      const Vector3 v = any_vector(random);
      const double found =
          degrees_between(v, OctahedralGrid::direction(grid.nearest(grid.project(v))));
      double least = 180;
      for (std::int64_t a = 0; a <= std::int64_t(grid.top()); ++a)
        for (std::int64_t b = 0; b <= std::int64_t(grid.top()); ++b)
          least = std::min(least, degrees_between(v, OctahedralGrid::direction(grid.point(a, b))));
      // The nearest corner of the triangle around it may be no nearer than one beside that.
      EXPECT_LE(found, least * 1.2 + 1e-9) << bits;
      EXPECT_LE(found, 100. / grid.size()) << bits;
    }
  }
}

template <class T>
std::vector<T> random_vectors(std::size_t count, bool unit) {
  corpus::Random random(count);
  std::vector<T> all;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3 v = any_vector(random);
    const double length = unit ? std::sqrt(dot(v, v)) : 1;
    for (const double x : v) all.push_back(static_cast<T>(x / length));
  }
  return all;
}

template <class T>
void expect_points_come_back() {
  const Scalar scalar = scalar_of<T>();
  for (unsigned bits = min_direction_bits; bits <= max_direction_bits; ++bits) {
    const Attribute a = attribute(normal, Domain::vertex, scalar, 3, random_vectors<T>(300, false));
    const auto moved = quantise_directions(a, bits);
    ASSERT_TRUE(moved.ok());
    EXPECT_EQ(moved->plan.measure, ErrorMeasure::angle);
    EXPECT_LE(moved->plan.error, 100. / OctahedralGrid(bits).size());
    NumberedValues numbered = put_into_systems(moved->values, scalar, moved->plan.systems, 5);
    EXPECT_EQ(numbered.numbers.octahedral_bits(), bits);
    ByteReader in(numbered.bytes, 0);
    const auto reader = NumberReader::read(in, scalar, 3, 300);
    ASSERT_TRUE(reader.ok());
    EXPECT_EQ(in.left(), 0u);
    Bytes back(moved->values.size());
    ASSERT_TRUE(reader->to_values(std::span<const std::int32_t>(numbered.narrow), back).ok());
    EXPECT_EQ(back, moved->values) << bits;
    // What is on the grid stays there.
    Attribute again = a;
    again.data = back;
    const auto twice = quantise_directions(again, bits);
    ASSERT_TRUE(twice.ok());
    EXPECT_EQ(twice->plan.error, 0);
    EXPECT_TRUE(twice->values.empty());
    EXPECT_EQ(twice->plan.systems.size(), 1u);
  }
}
TEST(Directions, PointsComeBack) {
  expect_points_come_back<float>();
  expect_points_come_back<double>();
}

TEST(Directions, UnitVectorsAreTold) {
  auto values = random_vectors<float>(50, true);
  EXPECT_TRUE(are_unit_vectors(attribute(normal, Domain::vertex, Scalar::float32, 3, values)));
  for (const float wrong : {0.f, 1.5f, 3e38f, std::nanf("")}) {
    auto some = values;
    some[77] = some[76] = wrong;
    EXPECT_FALSE(are_unit_vectors(attribute(normal, Domain::vertex, Scalar::float32, 3, some)));
  }
  EXPECT_FALSE(are_unit_vectors(attribute(normal, Domain::vertex, Scalar::float32, 2, values)));
  EXPECT_FALSE(are_unit_vectors(
      attribute(normal, Domain::vertex, Scalar::float32, 3, std::vector<float>{})));
}

Mesh sphere_with(const Attribute& a) {
  Mesh mesh = corpus::icosphere(2);
  mesh.attributes.push_back(a);
  return mesh;
}

/// Encodes and decodes: the error that is stated is the one found.
void expect_stated(const Mesh& mesh, const Precision& precision, ErrorMeasure measure) {
  for (const int level : {1, 5, 9}) {
    EncodeOptions options;
    options.level = level;
    options.precisions = {{normal, precision, {}}};
    const auto encoded = encode(mesh, options);
    ASSERT_TRUE(encoded.ok()) << describe(encoded.error());
    const AttributeInfo& info = encoded->report[0].attributes.back();
    EXPECT_EQ(info.measure, measure);
    EXPECT_GT(info.error, 0);
    const auto decoded = decode(encoded->bytes);
    ASSERT_TRUE(decoded.ok()) << describe(decoded.error());
    const Tolerance tolerance = {normal, info.error, {}, info.measure};
    for (const bool told : {true, false}) {
      const auto found =
          told ? compare(mesh, (*decoded)[0], {&tolerance, 1}, encoded->permutations[0])
               : compare(mesh, (*decoded)[0], {&tolerance, 1});
      ASSERT_TRUE(found.ok());
      ASSERT_EQ(found->verdict, Verdict::same) << found->what;
      EXPECT_EQ(found->errors[0].error, info.error);
      EXPECT_EQ(found->errors[0].measure, measure);
    }
    const Tolerance less = {normal, info.error * .999, {}, info.measure};
    const auto different = compare(mesh, (*decoded)[0], {&less, 1});
    ASSERT_TRUE(different.ok());
    EXPECT_NE(different->verdict, Verdict::same);
  }
}

TEST(Directions, TheAngleStatedIsTheAngleFound) {
  const Mesh mesh = sphere_with(
      attribute(normal, Domain::vertex, Scalar::float32, 3, random_vectors<float>(162, true)));
  for (const int bits : {2, 8, 10, 16, 20})
    expect_stated(mesh, Precision::of_directions(bits), ErrorMeasure::angle);
  Precision either = Precision::of_bits(10);
  either.or_directions = true;
  expect_stated(mesh, either, ErrorMeasure::angle);
  // Their length is lost, and said to be.
  const Mesh longer = sphere_with(
      attribute(normal, Domain::vertex, Scalar::float64, 3, random_vectors<double>(162, false)));
  expect_stated(longer, Precision::of_directions(10), ErrorMeasure::angle);
  // Of other vectors, bits are those of a grid.
  expect_stated(longer, either, ErrorMeasure::difference);
}

TEST(Directions, WhatHasNoneIsRefused) {
  auto values = random_vectors<float>(162, true);
  values[3 * 7] = values[3 * 7 + 1] = values[3 * 7 + 2] = 0;
  EncodeOptions options;
  options.precisions = {{normal, Precision::of_directions(10), {}}};
  const auto encoded =
      encode(sphere_with(attribute(normal, Domain::vertex, Scalar::float32, 3, values)), options);
  ASSERT_FALSE(encoded.ok());
  EXPECT_EQ(encoded.error().code, ErrorCode::not_on_grid);
  EXPECT_EQ(encoded.error().at, 7u);
  const auto two = encode(
      sphere_with(attribute(normal, Domain::vertex, Scalar::float32, 2, std::vector<float>(324))),
      options);
  ASSERT_FALSE(two.ok());
  EXPECT_EQ(two.error().code, ErrorCode::bad_option);
  for (const Precision& wrong :
       {Precision::of_directions(1), Precision::of_directions(21), Precision::recomputed(0),
        Precision::recomputed(181), Precision::recomputed(std::nan(""))}) {
    options.precisions = {{normal, wrong, {}}};
    const auto refused =
        encode(sphere_with(attribute(normal, Domain::vertex, Scalar::float32, 3, values)), options);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::bad_option);
  }
}

TEST(Directions, NumbersOfOtherFilesAreRefused) {
  const auto fails = [](std::vector<unsigned> given, Scalar scalar, std::size_t components) {
    Bytes bytes;
    for (const unsigned b : given) put_u8(bytes, b);
    ByteReader in(bytes, 0);
    return !NumberReader::read(in, scalar, components, 9).ok();
  };
  EXPECT_FALSE(fails({6, 10}, Scalar::float32, 3));
  EXPECT_TRUE(fails({6}, Scalar::float32, 3));
  EXPECT_TRUE(fails({6, 1}, Scalar::float32, 3));
  EXPECT_TRUE(fails({6, 21}, Scalar::float32, 3));
  EXPECT_TRUE(fails({6, 10}, Scalar::float32, 2));
  EXPECT_TRUE(fails({6, 10}, Scalar::int16, 3));
}

}  // namespace
}  // namespace clers::internal

// Normals that follow from positions and faces: within the angle that was asked for, next to
// nothing in the file, and the angle stated is the one found.
#include "codec/file/recomputed_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "codec/base/direction.h"
#include "codec/compare.h"
#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/test/attribute.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

using test::attribute;

constexpr char normal[] = "normal";

/// A sphere with its radii as normals, some turned by up to so many degrees.
struct Sphere {
  Mesh mesh = corpus::icosphere(4);
  std::vector<float> radii;

  explicit Sphere(double some_by = 0) {
    corpus::Random random(7);
    const Attribute* position = mesh.position();
    for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) {
      Vector3 n = vector_at(position->scalar, position->data.data() + v * position->stride());
      const double length = std::sqrt(dot(n, n));
      for (double& x : n) x /= length;
      if (random.chance(10))
        for (double& x : n) x += (double(random.below(2001)) / 1000 - 1) * some_by / 100;
      for (const double x : n) radii.push_back(static_cast<float>(x));
    }
  }
};

Encoded expect_within(const Mesh& mesh, double degrees, const EncodeOptions& given = {}) {
  EncodeOptions options = given;
  options.precisions.push_back({normal, Precision::recomputed(degrees), {}});
  auto encoded = encode(mesh, options);
  EXPECT_TRUE(encoded.ok()) << describe(encoded.error());
  if (!encoded) return {};
  const AttributeInfo& info = encoded->report[0].attributes.back();
  EXPECT_LE(info.error, degrees);
  EXPECT_EQ(info.measure, ErrorMeasure::angle);
  const auto decoded = decode(encoded->bytes);
  EXPECT_TRUE(decoded.ok());
  if (!decoded) return {};
  std::vector<Tolerance> tolerances;
  for (const AttributeInfo& a : encoded->report[0].attributes)
    if (a.error > 0) tolerances.push_back({a.name, a.error, a.domain, a.measure});
  const auto found = compare(mesh, (*decoded)[0], tolerances);
  EXPECT_TRUE(found.ok());
  EXPECT_EQ(found->verdict, Verdict::same) << found->what;
  for (const FoundError& error : found->errors)
    if (error.attribute == normal) {
      EXPECT_EQ(error.error, info.error);
    }
  return std::move(*encoded);
}

TEST(RecomputedNormals, CostNextToNothing) {
  Sphere sphere;
  sphere.mesh.attributes.push_back(
      attribute(normal, Domain::vertex, Scalar::float32, 3, sphere.radii));
  const Encoded whole = expect_within(sphere.mesh, 5);
  EXPECT_LT(whole.report[0].attribute_bytes, 120u);
  EXPECT_GT(whole.report[0].attributes.back().error, 0);
  EncodeOptions options;
  options.precisions = {{position_name, Precision::of_bits(9), {}}};
  options.piece_faces = 1000;
  expect_within(sphere.mesh, 5, options);
  options.level = 1;
  expect_within(sphere.mesh, 5, options);
}

TEST(RecomputedNormals, OthersAreCorrected) {
  for (const double degrees : {3., .5, .01}) {
    Sphere sphere(100);
    sphere.mesh.attributes.push_back(
        attribute(normal, Domain::vertex, Scalar::float32, 3, sphere.radii));
    expect_within(sphere.mesh, degrees);
  }
}

TEST(RecomputedNormals, OfCornersFacesAndByIndex) {
  Sphere sphere;
  const Mesh& mesh = sphere.mesh;
  const std::vector<std::uint32_t> corners = mesh.corners;
  std::vector<float> of_corners, of_faces;
  for (std::size_t h = 0; h < corners.size(); ++h)
    for (std::size_t c = 0; c < 3; ++c) {
      of_corners.push_back(sphere.radii[3 * corners[h] + c]);
      if (h % 3 == 0) of_faces.push_back(of_corners.back());
    }
  Mesh with = mesh;
  with.attributes.push_back(attribute(normal, Domain::corner, Scalar::float32, 3, of_corners));
  EXPECT_LT(expect_within(with, 5).report[0].attribute_bytes, 400u);
  with.attributes.back() = attribute(normal, Domain::face, Scalar::float32, 3, of_faces);
  expect_within(with, 20);
  with.attributes.back() = attribute(normal, Domain::corner, Scalar::float32, 3, sphere.radii);
  with.attributes.back().indices = corners;
  with.attributes.back().indices[5] = no_value;
  EXPECT_LT(expect_within(with, 5).report[0].attribute_bytes, 400u);
}

TEST(RecomputedNormals, WhatHasNoneIsRefused) {
  Sphere sphere;
  auto radii = sphere.radii;
  for (std::size_t c = 0; c < 3; ++c) radii[27 + c] = 0;
  Mesh mesh = sphere.mesh;
  mesh.attributes.push_back(attribute(normal, Domain::vertex, Scalar::float32, 3, radii));
  EncodeOptions options;
  options.precisions = {{normal, Precision::recomputed(1), {}}};
  auto encoded = encode(mesh, options);
  ASSERT_FALSE(encoded.ok());
  EXPECT_EQ(encoded.error().code, ErrorCode::not_on_grid);
  EXPECT_EQ(encoded.error().at, 9u);
  mesh.attributes.erase(mesh.attributes.begin());
  mesh.attributes.back() = attribute(normal, Domain::vertex, Scalar::float32, 3, sphere.radii);
  encoded = encode(mesh, options);
  ASSERT_FALSE(encoded.ok());
  EXPECT_EQ(encoded.error().code, ErrorCode::bad_option);
}

}  // namespace
}  // namespace clers::internal

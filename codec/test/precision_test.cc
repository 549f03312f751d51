// Meshes encoded less exactly than they are: what comes back, and what is said of it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "codec/base/difference.h"
#include "codec/compare.h"
#include "codec/decode.h"
#include "codec/decoder.h"
#include "codec/encode.h"
#include "codec/test/attribute.h"
#include "corpus/generate.h"

namespace clers::internal {
namespace {

using test::attribute;

constexpr char uv[] = "uv", colour[] = "colour", weight[] = "weight";

/// A hilly terrain with a value of each kind.
Mesh terrain(std::uint32_t size, double x0, double y0) {
  Mesh mesh = corpus::grid(size, size);
  std::vector<float> places, coordinates;
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) {
    const double x = x0 + v % (size + 1), y = y0 + v / (size + 1);
    for (const double c :
         {x * 1.37, y * 1.37, 9 * std::sin(x * .3) * std::cos(y * .21) + x * y * .01})
      places.push_back(static_cast<float>(c));
  }
  for (std::size_t c = 0; c < 2 * mesh.corners.size(); ++c)
    coordinates.push_back(static_cast<float>(std::sin(double(c % 977)) / 2));
  std::vector<std::uint8_t> colours(3 * mesh.vertex_count);
  for (std::size_t i = 0; i < colours.size(); ++i)
    colours[i] = static_cast<std::uint8_t>(i * i % 251);
  std::vector<double> weights(mesh.face_count());
  for (std::size_t f = 0; f < weights.size(); ++f) weights[f] = std::cos(double(f));
  mesh.attributes = {attribute(position_name, Domain::vertex, Scalar::float32, 3, places),
                     attribute(uv, Domain::corner, Scalar::float32, 2, coordinates),
                     attribute(colour, Domain::vertex, Scalar::uint8, 3, colours),
                     attribute(weight, Domain::face, Scalar::float64, 1, weights)};
  return mesh;
}

std::vector<AttributePrecision> all_kinds() {
  return {{position_name, Precision::of_bits(12), {}},
          {uv, Precision::of_step(1. / 1024), Domain::corner},
          {weight, Precision::of_error(1e-3), {}}};
}

std::vector<Tolerance> stated(const MeshInfo& info) {
  std::vector<Tolerance> tolerances;
  for (const AttributeInfo& a : info.attributes)
    if (a.error > 0) tolerances.push_back({a.name, a.error, a.domain});
  return tolerances;
}

/// Encodes, decodes, and looks whether the error that is stated is the one found.
void check_errors(const Mesh& mesh, const EncodeOptions& options) {
  const auto encoded = encode(mesh, options);
  ASSERT_TRUE(encoded.ok()) << describe(encoded.error());
  const auto decoded = decode(encoded->bytes);
  ASSERT_TRUE(decoded.ok()) << describe(decoded.error());
  const auto decoder = Decoder::open(encoded->bytes);
  ASSERT_TRUE(decoder.ok());
  const auto info = decoder->info();
  ASSERT_TRUE(info.ok());
  ASSERT_EQ(info->meshes[0].attributes.size(), mesh.attributes.size());
  for (std::size_t k = 0; k < mesh.attributes.size(); ++k)
    EXPECT_EQ(info->meshes[0].attributes[k].error, encoded->report[0].attributes[k].error);
  const auto found =
      compare(mesh, (*decoded)[0], stated(info->meshes[0]), encoded->permutations[0]);
  ASSERT_TRUE(found.ok()) << describe(found.error());
  ASSERT_EQ(found->verdict, Verdict::same) << found->what;
  for (const FoundError& error : found->errors)
    for (const AttributeInfo& a : info->meshes[0].attributes)
      if (a.name == error.attribute) {
        EXPECT_EQ(a.error, error.error) << a.name;
      }
  // The renumbering is found without being told, too.
  const auto searched = compare(mesh, (*decoded)[0], stated(info->meshes[0]));
  ASSERT_TRUE(searched.ok());
  EXPECT_EQ(searched->verdict, Verdict::same) << searched->what;
}

TEST(Precision, TheErrorStatedIsTheErrorFound) {
  for (const int level : {1, 3, 5, 7, 9})
    for (const Order order : {Order::free, Order::keep})
      for (const std::uint32_t pieces : {never_in_pieces, 150u}) {
        EncodeOptions options;
        options.level = level;
        options.order = order;
        options.piece_faces = pieces;
        options.precisions = all_kinds();
        check_errors(terrain(17, 0, 0), options);
      }
  for (int bits = min_bits; bits <= max_bits; ++bits) {
    EncodeOptions options;
    options.precisions = {{position_name, Precision::of_bits(bits), {}},
                          {colour, Precision::of_bits(std::min(bits, 7)), {}}};
    check_errors(terrain(9, -3, 40), options);
  }
}

TEST(Precision, OfOddMeshes) {
  EncodeOptions options;
  options.precisions = {{position_name, Precision::of_bits(10), {}}};
  std::mt19937 random(4);
  std::vector<Mesh> meshes = {corpus::random_soup(40, 90, 5, 3),
                              corpus::fan(9),
                              corpus::add_fins(corpus::grid(5, 5), 4, 2),
                              corpus::isolate(corpus::tetrahedron(), 30),
                              corpus::same_triangle(6),
                              Mesh()};
  meshes.emplace_back();
  meshes.back().vertex_count = 1;
  for (Mesh& mesh : meshes) {
    std::vector<double> places(3 * mesh.vertex_count);
    for (double& x : places) x = std::uniform_real_distribution<double>(-5, 5)(random);
    mesh.attributes = {attribute(position_name, Domain::vertex, Scalar::float64, 3, places)};
    check_errors(mesh, options);
  }
}

TEST(Precision, OfExtremeNumbers) {
  Mesh mesh = corpus::tetrahedron();
  mesh.attributes.clear();
  const auto check = [&](auto least, auto greatest, const Precision& precision) {
    mesh.attributes = {attribute(weight, Domain::vertex, scalar_of<decltype(least)>(), 1,
                                 std::vector{least, greatest, least, greatest / 3})};
    EncodeOptions options;
    options.precisions = {{weight, precision, {}}};
    check_errors(mesh, options);
  };
  for (const int bits : {1, 8, 30}) {
    check(-1.5e308, 1e307, Precision::of_bits(bits));
    check(1e-300, 3e-299, Precision::of_bits(bits));
    check(-3.4e38f, 3.4e38f, Precision::of_bits(bits));
    check(0.f, 1e-44f, Precision::of_bits(bits));
  }
  check(-1e300, 1e300, Precision::of_error(1e299));
}

TEST(Precision, WhatIsNotNamedIsLossless) {
  const Mesh mesh = terrain(8, 0, 0);
  EncodeOptions options;
  options.precisions = {{uv, Precision::of_bits(6), {}}};
  const auto encoded = encode(mesh, options);
  ASSERT_TRUE(encoded.ok());
  for (const AttributeInfo& a : encoded->report[0].attributes)
    EXPECT_EQ(a.error > 0, a.name == uv) << a.name;
  EXPECT_EQ(options.precision_of(uv, Domain::corner), Precision::of_bits(6));
  EXPECT_EQ(options.precision_of(position_name), Precision::lossless());
}

using Place = std::array<float, 3>;

std::vector<Place> places_of(const Mesh& mesh) {
  std::vector<Place> places(mesh.vertex_count);
  std::memcpy(places.data(), mesh.position()->data.data(), mesh.position()->data.size());
  return places;
}

TEST(Precision, PiecesShareOneGrid) {
  const Mesh mesh = terrain(30, 0, 0);
  EncodeOptions whole, in_pieces;
  whole.precisions = in_pieces.precisions = all_kinds();
  in_pieces.piece_faces = 200;
  const auto a = decode(encode(mesh, whole)->bytes), b = decode(encode(mesh, in_pieces)->bytes);
  ASSERT_TRUE(a.ok() && b.ok());
  const auto places = [](const Mesh& m) {
    const std::vector<Place> all = places_of(m);
    return std::multiset<Place>(all.begin(), all.end());
  };
  EXPECT_EQ(places((*a)[0]), places((*b)[0]));
}

TEST(Precision, TilesShareTheirBorder) {
  constexpr std::uint32_t size = 16;
  const Mesh west = terrain(size, 0, 5), east = terrain(size, size, 5);
  EncodeOptions options;
  options.order = Order::keep;
  for (const Precision& precision :
       {Precision::on_grid({.25, 7, -100}, .03), Precision::of_step(.03)}) {
    options.precisions = {{position_name, precision, {}}};
    const auto a = decode(encode(west, options)->bytes), b = decode(encode(east, options)->bytes);
    ASSERT_TRUE(a.ok() && b.ok());
    const std::vector<Place> left = places_of((*a)[0]), right = places_of((*b)[0]);
    for (std::uint32_t row = 0; row <= size; ++row) {
      const Place &x = left[row * (size + 1) + size], &y = right[row * (size + 1)];
      EXPECT_EQ(std::memcmp(x.data(), y.data(), sizeof x), 0) << row;
    }
  }
}

TEST(Precision, TheBytesDoNotDependOnThreads) {
  const Mesh meshes[] = {terrain(20, 0, 0), terrain(11, 3, 3)};
  EncodeOptions options;
  options.precisions = all_kinds();
  options.piece_faces = 300;
  const auto one = encode(meshes, options);
  options.threads = 4;
  const auto four = encode(meshes, options);
  ASSERT_TRUE(one.ok() && four.ok());
  EXPECT_EQ(one->bytes, four->bytes);
}

TEST(Precision, WhatIsRefused) {
  Mesh meshes[] = {terrain(4, 0, 0), terrain(5, 0, 0)};
  const auto refused = [&](std::vector<AttributePrecision> precisions, ErrorCode code,
                           const std::string& named) {
    EncodeOptions options;
    options.precisions = std::move(precisions);
    const auto out = encode(meshes, options);
    ASSERT_FALSE(out.ok());
    EXPECT_EQ(out.error().code, code) << out.error().what;
    EXPECT_NE(out.error().what.find(named), std::string::npos) << out.error().what;
  };
  refused({{"normal", Precision::of_bits(8), {}}}, ErrorCode::bad_option, "'normal'");
  refused({{uv, Precision::of_bits(8), Domain::vertex}}, ErrorCode::bad_option,
          "vertex attribute 'uv'");
  refused({{uv, Precision::of_bits(31), {}}}, ErrorCode::bad_option, "'uv'");
  refused({{uv, Precision::of_step(-1), {}}}, ErrorCode::bad_option, "'uv'");
  refused({{uv, Precision::on_grid({0, 0, 0}, 1), {}}}, ErrorCode::bad_option, "'uv'");
  refused({{uv, Precision::of_bits(8), {}}, {uv, Precision::of_bits(8), Domain::corner}},
          ErrorCode::bad_option, "twice");
  refused({{weight, Precision::of_step(1e-18), {}}}, ErrorCode::not_on_grid, "'weight'");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(meshes[1].attributes[0].data.data() + 7 * 12, &nan, sizeof nan);
  refused({{position_name, Precision::of_bits(8), {}}}, ErrorCode::not_on_grid, "'position'");
  // Some mesh has it.
  meshes[0].attributes.pop_back();
  EncodeOptions options;
  options.precisions = {{weight, Precision::of_bits(8), {}}};
  EXPECT_TRUE(encode(meshes, options).ok());
}

TEST(Precision, AWarningOfWastedBits) {
  Mesh meshes[] = {terrain(9, 0, 0), terrain(9, 0, 0)};
  const float far = 1e4f;
  std::memcpy(meshes[1].attributes[0].data.data() + 42 * 12, &far, sizeof far);
  EncodeOptions options;
  options.precisions = {{position_name, Precision::of_bits(14), {}}};
  const auto encoded = encode(meshes, options);
  ASSERT_TRUE(encoded.ok());
  ASSERT_EQ(encoded->warnings.size(), 1u);
  const Warning& warning = encoded->warnings[0];
  EXPECT_EQ(warning.code, WarningCode::wasted_bits);
  EXPECT_EQ(warning.mesh, 1u);
  EXPECT_EQ(warning.attribute, position_name);
  EXPECT_EQ(warning.at, 42u);
  options.precisions[0].precision = Precision::of_step(.1);
  EXPECT_TRUE(encode(meshes, options)->warnings.empty());
}

}  // namespace
}  // namespace clers::internal

#include "codec/encode.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>
#include <limits>
#include <random>

#include "codec/decode.h"
#include "codec/inspect.h"
#include "codec/test/attribute.h"
#include "codec/test/decoding.h"
#include "codec/test/round_trip.h"
#include "corpus/generate.h"

namespace clers::internal {
namespace {

using test::decode_into;
using test::expect_same_info;

Attribute random_attribute(std::string name, Domain domain, Scalar scalar, unsigned components,
                           std::size_t count, std::uint64_t seed) {
  Attribute a{std::move(name), domain, scalar, static_cast<std::uint8_t>(components), {}};
  a.data.resize(count * a.stride());
  for (std::byte& b : a.data) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    b = static_cast<std::byte>(seed >> 56);
  }
  return a;
}

Error error_of(const Mesh& mesh) {
  auto coded = encode(std::span(&mesh, 1));
  EXPECT_FALSE(coded.ok());
  return coded.ok() ? Error{} : coded.error();
}

TEST(Encode, NothingAndEmptyMeshes) {
  round_trip({});
  const Mesh empty;
  round_trip(std::span(&empty, 1));
  Mesh points;
  points.vertex_count = 5;
  points.name = "points";
  points.attributes.push_back(test::attribute<float>("position", Domain::vertex, Scalar::float32, 3,
                                                     std::vector<float>(15, 1.5f)));
  points.attributes.push_back(test::attribute<float>("of corners", Domain::corner, Scalar::float32,
                                                     2, std::vector<float>()));
  round_trip(std::span(&points, 1));
}

TEST(Encode, EveryLevel) {
  const Mesh mesh = corpus::shuffle(corpus::punch_holes(corpus::torus(30, 20), 5, 1), 1);
  for (int level = min_level; level <= max_level; ++level) round_trip(std::span(&mesh, 1), level);
  EncodeOptions options;
  for (const int level : {0, 10, -3}) {
    options.level = level;
    auto coded = encode(std::span(&mesh, 1), options);
    ASSERT_FALSE(coded.ok());
    EXPECT_EQ(coded.error().code, ErrorCode::bad_option);
  }
}

TEST(Encode, SeveralMeshesAndIsolatedVertices) {
  std::vector<Mesh> meshes = {corpus::icosphere(2), corpus::grid(3, 3), Mesh{},
                              corpus::tetrahedron()};
  meshes[0].name = "ball";
  meshes[3].name = "simplex";
  Mesh& grid = meshes[1];  // vertices in front, between and behind that no face uses
  for (std::uint32_t& v : grid.corners) v = 2 * v + 3;
  grid.vertex_count = 2 * grid.vertex_count + 9;
  grid.attributes = {
      random_attribute("position", Domain::vertex, Scalar::float64, 3, grid.vertex_count, 1)};
  round_trip(meshes);
}

/// Faces that run against their neighbours keep running against them.
TEST(Encode, InconsistentOrientationSurvives) {
  std::vector<Mesh> meshes = {corpus::icosphere(2), corpus::grid(6, 5), corpus::torus(9, 8)};
  meshes.push_back(corpus::copies(corpus::tetrahedron(), 3));
  std::uint32_t random = 1;
  for (Mesh& mesh : meshes)
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
      if ((random = random * 1664525u + 1013904223u) >> 30 == 0)
        std::swap(mesh.corners[3 * f], mesh.corners[3 * f + 1]);
  meshes[1].attributes.push_back(
      random_attribute("uv", Domain::corner, Scalar::float32, 2, meshes[1].corners.size(), 5));
  round_trip(meshes);
}

TEST(Encode, OddFloatsSurvive) {
  Mesh mesh = corpus::icosphere(1);
  std::vector<float> p(3 * std::size_t(mesh.vertex_count), -0.0f);
  p[0] = std::numeric_limits<float>::quiet_NaN();
  p[1] = std::numeric_limits<float>::infinity();
  p[2] = -std::numeric_limits<float>::infinity();
  p[3] = std::numeric_limits<float>::denorm_min();
  const std::uint32_t payload = 0xffc12345u;
  std::memcpy(&p[4], &payload, 4);
  p[5] = 0.0f;
  mesh.attributes = {test::attribute<float>("position", Domain::vertex, Scalar::float32, 3, p)};
  round_trip(std::span(&mesh, 1));
}

/// Attributes of every kind with random bits on random surfaces.
RC_GTEST_PROP(Encode, AttributesSurvive, ()) {
  Mesh mesh =
      corpus::shuffle(corpus::punch_holes(corpus::torus(*rc::gen::inRange(5u, 12u), 7),
                                          *rc::gen::inRange(0u, 3u), *rc::gen::inRange(0u, 100u)),
                      *rc::gen::inRange(0u, 100u));
  mesh.vertex_count += *rc::gen::inRange(0u, 3u);
  mesh.attributes.clear();
  const unsigned n = *rc::gen::inRange(0u, 5u);
  for (unsigned i = 0; i < n; ++i) {
    const auto domain = static_cast<Domain>(*rc::gen::inRange(0, 3));
    const auto scalar = static_cast<Scalar>(*rc::gen::inRange(0, 10));
    const unsigned components = *rc::gen::inRange(1u, 5u);
    const std::size_t count = domain == Domain::vertex   ? mesh.vertex_count
                              : domain == Domain::corner ? mesh.corners.size()
                                                         : mesh.face_count();
    const std::string name = i == 0 ? "position" : "a" + std::to_string(i);
    mesh.attributes.push_back(random_attribute(name, domain, scalar, components, count,
                                               *rc::gen::arbitrary<std::uint64_t>()));
  }
  round_trip(std::span(&mesh, 1), *rc::gen::inRange(1, 10));
  RC_ASSERT(!::testing::Test::HasFailure());
}

/// Fans that meet in a vertex: open ones, closed ones, one of each, in one component and in
/// several.
std::vector<Mesh> pinched_meshes() {
  Mesh two_balls = corpus::copies(corpus::tetrahedron(), 2), pinched = corpus::torus(8, 8);
  for (std::uint32_t& v : two_balls.corners)
    if (v == 4) v = 0;
  for (std::uint32_t& v : pinched.corners)
    if (v == 36) v = 0;
  Mesh ball_on_disc = corpus::copies(corpus::tetrahedron(), 2);
  ball_on_disc.corners.resize(ball_on_disc.corners.size() - 3);
  ball_on_disc.corners[12] = 0;
  return {two_balls, pinched, ball_on_disc, corpus::chessboard(2), corpus::chessboard(9)};
}

TEST(Encode, PinchedVerticesSurvive) {
  for (const Mesh& mesh : pinched_meshes())
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Mesh shuffled = seed ? corpus::shuffle(mesh, seed) : mesh;
      round_trip(std::span(&shuffled, 1));
    }
}

TEST(Encode, RefusesWhatOptionsForbid) {
  EncodeOptions strict;
  strict.on_nonmanifold = strict.on_degenerate = strict.on_duplicate = DefectPolicy::reject;
  const auto error_of = [&](const Mesh& mesh) {
    auto coded = encode(std::span(&mesh, 1), strict);
    EXPECT_FALSE(coded.ok());
    return coded.ok() ? Error{} : coded.error();
  };
  for (const Mesh& mesh : pinched_meshes()) {
    const Error e = error_of(mesh);
    EXPECT_EQ(e.code, ErrorCode::nonmanifold_vertex);
    EXPECT_EQ(e.place, Place::vertex);
  }
  EXPECT_EQ(error_of(corpus::moebius_strip(9, 2)).code, ErrorCode::nonorientable);

  Mesh soup;
  soup.vertex_count = 8;
  soup.corners = {4, 5, 2, 3, 0, 1, 1, 2, 3, 5, 4, 2, 3, 7};
  soup.face_sizes = {4, 3, 4, 3};
  EXPECT_EQ(describe(error_of(soup)), "face 1: uses a vertex twice");
  strict.on_degenerate = DefectPolicy::keep;
  EXPECT_EQ(describe(error_of(soup)), "face 2: has the same vertices as face 0");
  strict.on_duplicate = DefectPolicy::keep;
  const Error e = error_of(soup);  // face 1 is set aside, but counts
  EXPECT_EQ(e.code, ErrorCode::nonmanifold_edge);
  EXPECT_EQ(e.at, 0u);
  soup.face_sizes = {4, 3, 4, 2, 1};
  strict.on_degenerate = DefectPolicy::reject;
  soup.corners[6] = 6;
  EXPECT_EQ(describe(error_of(soup)), "face 3: has 2 corners, expected 3 at least");
}

TEST(Encode, RefusesArraysThatDisagree) {
  Mesh odd;
  odd.vertex_count = 4;
  odd.corners = {0, 1, 2, 3};
  EXPECT_EQ(error_of(odd).code, ErrorCode::inconsistent_mesh);
  odd.corners = {0, 1, 4};
  EXPECT_EQ(describe(error_of(odd)), "face 0: has vertex 4, expected one below 4");

  Mesh lying = corpus::tetrahedron();
  lying.attributes[0].data.pop_back();
  EXPECT_EQ(error_of(lying).code, ErrorCode::inconsistent_mesh);
}

TEST(Decode, EveryPrefixAndEveryFlippedBitIsRefused) {
  Mesh mesh = corpus::punch_holes(corpus::icosphere(2), 2, 1);
  mesh.name = "a name";
  const std::vector<std::byte> bytes = round_trip(std::span(&mesh, 1));
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    const std::vector<std::byte> prefix(bytes.begin(),
                                        bytes.begin() + static_cast<std::ptrdiff_t>(n));
    auto out = decode(prefix);
    ASSERT_FALSE(out.ok()) << n;
    EXPECT_EQ(out.error().code, ErrorCode::truncated) << n << ": " << describe(out.error());
    EXPECT_FALSE(inspect(prefix).ok());
  }
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::vector<std::byte> altered = bytes;
    altered[bit / 8] ^= static_cast<std::byte>(1u << bit % 8);
    EXPECT_FALSE(decode(altered).ok()) << bit;
  }
  std::vector<std::byte> longer = bytes;
  longer.push_back(std::byte{0});
  auto out = decode(longer);
  ASSERT_FALSE(out.ok());
  EXPECT_EQ(out.error().code, ErrorCode::trailing_bytes);
}

TEST(Decode, NamesOtherFiles) {
  std::vector<std::byte> bytes(100, std::byte{'x'});
  EXPECT_EQ(decode(bytes).error().code, ErrorCode::not_clers);
  const char newer[] = {'C', 'L', 'E', 'R', 'S', '\x7f', 5, 0, 0, 0};
  EXPECT_EQ(decode(std::as_bytes(std::span(newer))).error().code, ErrorCode::unsupported_version);
}

TEST(Decode, Limits) {
  const Mesh mesh = corpus::icosphere(3);
  auto coded = encode(std::span(&mesh, 1));
  ASSERT_TRUE(coded.ok());
  DecodeOptions options;
  EXPECT_TRUE(decode(coded->bytes, options).ok());
  options.limits.faces = mesh.face_count() - 1;
  EXPECT_EQ(decode(coded->bytes, options).error().code, ErrorCode::limit);
  options = {};
  options.limits.vertices = mesh.vertex_count - 1;
  EXPECT_EQ(decode(coded->bytes, options).error().code, ErrorCode::limit);
  options = {};
  options.limits.memory = 1;
  for (auto out = decode(coded->bytes, options); !out; out = decode(coded->bytes, options)) {
    ASSERT_EQ(out.error().code, ErrorCode::limit);
    ASSERT_EQ(out.error().limited, Limited::memory);
    ASSERT_GT(out.error().needed, *options.limits.memory);
    options.limits.memory = out.error().needed;
  }
  EXPECT_GE(*options.limits.memory, 12 * mesh.face_count() + 12 * mesh.vertex_count);
  --*options.limits.memory;
  const auto refused = decode(coded->bytes, options);
  EXPECT_EQ(refused.error().needed, *options.limits.memory + 1);
  EXPECT_EQ(refused.error().what, "the file needs " + std::to_string(refused.error().needed) +
                                      " bytes of memory, the limit is " +
                                      std::to_string(*options.limits.memory));
  options = {};
  options.limits.meshes = 0;
  EXPECT_EQ(decode(coded->bytes, options).error().code, ErrorCode::limit);
}

void expect_same_shape(const MeshShape& a, const MeshShape& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.isolated_vertices, b.isolated_vertices);
  EXPECT_EQ(a.degenerate_faces, b.degenerate_faces);
  EXPECT_EQ(a.duplicate_faces, b.duplicate_faces);
  EXPECT_EQ(a.nonmanifold_edges, b.nonmanifold_edges);
  EXPECT_EQ(a.nonmanifold_vertices, b.nonmanifold_vertices);
  EXPECT_EQ(a.surface.components, b.surface.components);
  EXPECT_EQ(a.surface.boundary_curves, b.surface.boundary_curves);
  EXPECT_EQ(a.surface.genus, b.surface.genus);
}

TEST(Inspect, EqualsWhatTheEncoderReports) {
  std::vector<Mesh> meshes = {corpus::punch_holes(corpus::torus(20, 12), 3, 1),
                              corpus::gyroid(1, 1, 1, 10, corpus::Ends::open),
                              corpus::chessboard(20), corpus::moebius_strip(30, 4),
                              corpus::random_soup(400, 300, 7, 2)};
  meshes[1].attributes.push_back(
      random_attribute("id", Domain::face, Scalar::uint16, 1, meshes[1].face_count(), 3));
  for (const Order order : {Order::free, Order::keep}) {
    EncodeOptions options;
    options.order = order;
    auto coded = encode(meshes, options);
    ASSERT_TRUE(coded.ok());
    auto info = inspect(coded->bytes);
    ASSERT_TRUE(info.ok());
    EXPECT_EQ(info->file.total_bytes, coded->bytes.size());
    EXPECT_EQ(info->file.level, default_level);
    ASSERT_EQ(info->meshes.size(), meshes.size());
    std::uint64_t sum = info->file.overhead_bytes;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      const MeshInfo& a = info->file.meshes[i];
      auto shape = measure(meshes[i]);
      ASSERT_TRUE(shape.ok());
      expect_same_shape(info->meshes[i].shape, *shape);
      expect_same_info(a, coded->report[i]);
      EXPECT_EQ(info->meshes[i].counts.symbols, coded->counts[i].symbols);
      EXPECT_EQ(info->meshes[i].counts.reversed_faces, coded->counts[i].reversed_faces);
      EXPECT_EQ(a.vertices, shape->vertices);
      EXPECT_EQ(a.faces, shape->faces);
      EXPECT_EQ(a.corners, meshes[i].corners.size());
      EXPECT_TRUE(!a.triangles_only || meshes[i].triangles_only());
      sum += a.connectivity_bytes + a.position_bytes + a.attribute_bytes;
    }
    EXPECT_EQ(sum, info->file.total_bytes);
  }
}

/// Every face twice, and a triangle folded onto an edge: all triangles, but not all on the surface.
TEST(DecodeInto, FacesThatAreNotOnTheSurface) {
  Mesh doubled = corpus::grid(20, 20);
  const std::vector<std::uint32_t> once = doubled.corners;
  doubled.corners.insert(doubled.corners.end(), once.begin(), once.end());
  Mesh folded = corpus::grid(20, 20);
  folded.corners.insert(folded.corners.end(), {once[0], once[0], once[1]});
  for (const Mesh& mesh : {doubled, folded})
    for (const int level : {1, 5, 9}) {
      EncodeOptions options;
      options.level = level;
      const auto coded = encode({&mesh, 1}, options);
      ASSERT_TRUE(coded.ok());
      const auto out = decode(coded->bytes);
      ASSERT_TRUE(out.ok());
      std::vector<std::uint32_t> corners(mesh.corners.size());
      const auto into = decode_into(coded->bytes, {.corners = corners});
      ASSERT_TRUE(into.ok()) << describe(into.error());
      EXPECT_EQ(corners, out->front().corners);
    }
}

/// A surface stays one however its faces are oriented, and costs little more.
TEST(Encode, RandomOrientationsKeepTheSurface) {
  Mesh mesh = corpus::grid(150, 150);
  std::mt19937 random(1);
  for (std::size_t h = 0; h < mesh.corners.size(); h += 3)
    if (random() % 2) std::swap(mesh.corners[h], mesh.corners[h + 1]);
  const auto coded = encode({&mesh, 1}, {});
  ASSERT_TRUE(coded.ok());
  EXPECT_EQ(coded->report[0].copied_vertices, 0u);
  EXPECT_LT(coded->bytes.size(), mesh.face_count() / 8 + 2000);  // a bit a face for the reversals
  round_trip({&mesh, 1});
}

}  // namespace
}  // namespace clers::internal

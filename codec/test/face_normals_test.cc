// Normals of faces come back, whatever faces there are, whole and alone; those that follow from the
// positions take next to nothing; no bytes do harm.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/file/container.h"
#include "codec/test/attribute.h"
#include "codec/test/decoding.h"
#include "codec/test/round_trip.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

using Vector = std::array<float, 3>;

/// The normal of a polygon: the sum of those of its triangles, each by its area.
Vector normal_of(std::span<const Vector> places, std::span<const std::uint32_t> face) {
  std::array<double, 3> sum = {};
  for (std::size_t k = 2; k < face.size(); ++k) {
    std::array<double, 3> e, f;
    for (std::size_t i = 0; i < 3; ++i) {
      e[i] = double(places[face[k - 1]][i]) - places[face[0]][i];
      f[i] = double(places[face[k]][i]) - places[face[0]][i];
    }
    for (std::size_t i = 0; i < 3; ++i)
      sum[i] += e[(i + 1) % 3] * f[(i + 2) % 3] - e[(i + 2) % 3] * f[(i + 1) % 3];
  }
  const double length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  Vector normal = {0, 0, 1};
  for (std::size_t i = 0; i < 3 && length > 0; ++i) normal[i] = static_cast<float>(sum[i] / length);
  return normal;
}

/// Rough places, and the normals of all faces.
Mesh with_normals(Mesh mesh) {
  corpus::Random random(1);
  std::vector<Vector> places(mesh.vertex_count), normals;
  for (Vector& place : places)
    for (float& x : place) x = static_cast<float>(random.below(1 << 16)) / 256;
  std::size_t begin = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::size_t size = size_of_face(mesh, f);
    normals.push_back(normal_of(places, std::span(mesh.corners).subspan(begin, size)));
    begin += size;
  }
  mesh.attributes = {test::attribute("position", Domain::vertex, Scalar::float32, 3, places),
                     test::attribute("normal", Domain::face, Scalar::float32, 3, normals)};
  return mesh;
}

/// Triangles of which two make a quad, three a pentagon.
Mesh polygons() {
  Mesh mesh;
  const std::uint32_t n = 20;
  mesh.vertex_count = (n + 1) * (n + 1);
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j, b = a + 1, c = b + n + 1, d = a + n + 1;
      if ((i + j) % 3 == 0) {
        mesh.face_sizes.insert(mesh.face_sizes.end(), {3, 3});
        mesh.corners.insert(mesh.corners.end(), {a, b, c, a, c, d});
      } else {
        mesh.face_sizes.push_back(4);
        mesh.corners.insert(mesh.corners.end(), {a, b, c, d});
      }
    }
  return mesh;
}

const AttributeInfo& info_of(const Encoded& encoded) {
  return encoded.report[0].attributes[1];
}

void expect_normals_come_back(const Mesh& mesh, const EncodeOptions& options) {
  const auto encoded = encode(mesh, options);
  ASSERT_TRUE(encoded.ok()) << describe(encoded.error());
  for (const unsigned threads : {1u, 3u}) {
    DecodeOptions decoding;
    decoding.threads = threads;
    const auto decoded = decode(encoded->bytes, decoding);
    ASSERT_TRUE(decoded.ok()) << describe(decoded.error());
    expect_permuted(mesh, (*decoded)[0], encoded->permutations[0]);
    const Attribute& a = (*decoded)[0].attributes[1];
    std::vector<std::byte> data(a.data.size());
    const AttributeTarget target{a.name, a.domain, a.scalar, a.components, data};
    const auto ok = test::decode_into(encoded->bytes, {.attributes = std::span(&target, 1)});
    ASSERT_TRUE(ok.ok()) << describe(ok.error());
    EXPECT_EQ(data, a.data);
  }
}

TEST(FaceNormals, ComeBack) {
  Mesh turned = corpus::torus(20, 16);
  for (std::size_t f = 0; f < turned.face_count(); f += 3)
    std::swap(turned.corners[3 * f], turned.corners[3 * f + 1]);
  Mesh degenerate = polygons();
  degenerate.face_sizes.insert(degenerate.face_sizes.end(), {2, 1, 0});
  degenerate.corners.insert(degenerate.corners.end(), {4, 5, 6});
  for (const Mesh& mesh :
       {corpus::punch_holes(corpus::torus(24, 18), 6, 1), turned, polygons(), degenerate,
        corpus::chessboard(12), corpus::random_soup(60, 200, 5, 1),
        corpus::random_soup(400, 200, 7, 2), corpus::loose_triangles(60), Mesh{}})
    for (const int level : {3, 5, 9}) {
      EncodeOptions options;
      options.level = level;
      expect_normals_come_back(with_normals(mesh), options);
      if (level != 5) continue;
      options.order = Order::keep;
      options.piece_faces = 150;
      expect_normals_come_back(with_normals(mesh), options);
    }
}

TEST(FaceNormals, FollowFromPositions) {
  for (const Mesh& mesh : {with_normals(corpus::torus(30, 20)), with_normals(polygons())})
    for (const bool quantised : {false, true}) {
      EncodeOptions options;
      if (quantised) options.precisions = {{"normal", Precision::of_directions(12)}};
      const auto encoded = encode(mesh, options);
      ASSERT_TRUE(encoded.ok()) << describe(encoded.error());
      EXPECT_EQ(info_of(*encoded).coder, "normals");
      EXPECT_LT(8 * info_of(*encoded).bytes, 3 * mesh.face_count());
    }
}

TEST(FaceNormals, NoBytesHarm) {
  corpus::Random random(2);
  Mesh mesh = with_normals(polygons());
  for (std::size_t i = 0; i < mesh.attributes[1].data.size(); i += 40)
    mesh.attributes[1].data[i] ^= std::byte(5);
  const auto encoded = encode(mesh);
  ASSERT_TRUE(encoded.ok());
  ASSERT_EQ(info_of(*encoded).coder, "normals");
  for (unsigned i = 0; i < 300; ++i) {
    ContainerReader in(encoded->bytes);
    ASSERT_TRUE(in.open().ok());
    ContainerWriter out(5);
    for (;;) {
      const auto section = in.next();
      ASSERT_TRUE(section.ok());
      if (section->kind == SectionKind::end) break;
      Bytes payload(section->payload.begin(), section->payload.end());
      const auto size = static_cast<std::uint32_t>(payload.size());
      if (section->kind == SectionKind::attribute && random.chance(60)) {
        if (random.chance(10))
          payload.resize(random.below(size));
        else
          payload[random.below(random.chance(50) ? std::min(size, 40u) : size)] ^=
              static_cast<std::byte>(1 + random.below(255));
      }
      out.section(section->kind, payload);
    }
    const auto decoded = decode(out.finish(1));
    if (!decoded) continue;
    for (const Attribute& a : (*decoded)[0].attributes)
      EXPECT_EQ(a.data.size(), a.stride() * (*decoded)[0].value_count(a.domain));
  }
}

}  // namespace
}  // namespace clers::internal

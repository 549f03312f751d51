// What we make of Draco's files has the triangles and values that Draco's own decoder has.
#include "codec/draco/draco.h"

#include <draco/compression/decode.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "codec/draco/test/draco_files.h"
#include <clers/encode.h>

namespace clers {
namespace {

using draco_test::Bytes;
using draco_test::encode;
using draco_test::How;
using draco_test::make_points;
using draco_test::make_tube;

/// What corners of a triangle have, all values one after the other; the least of the three ways.
using Triangle = std::vector<std::string>;

Triangle turned(Triangle t) {
  Triangle least = t;
  for (int i = 0; i < 2; ++i) {
    std::rotate(t.begin(), t.begin() + 1, t.end());
    least = std::min(least, t);
  }
  return least;
}

std::vector<Triangle> triangles_of(const Mesh& mesh) {
  std::vector<Triangle> all;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    Triangle t(3);
    for (const Attribute& a : mesh.attributes)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t element = a.domain == Domain::vertex   ? mesh.corners[3 * f + k]
                                    : a.domain == Domain::corner ? 3 * f + k
                                                                 : f;
        const std::size_t value = a.indices.empty() ? element : a.indices[element];
        t[k].append(reinterpret_cast<const char*>(a.data.data()) + value * a.stride(), a.stride());
      }
    all.push_back(turned(std::move(t)));
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::string values_at(const ::draco::PointCloud& points, ::draco::PointIndex p) {
  std::string values;
  for (std::int32_t i = 0; i < points.num_attributes(); ++i) {
    std::string one(std::size_t(points.attribute(i)->byte_stride()), '\0');
    points.attribute(i)->GetMappedValue(p, one.data());
    values += one;
  }
  return values;
}

std::vector<Triangle> triangles_of(const ::draco::Mesh& mesh) {
  std::vector<Triangle> all;
  for (::draco::FaceIndex f(0); f < mesh.num_faces(); ++f) {
    Triangle t;
    for (const ::draco::PointIndex& p : mesh.face(f)) t.push_back(values_at(mesh, p));
    all.push_back(turned(std::move(t)));
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::unique_ptr<::draco::Mesh> decoded_by_draco(const Bytes& bytes) {
  ::draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return ::draco::Decoder().DecodeMeshFromBuffer(&buffer).value();
}

const Attribute& attribute(const Mesh& mesh, const std::string& name) {
  for (const Attribute& a : mesh.attributes)
    if (a.name == name) return a;
  throw std::runtime_error("no " + name);
}

std::string metadata(const Mesh& mesh, const std::string& key) {
  for (const MetadataEntry& e : mesh.metadata)
    if (e.key == key) return e.value;
  return "(none)";
}

TEST(Draco, TrianglesAreThoseThatDracoDecodes) {
  const auto tube = make_tube(12);
  for (const int method : {::draco::MESH_SEQUENTIAL_ENCODING, ::draco::MESH_EDGEBREAKER_ENCODING})
    for (const int bits : {0, 8, 14})
      for (int speed = 0; speed <= 10; ++speed) {
        SCOPED_TRACE(std::to_string(method) + " " + std::to_string(bits) + " " +
                     std::to_string(speed));
        const Bytes bytes = encode(*tube, How{method, speed, bits});
        const auto read = draco::read(bytes);
        ASSERT_TRUE(read) << read.error().what;
        EXPECT_EQ(triangles_of(read->mesh), triangles_of(*decoded_by_draco(bytes)));
        EXPECT_EQ(read->mesh.face_count(), 2u * 12 * 12);
      }
}

TEST(Draco, WhatIsSharedStaysShared) {
  const std::uint32_t n = 12;
  const auto read = draco::read(encode(*make_tube(int(n)), How{}));
  ASSERT_TRUE(read) << read.error().what;
  const Mesh& mesh = read->mesh;
  EXPECT_EQ(mesh.vertex_count, n * (n + 1));  // without the seam
  EXPECT_TRUE(attribute(mesh, "position").indices.empty());
  EXPECT_EQ(attribute(mesh, "normal").domain, Domain::vertex);
  EXPECT_EQ(attribute(mesh, "texcoord").domain, Domain::corner);
  EXPECT_EQ(attribute(mesh, "texcoord").value_count(), (n + 1) * (n + 1));
  EXPECT_EQ(attribute(mesh, "texcoord").indices.size(), mesh.corners.size());
  EXPECT_EQ(attribute(mesh, "color").domain, Domain::vertex);
  EXPECT_EQ(attribute(mesh, "color").scalar, Scalar::uint8);
  EXPECT_EQ(attribute(mesh, "material").domain, Domain::face);
  EXPECT_EQ(attribute(mesh, "material").scalar, Scalar::int16);
  EXPECT_EQ(attribute(mesh, "heat").domain, Domain::vertex);
  EXPECT_EQ(attribute(mesh, "heat").scalar, Scalar::uint32);
}

TEST(Draco, MetadataAndBitsAreSaid) {
  const auto read = draco::read(encode(*make_tube(6), How{}));
  ASSERT_TRUE(read) << read.error().what;
  EXPECT_EQ(metadata(read->mesh, "draco.attributes"),
            "position: POSITION 0 11 bits\nnormal: NORMAL 1 11 bits\ntexcoord: TEX_COORD 2 11 "
            "bits\ncolor: COLOR 3 normalized\nmaterial: GENERIC 4\nheat: GENERIC 5");
  EXPECT_EQ(metadata(read->mesh, "draco.heat.name"), "heat");
  EXPECT_EQ(metadata(read->mesh, "draco.answer"), std::string("\x2a\0\0\0", 4));
  EXPECT_EQ(metadata(read->mesh, "draco.more.maker"), "a test");
  ASSERT_EQ(read->notes.size(), 2u);
  EXPECT_EQ(read->notes[0],
            "Draco has quantised position to 11 bits, normal to 11 bits, texcoord to 11 bits: what "
            "values were before is lost");
  EXPECT_NE(read->notes[1].find("degenerate"), std::string::npos);
  const auto plain =
      draco::read(encode(*make_tube(6), How{::draco::MESH_SEQUENTIAL_ENCODING, 3, 0}));
  ASSERT_TRUE(plain);
  EXPECT_TRUE(plain->notes.empty());
}

TEST(Draco, PointsAreAMeshWithoutFaces) {
  const std::uint32_t n = 200;
  for (const int method :
       {::draco::POINT_CLOUD_SEQUENTIAL_ENCODING, ::draco::POINT_CLOUD_KD_TREE_ENCODING}) {
    const Bytes bytes = encode(*make_points(n), How{method, 3, 12});
    const auto read = draco::read(bytes);
    ASSERT_TRUE(read) << read.error().what;
    const Mesh& mesh = read->mesh;
    EXPECT_EQ(mesh.vertex_count, n);
    EXPECT_EQ(mesh.face_count(), 0u);
    EXPECT_EQ(read->notes.back(), "200 points became a mesh without faces");
    ::draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto oracle = ::draco::Decoder().DecodePointCloudFromBuffer(&buffer).value();
    for (std::uint32_t v = 0; v < n; ++v) {
      std::string values;
      for (const Attribute& a : mesh.attributes) {
        ASSERT_TRUE(a.indices.empty());
        values.append(reinterpret_cast<const char*>(a.data.data()) + v * a.stride(), a.stride());
      }
      ASSERT_EQ(values, values_at(*oracle, ::draco::PointIndex(v)));
    }
    EXPECT_TRUE(clers::encode(mesh));
  }
}

TEST(Draco, LimitsAreAskedFirst) {
  const Bytes bytes = encode(*make_tube(12), How{});
  Limits limits;
  limits.faces = 287;
  EXPECT_EQ(draco::read(bytes, limits).error().limited, Limited::faces);
  limits.faces = 288;
  EXPECT_TRUE(draco::read(bytes, limits));
  limits.vertices = 100;
  EXPECT_EQ(draco::read(bytes, limits).error().limited, Limited::vertices);
  for (const int method : {0, 1}) {
    Limits little;
    little.memory = 1000;
    EXPECT_EQ(draco::read(encode(*make_tube(6), How{method}), little).error().limited,
              Limited::memory);
    EXPECT_EQ(draco::read(encode(*make_points(300), How{method}), little).error().limited,
              Limited::memory);
  }
}

TEST(Draco, HeadersThatAskForMuchAreRefused) {
  // Sequential, version 2.2, no metadata: a thousand million faces of as many points.
  const unsigned char header[] = {'D',  'R',  'A',  'C',  'O',  2,    2,    1,    0,    0,    0,
                                  0x80, 0x94, 0xeb, 0xdc, 0x03, 0x80, 0x94, 0xeb, 0xdc, 0x03, 0};
  const auto read = draco::read(std::as_bytes(std::span(header)));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().limited, Limited::memory);
}

TEST(Draco, OtherBytesAreNamed) {
  EXPECT_EQ(draco::read({}).error().code, ErrorCode::malformed);
  const std::string text = "ply\nformat ascii 1.0\n";
  EXPECT_EQ(draco::read(std::as_bytes(std::span(text))).error().code, ErrorCode::malformed);
  Bytes later = encode(*make_tube(3), How{});
  later[8] = std::byte{7};
  EXPECT_EQ(draco::read(later).error().code, ErrorCode::unsupported);
  later[8] = std::byte{1};
  later.push_back(std::byte{9});
  const auto longer = draco::read(later);
  ASSERT_TRUE(longer);
  EXPECT_EQ(longer->notes.back(), "1 byte behind the mesh left out");
}

/// Anything gives an error or a mesh that can be encoded.
void take_any(const Bytes& bytes) {
  Limits limits;
  limits.memory = 1'000'000;
  const auto read = draco::read(bytes, limits);
  if (!read) {
    EXPECT_FALSE(read.error().what.empty());
    return;
  }
  EncodeOptions quick;
  quick.level = 1;
  EXPECT_TRUE(clers::encode(read->mesh, quick));
}

TEST(Draco, TruncatedBytesAreErrorsOrMeshes) {
  for (const int method : {0, 1})
    for (const int bits : {0, 10}) {
      const Bytes bytes = encode(*make_tube(5), How{method, 0, bits});
      for (std::size_t size = 0; size < bytes.size(); size += 3)
        EXPECT_FALSE(draco::read(std::span(bytes).first(size))) << size;
      const Bytes points = encode(*make_points(40), How{method, 0, 12});
      for (std::size_t size = 0; size < points.size(); size += 3)
        take_any(Bytes(points.begin(), points.begin() + std::ptrdiff_t(size)));
    }
}

TEST(Draco, FlippedBytesAreErrorsOrMeshes) {
  for (const int method : {0, 1})
    for (const int speed : {0, 10}) {
      const Bytes bytes = encode(*make_tube(3), How{method, speed, 10});
      for (std::size_t i = 0; i < bytes.size(); i += 2)
        for (const unsigned mask : {0x01u, 0x80u}) {
          Bytes flipped = bytes;
          flipped[i] ^= static_cast<std::byte>(mask);
          take_any(flipped);
        }
    }
}

}  // namespace
}  // namespace clers

// Files of Draco's, made by its encoder.
#ifndef CLERS_CODEC_DRACO_TEST_DRACO_FILES_H
#define CLERS_CODEC_DRACO_TEST_DRACO_FILES_H

#include <draco/compression/expert_encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <draco/point_cloud/point_cloud_builder.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

namespace clers::draco_test {

using Bytes = std::vector<std::byte>;

struct How {
  int method = ::draco::MESH_EDGEBREAKER_ENCODING;
  int speed = 3;
  int bits = 11;  ///< 0: not quantised
};

template <class Geometry>
Bytes encode(const Geometry& geometry, const How& how) {
  ::draco::ExpertEncoder encoder(geometry);
  encoder.SetEncodingMethod(how.method);
  encoder.SetSpeedOptions(how.speed, how.speed);
  for (std::int32_t i = 0; i < geometry.num_attributes() && how.bits > 0; ++i)
    if (geometry.attribute(i)->data_type() == ::draco::DT_FLOAT32)
      encoder.SetAttributeQuantization(i, how.bits);
  ::draco::EncoderBuffer buffer;
  if (!encoder.EncodeToBuffer(&buffer).ok()) throw std::runtime_error("Draco encodes nothing");
  const auto bytes = std::as_bytes(std::span(buffer.data(), buffer.size()));
  return Bytes(bytes.begin(), bytes.end());
}

/// Attributes of make_tube(), by their places.
enum : std::int32_t { position, normal, texcoord, color, material, heat };

/// A tube of n x n squares, cut along a seam of its texture, with a number for each face,
/// "material", and one for each vertex, "heat".
inline std::unique_ptr<::draco::Mesh> make_tube(int n) {
  using ::draco::GeometryAttribute;
  ::draco::TriangleSoupMeshBuilder builder;
  builder.Start(2 * n * n);
  builder.AddAttribute(GeometryAttribute::POSITION, 3, ::draco::DT_FLOAT32);
  builder.AddAttribute(GeometryAttribute::NORMAL, 3, ::draco::DT_FLOAT32);
  builder.AddAttribute(GeometryAttribute::TEX_COORD, 2, ::draco::DT_FLOAT32);
  builder.AddAttribute(GeometryAttribute::COLOR, 4, ::draco::DT_UINT8, true);
  builder.AddAttribute(GeometryAttribute::GENERIC, 1, ::draco::DT_INT16);
  builder.AddAttribute(GeometryAttribute::GENERIC, 1, ::draco::DT_UINT32);
  for (const auto& [id, name] : {std::pair(material, "material"), std::pair(heat, "heat")}) {
    auto metadata = std::make_unique<::draco::AttributeMetadata>();
    metadata->AddEntryString("name", name);
    builder.AddAttributeMetadata(id, std::move(metadata));
  }
  auto metadata = std::make_unique<::draco::Metadata>();
  metadata->AddEntryString("maker", "a test");
  auto of_mesh = std::make_unique<::draco::GeometryMetadata>();
  of_mesh->AddEntryInt("answer", 42);
  of_mesh->AddSubMetadata("more", std::move(metadata));
  for (int face = 0; face < 2 * n * n; ++face) {
    const int i = face / 2 % n, j = face / 2 / n;
    const std::array<std::array<int, 2>, 3> corners =
        face % 2 == 0 ? std::array<std::array<int, 2>, 3>{{{i, j}, {i + 1, j}, {i + 1, j + 1}}}
                      : std::array<std::array<int, 2>, 3>{{{i, j}, {i + 1, j + 1}, {i, j + 1}}};
    std::array<std::array<float, 3>, 3> at, out;
    std::array<std::array<float, 2>, 3> uv;
    std::array<std::array<std::uint8_t, 4>, 3> rgba;
    std::array<std::uint32_t, 3> heats;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [x, y] = corners[k];
      const double angle = 6.283185307179586 * (x % n) / n;
      out[k] = {float(std::cos(angle)), float(std::sin(angle)), 0};
      at[k] = {out[k][0], out[k][1], float(y) * 0.3f};
      uv[k] = {float(x) / float(n), float(y) / float(n)};
      rgba[k] = {std::uint8_t(10 * (x % n)), std::uint8_t(7 * y), 3, 255};
      heats[k] = std::uint32_t(x % n + 1000 * y);
    }
    const ::draco::FaceIndex f{std::uint32_t(face)};
    builder.SetAttributeValuesForFace(position, f, &at[0], &at[1], &at[2]);
    builder.SetAttributeValuesForFace(normal, f, &out[0], &out[1], &out[2]);
    builder.SetAttributeValuesForFace(texcoord, f, &uv[0], &uv[1], &uv[2]);
    builder.SetAttributeValuesForFace(color, f, &rgba[0], &rgba[1], &rgba[2]);
    const auto number = static_cast<std::int16_t>(face / 7 - 3);
    builder.SetPerFaceAttributeValueForFace(material, f, &number);
    builder.SetAttributeValuesForFace(heat, f, &heats[0], &heats[1], &heats[2]);
  }
  auto mesh = builder.Finalize();
  if (mesh->metadata() != nullptr) {  // what attributes say is there
    mesh->metadata()->AddEntryInt("answer", 42);
    mesh->metadata()->AddSubMetadata(
        "more", std::make_unique<::draco::Metadata>(*of_mesh->GetSubMetadata("more")));
  }
  return mesh;
}

/// Points on a screw, each with its number.
inline std::unique_ptr<::draco::PointCloud> make_points(std::uint32_t n) {
  ::draco::PointCloudBuilder builder;
  builder.Start(n);
  const int at = builder.AddAttribute(::draco::GeometryAttribute::POSITION, 3, ::draco::DT_FLOAT32),
            number =
                builder.AddAttribute(::draco::GeometryAttribute::GENERIC, 1, ::draco::DT_UINT32);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::array<float, 3> xyz = {std::cos(float(i)), std::sin(float(i)), float(i) * 0.01f};
    builder.SetAttributeValueForPoint(at, ::draco::PointIndex(i), xyz.data());
    builder.SetAttributeValueForPoint(number, ::draco::PointIndex(i), &i);
  }
  return builder.Finalize(false);
}

}  // namespace clers::draco_test

#endif

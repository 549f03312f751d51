// EXT_meshopt_compression becomes plain views.
#include "codec/gltf/gltf.h"

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <cstring>
#include <string>

#include "codec/meshopt/meshopt.h"

namespace clers {
namespace {

using Bytes = std::vector<std::byte>;

const gltf::Decoders decoders{{}, meshopt::decode_for_gltf};

/// A strip of triangles, its values compressed and its indices too, and a buffer that stands for
/// both.
class MeshoptInGltf : public ::testing::Test {
 protected:
  static constexpr unsigned n = 20;

  MeshoptInGltf() {
    for (unsigned v = 0; v < 2 * n; ++v)
      for (const float x : {float(v / 2), float(v % 2), float(v * v)}) positions.push_back(x);
    for (std::uint32_t v = 0; v + 3 < 2 * n; v += 2)
      for (const std::uint32_t i : {v, v + 1, v + 2, v + 2, v + 1, v + 3}) indices.push_back(i);
    Bytes values(4000), triangles(4000);
    values.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(values.data()),
                                             values.size(), positions.data(), 2 * n, 12));
    triangles.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(triangles.data()),
                                               triangles.size(), indices.data(), indices.size()));
    binary = values;
    binary.resize((binary.size() + 3) / 4 * 4);
    const std::size_t second = binary.size();
    binary.insert(binary.end(), triangles.begin(), triangles.end());
    const auto number = [](std::size_t i) { return std::to_string(i); };
    document =
        R"({"asset":{"version":"2.0"},"extensionsUsed":["EXT_meshopt_compression"],)"
        R"("extensionsRequired":["EXT_meshopt_compression"],"buffers":[{"uri":"a.bin","byteLength":)" +
        number(binary.size()) + R"(},{"byteLength":4000,"extensions":{"EXT_meshopt_compression":)" +
        R"({"fallback":true}}}],"bufferViews":[{"buffer":1,"byteLength":)" + number(24 * n) +
        R"(,"byteStride":12,"target":34962,"extensions":{"EXT_meshopt_compression":{"buffer":0,)" +
        R"("byteLength":)" + number(values.size()) + R"(,"byteStride":12,"count":)" +
        number(2 * n) + R"(,"mode":"ATTRIBUTES"}}},{"buffer":1,"byteOffset":1000,"byteLength":)" +
        number(2 * indices.size()) +
        R"(,"target":34963,"extensions":{"EXT_meshopt_compression":{"buffer":0,"byteOffset":)" +
        number(second) + R"(,"byteLength":)" + number(triangles.size()) +
        R"(,"byteStride":2,"count":)" + number(indices.size()) +
        R"(,"mode":"TRIANGLES"}}}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" +
        number(2 * n) + R"(,"type":"VEC3"},{"bufferView":1,"componentType":5123,"count":)" +
        number(indices.size()) +
        R"(,"type":"SCALAR"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}]})";
  }

  Expected<gltf::ReadResult> read(const std::string& from = "", const std::string& to = "",
                                  const gltf::Decoders& how = decoders) const {
    std::string text = document;
    if (!from.empty()) text.replace(text.find(from), from.size(), to);
    return gltf::read(
        std::as_bytes(std::span(text)),
        [&](const std::string&) -> Expected<Bytes> { return binary; }, how);
  }

  std::vector<float> positions;
  std::vector<std::uint32_t> indices;
  Bytes binary;
  std::string document;
};

TEST_F(MeshoptInGltf, BecomesPlainViews) {
  const auto scene = read();
  ASSERT_TRUE(scene) << scene.error().what;
  ASSERT_EQ(scene->scene.meshes.size(), 1u);
  const Mesh& mesh = scene->scene.meshes[0];
  EXPECT_EQ(mesh.vertex_count, 2 * n);
  ASSERT_EQ(mesh.attributes.size(), 1u);
  ASSERT_EQ(mesh.attributes[0].data.size(), positions.size() * 4);
  EXPECT_EQ(std::memcmp(mesh.attributes[0].data.data(), positions.data(), positions.size() * 4), 0);
  EXPECT_EQ(mesh.corners.size(), indices.size());
  ASSERT_EQ(scene->remarks.size(), 1u);
  EXPECT_EQ(scene->remarks[0], "EXT_meshopt_compression: 2 bufferViews were decoded");
  EXPECT_EQ(scene->scene.document.find("meshopt"), std::string::npos);
  for (const Blob& blob : scene->scene.blobs) EXPECT_LT(blob.bytes.size(), 8u);

  const auto written = gltf::write(scene->scene, {gltf::Form::gltf, "", true});
  ASSERT_TRUE(written) << written.error().what;
  const std::string text(reinterpret_cast<const char*>(written->bytes.data()),
                         written->bytes.size());
  EXPECT_EQ(text.find("4000"), text.npos);  // the buffer that stood for the views is gone
  const auto again = gltf::read(written->bytes, {});
  ASSERT_TRUE(again) << again.error().what;
  EXPECT_EQ(again->scene.meshes[0].corners, mesh.corners);
}

TEST_F(MeshoptInGltf, StaysWithoutADecoder) {
  const auto scene = read("", "", {});
  ASSERT_TRUE(scene) << scene.error().what;
  ASSERT_EQ(scene->remarks.size(), 1u);
  EXPECT_NE(scene->scene.document.find("meshopt"), std::string::npos);
}

TEST_F(MeshoptInGltf, MistakesAreNamed) {
  const std::array<std::string, 3> mistakes[] = {
      {R"("mode":"TRIANGLES")", R"("mode":"ATTRIBUTES")", "byteStride 2"},
      {R"("byteStride":2)", R"("byteStride":4)", "count * byteStride"},
      {R"("byteStride":12,"count")", R"("byteStride":0,"count")", "count * byteStride"},
      {R"({"buffer":0,)", R"({"buffer":9,)", "no such buffer"},
      {R"({"buffer":0,)", R"({"buffer":1,)", "beyond the end"},
  };
  for (const auto& [from, to, what] : mistakes) {
    const auto scene = read(from, to);
    ASSERT_FALSE(scene) << to;
    EXPECT_NE(scene.error().what.find(what), std::string::npos) << scene.error().what;
    EXPECT_EQ(scene.error().code, ErrorCode::malformed);
  }
}

}  // namespace
}  // namespace clers

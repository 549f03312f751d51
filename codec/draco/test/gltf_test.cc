// KHR_draco_mesh_compression becomes plain accessors.
#include "codec/gltf/gltf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "codec/draco/draco.h"
#include "codec/draco/test/draco_files.h"

namespace clers {
namespace {

using draco_test::Bytes;

const gltf::Decoders decoders{draco::decode_for_gltf, {}};

/// What stands for a word in a document.
struct Edit {
  std::string from, to;
};

std::string edited(std::string text, const std::vector<Edit>& edits) {
  for (const Edit& e : edits) {
    const std::size_t at = text.find(e.from);
    if (at == text.npos) throw std::runtime_error("no " + e.from);
    text.replace(at, e.from.size(), e.to);
  }
  return text;
}

bool holds_draco(const Scene& scene) {
  const auto magic = std::as_bytes(std::span("DRACO", 5));
  return std::any_of(scene.blobs.begin(), scene.blobs.end(), [&](const Blob& b) {
    return std::search(b.bytes.begin(), b.bytes.end(), magic.begin(), magic.end()) != b.bytes.end();
  });
}

/// A tube in a scene, and a morph target that Draco does not have.
class DracoInGltf : public ::testing::Test {
 protected:
  DracoInGltf() {
    drc = draco_test::encode(*draco_test::make_tube(6), {});
    plain = *draco::decode_for_gltf(drc);
    binary.assign(4, std::byte{5});
    binary.insert(binary.end(), drc.begin(), drc.end());
    binary.resize((binary.size() + 3) / 4 * 4);
    const std::size_t morph = binary.size();
    for (std::size_t i = 0; i < std::size_t(plain.vertex_count) * 12; ++i)
      binary.push_back(static_cast<std::byte>(i % 64));
    const std::string n = std::to_string(plain.vertex_count);
    const auto accessor = [&](int type, const char* shape) {
      return R"({"componentType":)" + std::to_string(type) + R"(,"count":)" + n + R"(,"type":")" +
             shape + R"("},)";
    };
    document =
        R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_draco_mesh_compression","KHR_more"],)"
        R"("extensionsRequired":["KHR_draco_mesh_compression"],"buffers":[{"uri":"a.bin","byteLength":)" +
        std::to_string(binary.size()) +
        R"(}],"bufferViews":[{"buffer":0,"byteOffset":4,"byteLength":)" +
        std::to_string(drc.size()) + R"(},{"buffer":0,"byteOffset":)" + std::to_string(morph) +
        R"(,"byteLength":)" + std::to_string(plain.vertex_count * 12) + R"(}],"accessors":[)" +
        accessor(5126, "VEC3") + accessor(5126, "VEC3") + accessor(5126, "VEC2") +
        accessor(5121, "VEC4") + accessor(5123, "SCALAR") +
        R"({"componentType":5123,"count":999,"type":"SCALAR"},{"bufferView":1,"componentType":5126,"count":)" +
        n + R"(,"type":"VEC3"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,)" +
        R"("TEXCOORD_0":2,"COLOR_0":3,"_HEAT":4},"indices":5,"mode":4,"targets":[{"POSITION":6}],)" +
        R"("extensions":{"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{"POSITION":0,)" +
        R"("NORMAL":1,"TEXCOORD_0":2,"COLOR_0":3,"_HEAT":5}}}}]}]})";
  }

  Expected<gltf::ReadResult> read(const std::vector<Edit>& edits = {},
                                  const gltf::Decoders& how = decoders) const {
    const std::string text = edited(document, edits);
    return gltf::read(
        std::as_bytes(std::span(text)),
        [&](const std::string&) -> Expected<Bytes> { return binary; }, how);
  }
  const Attribute& of_draco(const std::string& id) const {
    return *std::find_if(plain.attributes.begin(), plain.attributes.end(),
                         [&](const Attribute& a) { return a.name == id; });
  }

  Bytes drc, binary;
  Mesh plain;
  std::string document;
};

TEST_F(DracoInGltf, BecomesPlainValues) {
  const auto scene = read();
  ASSERT_TRUE(scene) << scene.error().what;
  ASSERT_EQ(scene->scene.meshes.size(), 1u);
  const Mesh& mesh = scene->scene.meshes[0];
  EXPECT_EQ(mesh.vertex_count, plain.vertex_count);
  EXPECT_EQ(mesh.corners, plain.corners);
  ASSERT_EQ(mesh.attributes.size(), 6u);
  EXPECT_EQ(mesh.attributes[0].data, of_draco("0").data);
  EXPECT_EQ(mesh.attributes[1].data, of_draco("1").data);
  EXPECT_EQ(mesh.attributes[2].data, of_draco("2").data);
  EXPECT_EQ(mesh.attributes[3].data, of_draco("3").data);
  EXPECT_EQ(mesh.attributes[4].scalar, Scalar::uint16);  // as the accessor has it
  EXPECT_EQ(mesh.attributes[4].data.size() * 2, of_draco("5").data.size());
  EXPECT_EQ(mesh.attributes[5].data.size(), 12u * mesh.vertex_count);
  ASSERT_EQ(scene->remarks.size(), 1u);
  EXPECT_EQ(scene->remarks[0],
            "KHR_draco_mesh_compression of 1 primitive was decoded; what Draco quantised stays so: "
            "NORMAL 11 bits, POSITION 11 bits, TEXCOORD_0 11 bits");
  EXPECT_EQ(scene->scene.document.find("draco"), std::string::npos);
  EXPECT_NE(scene->scene.document.find("KHR_more"), std::string::npos);
  EXPECT_FALSE(holds_draco(scene->scene));

  // What is written is a glTF for everybody.
  const auto written = gltf::write(scene->scene);
  ASSERT_TRUE(written) << written.error().what;
  const auto again = gltf::read(written->bytes, {});
  ASSERT_TRUE(again) << again.error().what;
  EXPECT_TRUE(again->remarks.empty());
  EXPECT_EQ(again->scene.meshes[0].corners, mesh.corners);
}

TEST_F(DracoInGltf, StaysWithoutADecoder) {
  const auto scene = read({}, {});
  ASSERT_TRUE(scene) << scene.error().what;
  ASSERT_EQ(scene->remarks.size(), 1u);
  EXPECT_NE(scene->remarks[0].find("carried as it is"), std::string::npos);
  EXPECT_NE(scene->scene.document.find("KHR_draco"), std::string::npos);
  EXPECT_TRUE(holds_draco(scene->scene));
}

TEST_F(DracoInGltf, StripsBecomeTriangles) {
  const auto scene = read({{R"("mode":4)", R"("mode":5)"}});
  ASSERT_TRUE(scene) << scene.error().what;
  EXPECT_EQ(scene->scene.meshes[0].corners, plain.corners);
}

TEST_F(DracoInGltf, PlainValuesBesideItAreTaken) {
  // All accessors have a place: the one of the morph target.
  std::string all = document;
  for (std::size_t at; (at = all.find(R"({"componentType")")) != all.npos;)
    all.replace(at, 1, R"({"bufferView":1,)");
  document = edited(all, {{R"("count":999)", R"("count":3)"}});
  const auto scene = read();
  ASSERT_TRUE(scene) << scene.error().what;
  ASSERT_EQ(scene->remarks.size(), 1u);
  EXPECT_EQ(scene->remarks[0],
            "KHR_draco_mesh_compression of 1 primitive was decoded, 1 by the plain values beside "
            "it");
  EXPECT_FALSE(holds_draco(scene->scene));
}

TEST_F(DracoInGltf, MistakesAreNamed) {
  const std::string n = R"("count":)" + std::to_string(plain.vertex_count);
  const struct {
    Edit edit;
    const char* what;
  } mistakes[] = {
      {{R"("bufferView":0,"attributes")", R"("bufferView":7,"attributes")"}, "no such bufferView"},
      {{n, R"("count":5)"}, "values of 3 components"},
      {{R"("VEC2")", R"("VEC3")"}, "values of 2 components"},
      {{"5121", "5126"}, "are none of float32"},
      {{"5123", "5120"}, "are none of int8"},
      {{R"("_HEAT":5)", R"("_HEAT":9)"}, "no attribute has id 9"},
      {{R"("_HEAT":5)", R"("_COLD":5)"}, "_COLD is no attribute"},
      {{R"("mode":4)", R"("mode":6)"}, "mode 6"},
      {{R"("indices":5,)", ""}, "without indices"},
      {{R"("byteOffset":4)", R"("byteOffset":5)"}, "header of a Draco file"},
  };
  for (const auto& m : mistakes) {
    const auto scene = read({m.edit});
    ASSERT_FALSE(scene) << m.what;
    EXPECT_NE(scene.error().what.find(m.what), std::string::npos) << scene.error().what;
    EXPECT_EQ(scene.error().code, ErrorCode::malformed);
  }
}

}  // namespace
}  // namespace clers

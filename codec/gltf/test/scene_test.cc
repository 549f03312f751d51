#include <gtest/gtest.h>

#include <cstring>

#include "codec/gltf/uri.h"
#include <clers/decode.h>
#include <clers/encode.h>
#include <clers/gltf.h>

namespace clers {
namespace {

/// A grid with texture coordinates, lines on its vertices, a sparse morph target and an animation.
std::string small_gltf() {
  std::vector<float> positions, texture, moved = {0, 0, 1, 0, 0, 2};
  std::vector<std::uint16_t> triangles, lines = {0, 7, 7, 3, 3, 8};
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) {
      for (const int c : {x, y, x * y}) positions.push_back(static_cast<float>(c));
      for (const int c : {x, y}) texture.push_back(static_cast<float>(c) / 2);
    }
  for (const int v : {0, 1, 3, 4})
    for (const int c : {v, v + 1, v + 3, v + 1, v + 4, v + 3})
      triangles.push_back(static_cast<std::uint16_t>(c));
  const std::uint16_t at[] = {2, 5};
  const float times[] = {0, 1, 2};
  std::vector<std::byte> buffer;
  const auto put = [&](auto values) {
    const auto bytes = std::as_bytes(std::span(values));
    buffer.insert(buffer.end(), bytes.begin(), bytes.end());
  };
  put(std::span(positions));
  put(std::span(texture));
  put(std::span(triangles));
  put(std::span(lines));
  put(std::span(moved));
  put(std::span(at));
  put(std::span(times));
  return R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" + std::to_string(buffer.size()) +
         R"(,"uri":"data:;base64,)" + gltf::base64(buffer) +
         R"("}],"bufferViews":[{"buffer":0,"byteLength":108},{"buffer":0,"byteOffset":108,"byteLength":72},)"
         R"({"buffer":0,"byteOffset":180,"byteLength":48},{"buffer":0,"byteOffset":228,"byteLength":12},)"
         R"({"buffer":0,"byteOffset":240,"byteLength":24},{"buffer":0,"byteOffset":264,"byteLength":4},)"
         R"({"buffer":0,"byteOffset":268,"byteLength":12}],"accessors":[)"
         R"({"bufferView":0,"componentType":5126,"count":9,"type":"VEC3","min":[0,0,0],"max":[2,2,4]},)"
         R"({"bufferView":1,"componentType":5126,"count":9,"type":"VEC2"},)"
         R"({"bufferView":2,"componentType":5123,"count":24,"type":"SCALAR"},)"
         R"({"bufferView":3,"componentType":5123,"count":6,"type":"SCALAR"},)"
         R"({"componentType":5126,"count":9,"type":"VEC3","sparse":{"count":2,"indices":)"
         R"({"bufferView":5,"componentType":5123},"values":{"bufferView":4}}},)"
         R"({"bufferView":6,"componentType":5126,"count":3,"type":"SCALAR","min":[0],"max":[2.00]}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,)"
         R"("targets":[{"POSITION":4}]},{"attributes":{"POSITION":0},"indices":3,"mode":1}]}],)"
         R"("animations":[{"samplers":[{"input":5,"output":5}],"channels":[]}],"extras":1.50})";
}

gltf::ReadResult read(const std::string& text) {
  auto result = gltf::read(std::as_bytes(std::span(text)), {});
  EXPECT_TRUE(result) << describe(result.error());
  return result ? std::move(*result) : gltf::ReadResult{};
}

std::string written(const Scene& scene) {
  const auto result = gltf::write(scene, {gltf::Form::gltf});
  EXPECT_TRUE(result) << describe(result.error());
  if (!result) return {};
  return {reinterpret_cast<const char*>(result->bytes.data()), result->bytes.size()};
}

TEST(Gltf, IsReadAndWrittenAsItWas) {
  const std::string text = small_gltf();
  const gltf::ReadResult result = read(text);
  const Scene& scene = result.scene;
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].vertex_count, 9u);
  EXPECT_EQ(scene.meshes[0].face_count(), 8u);
  ASSERT_EQ(scene.meshes[0].attributes.size(), 2u);
  EXPECT_EQ(scene.meshes[0].attributes[0].name, "position");
  EXPECT_EQ(scene.meshes[0].attributes[1].name, "TEXCOORD_0");
  ASSERT_EQ(scene.arrays.size(), 4u);
  EXPECT_EQ(scene.arrays[0].name, "indices");
  EXPECT_EQ(scene.arrays[0].vertices_of, 0u);
  EXPECT_EQ(scene.arrays[1].name, "sparse indices");
  EXPECT_EQ(scene.arrays[1].vertices_of, 0u);
  EXPECT_EQ(scene.arrays[2].name, "sparse values");
  EXPECT_EQ(scene.arrays[3].name, "animation times");
  EXPECT_TRUE(scene.blobs.empty());
  EXPECT_EQ(gltf::form_of(scene), gltf::Form::gltf);
  EXPECT_EQ(written(scene), text);
}

// Positions that are sparse alone are in arrays; the mesh has none then, though a target has
// values.
TEST(Gltf, DisplacementsAreNoPositions) {
  std::string text = small_gltf();
  const auto swap = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  swap(R"({"POSITION":0,"TEXCOORD_0":1})", R"({"POSITION":4,"TEXCOORD_0":1})");
  swap(R"([{"POSITION":4}])", R"([{"POSITION":0}])");
  swap(R"({"attributes":{"POSITION":0},"indices":3)",
       R"({"attributes":{"POSITION":4},"indices":3)");
  const gltf::ReadResult result = read(text);
  ASSERT_EQ(result.scene.meshes.size(), 1u);
  EXPECT_EQ(result.scene.meshes[0].position(), nullptr);
  EXPECT_EQ(written(result.scene), text);
}

TEST(Gltf, ComesBackThroughAFile) {
  const std::string text = small_gltf();
  const gltf::ReadResult result = read(text);
  for (const int level : {1, 5}) {
    EncodeOptions options;
    options.level = level;
    const auto encoded = encode(result.scene, options, result.orders);
    ASSERT_TRUE(encoded) << describe(encoded.error());
    const auto decoded = decode_scene(encoded->bytes);
    ASSERT_TRUE(decoded) << describe(decoded.error());
    const std::string again = written(*decoded);
    EXPECT_EQ(again.size(), text.size());
    EXPECT_EQ(read(again).scene.document, result.scene.document);
    options.order = Order::keep;
    const auto kept = encode(result.scene, options);
    ASSERT_TRUE(kept);
    const auto in_order = decode_scene(kept->bytes);
    ASSERT_TRUE(in_order);
    EXPECT_EQ(written(*in_order), text);
  }
}

// Indices of points, and by another accessor values of others: who decodes the extension finds
// both.
TEST(Gltf, IndicesThatAreValuesTooAreNotLost) {
  std::string text = small_gltf();
  const auto put = [&](const std::string& before, const std::string& what) {
    text.insert(text.find(before), what);
  };
  const std::string six = R"("componentType":5123,"count":6,"type":"SCALAR")";
  text.replace(text.find(R"("indices":3)"), 11, R"("indices":2)");
  put(R"(],"meshes")", R"(,{"bufferView":3,)" + six + R"(},{"bufferView":2,)" + six + "}");
  put(R"(]}],"animations")",
      R"(,{"attributes":{"_ID":6},"mode":0},{"attributes":{"_X":7},"indices":3,"mode":0})");
  const gltf::ReadResult given = read(text);
  const auto within = gltf::write_compressed(given.scene, given.orders, {}, {gltf::Form::gltf});
  ASSERT_TRUE(within) << describe(within.error());
  const auto back = gltf::read(within->written.bytes, {});
  ASSERT_TRUE(back) << describe(back.error());
  const std::string plain = written(back->scene);
  std::size_t found = 0;
  for (std::size_t at = plain.find(six); at != std::string::npos; at = plain.find(six, at + 1)) {
    const std::size_t begin = plain.rfind('{', at);
    EXPECT_NE(plain.substr(begin, at - begin).find("bufferView"), std::string::npos);
    ++found;
  }
  EXPECT_EQ(found, 3u);
}

TEST(Gltf, BoundsAreTrueOfQuantisedValues) {
  const gltf::ReadResult result = read(small_gltf());
  EncodeOptions options;
  options.precisions = {{"position", Precision::of_step(0.75)}};
  const auto encoded = encode(result.scene, options, result.orders);
  ASSERT_TRUE(encoded);
  const auto decoded = decode_scene(encoded->bytes);
  ASSERT_TRUE(decoded);
  EXPECT_NE(written(*decoded).find(R"("min":[0,0,0],"max":[2.25,2.25,3.75])"), std::string::npos);
}

TEST(Gltf, RefusesAScenesOfAnotherDocument) {
  const gltf::ReadResult result = read(small_gltf());
  const auto refused = [](Scene scene, auto change) {
    change(scene);
    const auto outcome = gltf::write(scene);
    ASSERT_FALSE(outcome);
    EXPECT_TRUE(outcome.error().code == ErrorCode::inconsistent_mesh ||
                outcome.error().code == ErrorCode::malformed ||
                outcome.error().code == ErrorCode::unsupported)
        << describe(outcome.error());
  };
  refused(result.scene, [](Scene& s) { s.document.clear(); });
  refused(result.scene, [](Scene& s) { s.document = "{}"; });
  refused(result.scene, [](Scene& s) { s.document.resize(s.document.size() / 2); });
  refused(result.scene, [](Scene& s) { s.meshes.clear(); });
  refused(result.scene, [](Scene& s) { s.meshes[0].corners.resize(21); });
  refused(result.scene, [](Scene& s) { s.meshes[0].corners[5] = 9; });
  refused(result.scene, [](Scene& s) { s.meshes[0].vertex_count = 8; });
  refused(result.scene, [](Scene& s) { s.meshes[0].attributes[0].name = "POSITION"; });
  refused(result.scene, [](Scene& s) { s.meshes[0].attributes[1].data.pop_back(); });
  refused(result.scene, [](Scene& s) { s.arrays[0].data[0] = std::byte{9}; });
  refused(result.scene, [](Scene& s) { s.arrays[0].vertices_of.reset(); });
  refused(result.scene, [](Scene& s) { s.arrays.pop_back(); });
  refused(result.scene, [](Scene& s) {
    s.document.replace(s.document.find("\"byteLength\":null"), 17, "\"byteLength\":9e15");
  });
}

TEST(Gltf, FilesBesideIt) {
  std::string text = small_gltf();
  const std::size_t from = text.find("data:"), to = text.find('"', from);
  const auto buffer = *gltf::data_bytes(text.substr(from, to - from));
  text.replace(from, to - from, "sub%20folder/a.bin");
  text.insert(text.size() - 1,
              R"(,"images":[{"uri":"t.png"},{"uri":"../u.jpg"},{"uri":"gone.png"}])");
  const std::vector<std::byte> picture(5, std::byte{7});
  const gltf::Fetch fetch = [&](const std::string& path) -> Expected<std::vector<std::byte>> {
    if (path == "sub folder/a.bin") return buffer;
    if (path == "t.png" || path == "../u.jpg") return picture;
    return fail(ErrorCode::io_failed, path + " is not there");
  };
  const auto result = gltf::read(std::as_bytes(std::span(text)), fetch);
  ASSERT_TRUE(result) << describe(result.error());
  EXPECT_EQ(result->notes.size(), 1u);
  const auto as_gltf = gltf::write(result->scene, {gltf::Form::gltf});
  ASSERT_TRUE(as_gltf);
  ASSERT_EQ(as_gltf->files.size(), 2u);
  EXPECT_EQ(as_gltf->files[0].path, "t.png");
  EXPECT_EQ(as_gltf->files[0].bytes, picture);
  EXPECT_EQ(as_gltf->files[1].path, "sub folder/a.bin");
  EXPECT_EQ(as_gltf->files[1].bytes, buffer);
  const std::string json(reinterpret_cast<const char*>(as_gltf->bytes.data()),
                         as_gltf->bytes.size());
  EXPECT_EQ(json.find("../"), json.npos);  // nothing is written above
  EXPECT_NE(json.find("data:image/jpeg;base64,"), json.npos);
  const auto as_glb = gltf::write(result->scene, {gltf::Form::glb});
  ASSERT_TRUE(as_glb);
  EXPECT_EQ(as_glb->files.size(), 1u);
  const auto embedded = gltf::write(result->scene, {gltf::Form::gltf, "", true});
  ASSERT_TRUE(embedded);
  EXPECT_TRUE(embedded->files.empty());
}

}  // namespace
}  // namespace clers

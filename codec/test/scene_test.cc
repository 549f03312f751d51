// What a file holds besides meshes.
#include "codec/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numeric>

#include "codec/decode.h"
#include "codec/decoder.h"
#include "codec/encode.h"
#include "codec/inspect.h"
#include "codec/test/file_builder.h"

namespace clers {
namespace {

template <class T>
std::vector<std::byte> bytes_of(const std::vector<T>& values) {
  std::vector<std::byte> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

Mesh strip(std::uint32_t triangles) {
  Mesh mesh;
  mesh.vertex_count = triangles + 2;
  for (std::uint32_t t = 0; t < triangles; ++t)
    for (const std::uint32_t v : {t, t + 1 + t % 2, t + 2 - t % 2}) mesh.corners.push_back(v);
  std::vector<float> places;
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v)
    for (const float x : {static_cast<float>(v / 2), static_cast<float>(v % 2), 0.0f})
      places.push_back(x);
  mesh.attributes.push_back({position_name, Domain::vertex, Scalar::float32, 3, bytes_of(places)});
  return mesh;
}

Scene small_scene() {
  Scene scene;
  scene.meshes = {strip(40), strip(9)};
  std::vector<std::uint32_t> line(11);
  std::iota(line.begin(), line.end(), 0u);
  std::vector<double> times;
  for (int i = 0; i < 50; ++i) times.push_back(i / 24.0);
  scene.arrays = {{"line", Scalar::uint32, 1, bytes_of(line), 1},
                  {"times", Scalar::float64, 1, bytes_of(times)},
                  {"", Scalar::int8, 4, bytes_of(std::vector<std::int8_t>{1, 2, 3, 4})},
                  {"nothing", Scalar::float32, 16, {}}};
  scene.blobs = {{"picture", bytes_of(std::vector<std::uint8_t>{0x89, 0x50, 0x4e})},
                 {"zeros", std::vector<std::byte>(1000)},
                 {"", {}}};
  scene.document = "a document, a document, a document";
  scene.metadata = {{"source.format", "glb"}, {"empty", ""}};
  return scene;
}

std::vector<std::byte> encoded(const Scene& scene, const EncodeOptions& options = {},
                               std::span<const Order> orders = {}) {
  const auto result = encode(scene, options, orders);
  EXPECT_TRUE(result) << describe(result.error());
  return result ? result->bytes : std::vector<std::byte>();
}

void expect_same_besides_meshes(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.arrays.size(), b.arrays.size());
  for (std::size_t i = 0; i < a.arrays.size(); ++i) {
    EXPECT_EQ(a.arrays[i].name, b.arrays[i].name);
    EXPECT_EQ(a.arrays[i].scalar, b.arrays[i].scalar);
    EXPECT_EQ(a.arrays[i].components, b.arrays[i].components);
    EXPECT_EQ(a.arrays[i].vertices_of, b.arrays[i].vertices_of);
    if (!a.arrays[i].vertices_of) {
      EXPECT_EQ(a.arrays[i].data, b.arrays[i].data);
    }
  }
  ASSERT_EQ(a.blobs.size(), b.blobs.size());
  for (std::size_t i = 0; i < a.blobs.size(); ++i) {
    EXPECT_EQ(a.blobs[i].name, b.blobs[i].name);
    EXPECT_EQ(a.blobs[i].bytes, b.blobs[i].bytes);
  }
  EXPECT_EQ(a.document, b.document);
  ASSERT_EQ(a.metadata.size(), b.metadata.size());
  for (std::size_t i = 0; i < a.metadata.size(); ++i) {
    EXPECT_EQ(a.metadata[i].key, b.metadata[i].key);
    EXPECT_EQ(a.metadata[i].value, b.metadata[i].value);
  }
}

TEST(Scene, ComesBack) {
  const Scene scene = small_scene();
  for (const int level : {1, 5, 9}) {
    EncodeOptions options;
    options.level = level;
    const auto decoded = decode_scene(encoded(scene, options));
    ASSERT_TRUE(decoded) << describe(decoded.error());
    ASSERT_EQ(decoded->meshes.size(), 2u);
    expect_same_besides_meshes(scene, *decoded);
  }
}

TEST(Scene, ArraysFollowVertices) {
  const Scene scene = small_scene();
  const auto result = encode(scene);
  ASSERT_TRUE(result);
  const auto decoded = decode_scene(result->bytes);
  ASSERT_TRUE(decoded);
  for (std::size_t k = 0; k < 11; ++k) {
    std::uint32_t before = 0, after = 0;
    std::memcpy(&before, scene.arrays[0].data.data() + 4 * k, 4);
    std::memcpy(&after, decoded->arrays[0].data.data() + 4 * k, 4);
    EXPECT_EQ(result->permutations[1].vertices[after], before);
  }
}

TEST(Scene, OrdersAreOfMeshes) {
  const Scene scene = small_scene();
  const Order orders[] = {Order::free, Order::keep};
  const auto decoded = decode_scene(encoded(scene, {}, orders));
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->meshes[1].corners, scene.meshes[1].corners);
  EXPECT_NE(decoded->meshes[0].corners, scene.meshes[0].corners);
  EXPECT_EQ(decoded->arrays[0].data, scene.arrays[0].data);
  const auto one = encode(scene, {}, std::span(orders).first(1));
  ASSERT_FALSE(one);
  EXPECT_EQ(one.error().code, ErrorCode::bad_option);
}

TEST(Scene, NothingBesideMeshesTakesNothing) {
  Scene scene;
  scene.meshes = {strip(20)};
  const auto meshes = encode(std::span<const Mesh>(scene.meshes));
  ASSERT_TRUE(meshes);
  EXPECT_EQ(encoded(scene), meshes->bytes);
  EXPECT_TRUE(decode_scene(encoded({})));
}

TEST(Scene, MeshesDecodeAlone) {
  const auto bytes = encoded(small_scene());
  const auto meshes = decode(bytes);
  ASSERT_TRUE(meshes);
  EXPECT_EQ(meshes->size(), 2u);
  EXPECT_TRUE((*meshes)[0].metadata.empty());
}

TEST(Scene, IsDescribed) {
  const Scene scene = small_scene();
  const auto result = encode(scene);
  ASSERT_TRUE(result);
  const auto decoder = Decoder::open(result->bytes);
  ASSERT_TRUE(decoder);
  const auto info = decoder->info();
  const auto inspected = inspect(result->bytes);
  ASSERT_TRUE(info && inspected);
  for (const SceneInfo* said : {&info->scene, &result->scene, &inspected->file.scene}) {
    ASSERT_EQ(said->arrays.size(), 4u);
    EXPECT_EQ(said->arrays[0].vertices_of, 1u);
    EXPECT_EQ(said->arrays[1].count, 50u);
    EXPECT_EQ(said->arrays[1].coder, info->scene.arrays[1].coder);
    EXPECT_EQ(said->arrays[1].numbers, info->scene.arrays[1].numbers);
    EXPECT_EQ(said->blobs[1].size, 1000u);
    EXPECT_EQ(said->document_size, scene.document.size());
    EXPECT_EQ(said->bytes(), info->scene.bytes());
  }
  EXPECT_EQ(info->scene.metadata.size(), 2u);
  EXPECT_EQ(inspected->file.scene.metadata.size(), 2u);
  std::uint64_t sum = info->overhead_bytes + info->scene.bytes();
  for (const MeshInfo& mesh : info->meshes)
    sum += mesh.connectivity_bytes + mesh.position_bytes + mesh.attribute_bytes;
  EXPECT_EQ(sum, result->bytes.size());
}

TEST(Scene, ArraysAreQuantisedIfTheyAreNamed) {
  Scene scene = small_scene();
  std::vector<float> keys;
  for (int i = 0; i < 90; ++i) keys.push_back(static_cast<float>(i * i % 71) * 0.0137f);
  scene.arrays.push_back({"keys", Scalar::float32, 3, bytes_of(keys)});
  EncodeOptions options;
  options.precisions = {{"keys", Precision::of_error(0.01)}, {"position", Precision::of_bits(9)}};
  const auto result = encode(scene, options);
  ASSERT_TRUE(result) << describe(result.error());
  const double error = result->scene.arrays[4].error;
  EXPECT_GT(error, 0);
  EXPECT_LE(error, 0.01);
  const auto decoded = decode_scene(result->bytes);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->arrays[1].data, scene.arrays[1].data);
  EXPECT_NE(decoded->arrays[4].data, scene.arrays[4].data);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    float value = 0;
    std::memcpy(&value, decoded->arrays[4].data.data() + 4 * i, 4);
    EXPECT_LE(std::abs(double(value) - double(keys[i])), error);
  }
  for (const char* name : {"line", "nobody"}) {
    options.precisions = {{name, Precision::of_bits(9)}};
    const auto refused = encode(scene, options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::bad_option);
  }
}

TEST(Scene, RefusesWhatIsInconsistent) {
  const auto refused = [](auto change) {
    Scene scene = small_scene();
    change(scene);
    const auto result = encode(scene);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::inconsistent_mesh) << describe(result.error());
  };
  refused([](Scene& s) { s.arrays[0].data[4] = std::byte{11}; });
  refused([](Scene& s) { s.arrays[0].vertices_of = 2; });
  refused([](Scene& s) { s.arrays[0].scalar = Scalar::float32; });
  refused([](Scene& s) { s.arrays[1].data.pop_back(); });
  refused([](Scene& s) { s.arrays[1].components = 0; });
  refused([](Scene& s) { s.arrays[1].name = "\xff"; });
  refused([](Scene& s) { s.arrays[1].name = std::string(256, 'a'); });
  refused([](Scene& s) { s.arrays[1].scalar = static_cast<Scalar>(10); });
  refused([](Scene& s) { s.blobs[0].name = "\xff"; });
  refused([](Scene& s) { s.metadata.push_back(s.metadata[0]); });
}

TEST(Scene, MemoryIsCounted) {
  Scene scene;
  scene.blobs = {{"zeros", std::vector<std::byte>(1 << 20)}};
  scene.arrays = {{"same", Scalar::float32, 1, std::vector<std::byte>(1 << 22)}};
  const auto bytes = encoded(scene);
  EXPECT_LT(bytes.size(), 1000u);
  DecodeOptions options;
  options.limits.memory = 4 << 20;
  const auto refused = decode_scene(bytes, options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::limit);
  options.limits.memory = refused.error().needed;
  const auto more = decode_scene(bytes, options);
  EXPECT_TRUE(more || more.error().limited == Limited::memory);
  options.limits.memory = 32 << 20;
  EXPECT_TRUE(decode_scene(bytes, options));
}

/// The same sections, of which one has another payload; checksums match.
std::vector<std::byte> rebuilt(std::span<const internal::Section> sections, std::size_t which,
                               std::span<const std::byte> payload) {
  internal::ContainerWriter out(5);
  std::uint64_t meshes = 0;
  for (std::size_t i = 0; i + 1 < sections.size(); ++i) {
    meshes += sections[i].kind == internal::SectionKind::mesh;
    out.section(sections[i].kind, i == which ? payload : sections[i].payload);
  }
  return out.finish(meshes);
}

// Every byte changed, and every payload cut: an error or a scene, and nothing else.
TEST(Scene, AnyBytesAreSafe) {
  const auto bytes = encoded(small_scene());
  std::vector<internal::Section> sections;
  internal::ContainerReader file(bytes);
  ASSERT_TRUE(file.open());
  do {
    const auto section = file.next();
    ASSERT_TRUE(section);
    sections.push_back(*section);
  } while (sections.back().kind != internal::SectionKind::end);
  EXPECT_EQ(rebuilt(sections, sections.size(), {}), bytes);
  DecodeOptions options;
  options.limits.memory = 64 << 20;
  for (std::size_t s = 0; s + 1 < sections.size(); ++s) {
    if (sections[s].kind < internal::SectionKind::metadata) continue;
    const std::span<const std::byte> payload = sections[s].payload;
    for (std::size_t i = 0; i < payload.size(); ++i)
      for (const unsigned flip : {1u, 16u, 128u, 255u}) {
        std::vector<std::byte> changed(payload.begin(), payload.end());
        changed[i] ^= static_cast<std::byte>(flip);
        const auto result = decode_scene(rebuilt(sections, s, changed), options);
        if (result) {
          EXPECT_EQ(result->arrays.size(), 4u);
        }
      }
    for (std::size_t n = 0; n < payload.size(); ++n) {
      const auto cut = decode_scene(rebuilt(sections, s, payload.first(n)), options);
      if (cut) {
        EXPECT_EQ(cut->blobs.size(), 3u);
      }
    }
  }
  for (std::size_t n = 0; n < bytes.size(); ++n)
    EXPECT_FALSE(decode_scene(std::span(bytes).first(n)));
}

TEST(Scene, SectionsHaveTheirPlaces) {
  using internal::SectionKind;
  using internal::test::FileBuilder;
  using internal::test::Payload;
  const Payload document = Payload().varint(1).u8(0).text("d"),
                blob = Payload().u8(0).varint(0).u8(0), mesh = internal::test::tetrahedron_mesh();
  Payload array = Payload().varint(0).varint(0);
  array.raw(internal::test::attribute_section("", Domain::face, Scalar::uint32, 1,
                                              internal::test::zstd_frame({}))
                .bytes);
  const auto good = [](FileBuilder& file) { return decode_scene(file.finish()).ok(); };
  EXPECT_TRUE(good(FileBuilder()
                       .section(SectionKind::document, document)
                       .section(SectionKind::mesh, mesh)
                       .section(SectionKind::array, array)
                       .section(SectionKind::blob, blob)));
  EXPECT_FALSE(good(
      FileBuilder().section(SectionKind::mesh, mesh).section(SectionKind::document, document)));
  EXPECT_FALSE(good(FileBuilder()
                        .section(SectionKind::document, document)
                        .section(SectionKind::document, document)));
  EXPECT_FALSE(
      good(FileBuilder().section(SectionKind::blob, blob).section(SectionKind::array, array)));
  EXPECT_FALSE(
      good(FileBuilder().section(SectionKind::array, array).section(SectionKind::mesh, mesh)));
  EXPECT_FALSE(good(FileBuilder().section(SectionKind::document, Payload().varint(0).u8(0))));
  EXPECT_FALSE(good(FileBuilder().section(SectionKind::blob, Payload().u8(0).varint(1).u8(0))));
  EXPECT_FALSE(good(FileBuilder().section(SectionKind::blob, Payload().u8(0).varint(0).u8(2))));
  array.bytes[1] = std::byte{1};  // vertices of a mesh that is not there
  EXPECT_FALSE(good(FileBuilder().section(SectionKind::array, array)));
  EXPECT_TRUE(
      good(FileBuilder().section(SectionKind::mesh, mesh).section(SectionKind::array, array)));
}

}  // namespace
}  // namespace clers

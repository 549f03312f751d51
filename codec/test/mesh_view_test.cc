// A view of a mesh encodes to what the mesh does, wherever its arrays are.
#include "codec/mesh_view.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <limits>

#include "codec/encode.h"
#include "codec/inspect.h"
#include "codec/test/decoding.h"
#include "codec/test/golden_cases.h"
#include "corpus/generate.h"

namespace {
/// As libraries of linear algebra have it.
struct Vec3 {
  float x, y, z;
};
}  // namespace
template <>
struct clers::ValueType<Vec3> : clers::ValueType<float[3]> {};

namespace clers::internal {
namespace {

/// A mesh, its values `gap` bytes further apart than they need be, its corners in 16 bits if they
/// fit and that is wanted.
struct Spread {
  Spread(const Mesh& mesh, std::size_t gap, bool narrow) : view(mesh) {
    for (const Attribute& a : mesh.attributes) {
      const std::size_t size = a.stride(), count = a.data.size() / size;
      std::vector<std::byte>& to = data.emplace_back(count * (size + gap), std::byte{0x77});
      for (std::size_t i = 0; i < count; ++i)
        std::memcpy(to.data() + i * (size + gap), a.data.data() + i * size, size);
      std::span<const std::byte> all = to;
      if (count % 2 == 1) all = all.first(all.size() - gap);  // the last stride may be cut
      attributes.push_back({a.name, a.domain, a.scalar, a.components, all, size + gap});
    }
    view.attributes = attributes;
    if (!narrow || mesh.vertex_count > 0x10000) return;
    corners.assign(mesh.corners.begin(), mesh.corners.end());
    view.corners = {};
    view.corners_16 = corners;
  }
  std::vector<std::vector<std::byte>> data;
  std::vector<AttributeView> attributes;
  std::vector<std::uint16_t> corners;
  MeshView view;
};

TEST(MeshView, EncodesAsTheMeshDoes) {
  bool narrow = false;  // every other time
  for (const auto& golden : clers::test::golden_cases()) {
    SCOPED_TRACE(golden.name);
    // Views differ in nothing that a level sees.
    if (golden.options.level > 5) continue;
    const auto expected = encode(golden.meshes, golden.options);
    ASSERT_TRUE(expected.ok());
    std::vector<Spread> spread;
    spread.reserve(golden.meshes.size());
    std::vector<MeshView> views;
    for (const Mesh& mesh : golden.meshes)
      views.push_back(spread.emplace_back(mesh, 5, narrow).view);
    narrow = !narrow;
    const auto coded = encode(views, golden.options);
    ASSERT_TRUE(coded.ok()) << describe(coded.error());
    EXPECT_EQ(coded->bytes, expected->bytes);
    for (std::size_t i = 0; i < views.size(); ++i)
      EXPECT_EQ(coded->permutations[i].faces, expected->permutations[i].faces);
    if (golden.meshes.size() == 1 && golden.meshes[0].face_count() < 100) {
      const auto one = encode(golden.meshes[0], golden.options);
      ASSERT_TRUE(one.ok());
      EXPECT_EQ(one->bytes, expected->bytes);
    }
  }
}

TEST(MeshView, NamesValuesOfEveryShape) {
  const std::vector<std::array<float, 3>> arrays = {{1, 2, 3}, {4, 5, 6}};
  const std::vector<Vec3> vectors = {{1, 2, 3}, {4, 5, 6}};
  const float scalars[] = {1, 2, 3, 4, 5, 6};
  for (const AttributeView& a :
       {attribute_view("position", arrays), attribute_view("position", vectors),
        attribute_view("position", scalars, 3)}) {
    EXPECT_EQ(a.scalar, Scalar::float32);
    EXPECT_EQ(a.components, 3);
    EXPECT_EQ(a.data.size(), sizeof scalars);
    EXPECT_EQ(std::memcmp(a.data.data(), scalars, sizeof scalars), 0);
  }
  const AttributeView labels = attribute_view("label", std::vector<std::int16_t>(2), Domain::face);
  EXPECT_EQ(labels.scalar, Scalar::int16);
  EXPECT_EQ(labels.domain, Domain::face);

  std::vector<Vec3> to(2);
  EXPECT_EQ(attribute_target("position", to).components, 3);
  EXPECT_EQ(attribute_target("position", std::span(to)).data.size(), sizeof scalars);
}

TEST(MeshView, OfAMeshIsTheMesh) {
  Mesh mesh = corpus::icosphere(1);
  mesh.name = "ball";
  mesh.metadata = {{"key", "value"}};
  mesh.face_sizes.assign(mesh.face_count(), 3);
  mesh.attributes.push_back({"none", Domain::face, Scalar::uint8, 1, std::vector<std::byte>(80)});
  const MeshView view = mesh;
  EXPECT_EQ(view.face_count(), mesh.face_count());
  EXPECT_EQ(view.corner_count(), mesh.corners.size());
  EXPECT_EQ(view.corners.data(), mesh.corners.data());
  EXPECT_EQ(view.name, mesh.name);
  EXPECT_EQ(view.metadata.size(), 1u);
  ASSERT_EQ(view.attributes.size(), mesh.attributes.size());
  std::size_t i = 0;
  for (const AttributeView a : view.attributes) {
    EXPECT_EQ(a.name, mesh.attributes[i].name);
    EXPECT_EQ(a.data.data(), mesh.attributes[i++].data.data());
  }
  for (const Domain domain : {Domain::vertex, Domain::corner, Domain::face})
    EXPECT_EQ(view.value_count(domain), mesh.value_count(domain));
  EXPECT_EQ(view.position().has_value(), mesh.position() != nullptr);
}

TEST(MeshView, DeducesTypes) {
  struct Vertex {
    float place[3];
    std::array<std::uint16_t, 2> uv;
    std::int8_t bone;
  };
  const std::vector<Vertex> vertices(4);
  const AttributeView place = attribute_view("place", vertices, &Vertex::place),
                      uv = attribute_view("uv", vertices, &Vertex::uv),
                      bone = attribute_view("bone", vertices, &Vertex::bone, Domain::face);
  EXPECT_EQ(place.scalar, Scalar::float32);
  EXPECT_EQ(place.components, 3);
  EXPECT_EQ(uv.scalar, Scalar::uint16);
  EXPECT_EQ(uv.components, 2);
  EXPECT_EQ(uv.value(3), reinterpret_cast<const std::byte*>(&vertices[3].uv));
  EXPECT_EQ(bone.scalar, Scalar::int8);
  EXPECT_EQ(bone.components, 1);
  EXPECT_EQ(bone.domain, Domain::face);
  EXPECT_EQ(bone.stride, sizeof(Vertex));
  EXPECT_TRUE(attribute_view("place", {}, &Vertex::place).data.empty());
  EXPECT_EQ(attribute_view("x", std::vector<double>(6), 3).scalar, Scalar::float64);
  EXPECT_EQ(scalar_of<std::int64_t>(), Scalar::int64);
  EXPECT_EQ(scalar_of<std::uint32_t>(), Scalar::uint32);
}

TEST(MeshView, RefusesWhatDoesNotAgree) {
  const Mesh mesh = corpus::tetrahedron();
  const std::vector<std::byte> data(100);
  const auto what = [&](const AttributeView& a) {
    MeshView view = mesh;
    view.attributes = std::span(&a, 1);
    const auto coded = encode(view);
    EXPECT_FALSE(coded.ok());
    if (coded) return std::string("encoded");
    EXPECT_EQ(coded.error().code, ErrorCode::inconsistent_mesh);
    return coded.error().what;
  };
  const auto bytes = [&](std::size_t n) { return std::span(data).first(n); };
  const Domain vertex = Domain::vertex;
  const Scalar f32 = Scalar::float32;
  EXPECT_EQ(what({"a", vertex, f32, 3, bytes(47), 0}),
            "attribute \"a\" has 47 bytes of values, expected 4 times 12");
  EXPECT_EQ(what({"a", vertex, f32, 3, bytes(49), 12}),
            "attribute \"a\" has 49 bytes of values, expected 4 times 12");
  EXPECT_EQ(what({"a", vertex, f32, 3, bytes(59), 16}),
            "attribute \"a\" has 59 bytes of values, expected 4 times 16");
  EXPECT_EQ(what({"a", vertex, f32, 3, bytes(65), 16}),
            "attribute \"a\" has 65 bytes of values, expected 4 times 16");
  EXPECT_EQ(what({"a", vertex, f32, 3, bytes(44), 11}),
            "attribute \"a\" has values of 12 bytes, 11 bytes apart");
  const std::size_t huge = std::numeric_limits<std::size_t>::max();
  EXPECT_NE(what({"a", vertex, f32, 3, bytes(48), huge}), "encoded");
  EXPECT_NE(what({"a", vertex, f32, 3, bytes(48), huge / 3}), "encoded");
  EXPECT_NE(what({"a", vertex, f32, 3, {}, 16}), "encoded");
  MeshView both = mesh;
  const std::vector<std::uint16_t> corners(mesh.corners.begin(), mesh.corners.end());
  both.corners_16 = corners;
  EXPECT_EQ(encode(both).error().what, "corners of 16 and of 32 bits, expected one of the two");
  EXPECT_EQ(measure(both).error().code, ErrorCode::inconsistent_mesh);
  // No values: no bytes.
  const MeshView empty;
  EXPECT_TRUE(encode(empty).ok());
  MeshView stray;
  const AttributeView one{"a", vertex, f32, 3, bytes(12), 0};
  stray.attributes = std::span(&one, 1);
  EXPECT_EQ(encode(stray).error().code, ErrorCode::inconsistent_mesh);
}

TEST(MeshView, MeasuresAsTheMeshDoes) {
  const Mesh mesh = corpus::punch_holes(corpus::torus(20, 12), 3, 1);
  const Spread spread(mesh, 0, true);
  const auto a = measure(mesh), b = measure(spread.view);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_EQ(a->surface.genus, b->surface.genus);
  EXPECT_EQ(a->surface.boundary_curves, b->surface.boundary_curves);
  EXPECT_EQ(a->triangles, b->triangles);
}

}  // namespace
}  // namespace clers::internal

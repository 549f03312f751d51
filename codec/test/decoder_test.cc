// A Decoder gives in parts, and into any memory, what decode() gives as a whole.
#include "codec/decoder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <thread>

#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/test/attribute.h"
#include "codec/test/decoding.h"
#include "codec/test/file_builder.h"
#include "codec/test/golden_cases.h"
#include "corpus/generate.h"

namespace clers::internal {
namespace {

using test::attribute;
using test::decode_into;

constexpr std::uint32_t no_opposite = MeshTarget::no_opposite;
constexpr std::byte untouched{0xa5};

/// Sides that are two of an edge and run it in opposite directions, by trying all pairs at a
/// vertex.
std::vector<std::uint32_t> opposites_of(const Mesh& mesh) {
  const std::size_t corners = mesh.corners.size();
  std::vector<std::uint32_t> next(corners), result(corners, no_opposite);
  for (std::size_t f = 0, begin = 0; f < mesh.face_count(); ++f) {
    const std::size_t size = mesh.triangles_only() ? 3 : mesh.face_sizes[f];
    for (std::size_t j = 0; j < size; ++j)
      next[begin + j] = static_cast<std::uint32_t>(begin + (j + 1) % size);
    begin += size;
  }
  std::vector<std::vector<std::uint32_t>> sides(mesh.vertex_count);  // by smaller end
  const auto ends = [&](std::uint32_t h) {
    return std::minmax(mesh.corners[h], mesh.corners[next[h]]);
  };
  for (std::uint32_t h = 0; h < corners; ++h) sides[ends(h).first].push_back(h);
  for (const auto& at : sides)
    for (const std::uint32_t h : at) {
      std::uint32_t others = 0, other = 0;
      for (const std::uint32_t g : at)
        if (g != h && ends(g) == ends(h)) ++others, other = g;
      if (others == 1 && mesh.corners[other] != mesh.corners[h]) result[h] = other;
    }
  return result;
}

/// Memory for all of a mesh, values `gap` bytes further apart than they need be.
struct Room {
  Room(const MeshInfo& info, std::size_t gap)
      : corners(static_cast<std::size_t>(info.corners)),
        sizes(static_cast<std::size_t>(info.faces)),
        opposites(corners.size(), 7) {
    for (const AttributeInfo& a : info.attributes) {
      const std::size_t stride = static_cast<std::size_t>(a.value_size()) + gap;
      data.emplace_back(static_cast<std::size_t>(a.count) * stride, untouched);
      targets.push_back({a.name, a.domain, a.scalar, a.components, data.back(), stride});
    }
  }
  std::vector<std::uint32_t> corners, sizes, opposites;
  std::vector<std::vector<std::byte>> data;
  std::vector<AttributeTarget> targets;
};

void expect_sizes(const Mesh& mesh, const std::vector<std::uint32_t>& sizes) {
  ASSERT_EQ(sizes.size(), mesh.face_count());
  for (std::size_t f = 0; f < sizes.size(); ++f)
    ASSERT_EQ(sizes[f], mesh.triangles_only() ? 3 : mesh.face_sizes[f]);
}

/// Every value where it belongs, and no byte between them changed.
void expect_values(const Attribute& a, const std::vector<std::byte>& data, std::size_t stride) {
  const std::size_t size = a.stride(), count = a.data.size() / size;
  ASSERT_EQ(data.size(), count * stride);
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_TRUE(std::equal(a.data.begin() + static_cast<std::ptrdiff_t>(i * size),
                           a.data.begin() + static_cast<std::ptrdiff_t>((i + 1) * size),
                           data.begin() + static_cast<std::ptrdiff_t>(i * stride)))
        << a.name << " " << i;
    for (std::size_t at = i * stride + size; at < (i + 1) * stride; ++at)
      ASSERT_EQ(data[at], untouched);
  }
}

bool has_repeated_attributes(const MeshInfo& info) {
  for (const AttributeInfo& a : info.attributes)
    for (const AttributeInfo& b : info.attributes)
      if (&a != &b && a.name == b.name && a.domain == b.domain) return true;
  return false;
}

void expect_mesh(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.vertex_count, b.vertex_count);
  EXPECT_EQ(a.corners, b.corners);
  EXPECT_EQ(a.face_sizes, b.face_sizes);
  EXPECT_EQ(a.name, b.name);
  ASSERT_EQ(a.attributes.size(), b.attributes.size());
  for (std::size_t i = 0; i < a.attributes.size(); ++i)
    EXPECT_EQ(a.attributes[i].data, b.attributes[i].data);
  ASSERT_EQ(a.metadata.size(), b.metadata.size());
  for (std::size_t i = 0; i < a.metadata.size(); ++i)
    EXPECT_EQ(a.metadata[i].value, b.metadata[i].value);
}

void expect_parts(const Decoder& decoder, std::size_t i, const MeshInfo& info, const Mesh& mesh) {
  const auto alone = decoder.decode(i);
  ASSERT_TRUE(alone.ok()) << describe(alone.error());
  expect_mesh(*alone, mesh);
  if (info.triangles_only) {
    EXPECT_TRUE(mesh.triangles_only());
  }
  // All in one call.
  Room all(info, 3);
  auto ok = decoder.decode_into(i, {.corners = all.corners,
                                    .face_sizes = all.sizes,
                                    .opposites = all.opposites,
                                    .attributes = all.targets});
  ASSERT_TRUE(ok.ok()) << describe(ok.error());
  EXPECT_EQ(all.corners, mesh.corners);
  expect_sizes(mesh, all.sizes);
  EXPECT_EQ(all.opposites, opposites_of(mesh));
  if (!has_repeated_attributes(info))
    for (std::size_t k = 0; k < all.data.size(); ++k)
      expect_values(mesh.attributes[k], all.data[k], all.targets[k].stride);

  // One by one.
  Room each(info, 0);
  for (std::size_t k = 0; k < each.targets.size(); ++k) {
    each.targets[k].stride = 0;
    ASSERT_TRUE(decoder.decode_into(i, {.attributes = std::span(each.targets).subspan(k, 1)}).ok());
    if (!has_repeated_attributes(info))
      expect_values(mesh.attributes[k], each.data[k], mesh.attributes[k].stride());
  }
  ok = decoder.decode_into(i, {.corners = each.corners});
  if (mesh.triangles_only() || mesh.corners.empty()) {
    ASSERT_TRUE(ok.ok()) << describe(ok.error());
    EXPECT_EQ(each.corners, mesh.corners);
  } else {
    EXPECT_EQ(ok.error().code, ErrorCode::bad_option);
  }
  ASSERT_TRUE(decoder.decode_into(i, {.face_sizes = each.sizes}).ok());
  expect_sizes(mesh, each.sizes);
  ASSERT_TRUE(decoder.decode_into(i, {.face_sizes = each.sizes, .opposites = each.opposites}).ok());
  EXPECT_EQ(each.opposites, all.opposites);
  if (mesh.triangles_only() && !mesh.corners.empty()) {
    std::fill(each.opposites.begin(), each.opposites.end(), 7);
    ASSERT_TRUE(
        decoder.decode_into(i, {.corners = each.corners, .opposites = each.opposites}).ok());
    EXPECT_EQ(each.opposites, all.opposites);
  }
  std::vector<std::uint16_t> narrow(mesh.corners.size());
  ok = decoder.decode_into(i, {.corners_16 = narrow, .face_sizes = each.sizes});
  ASSERT_EQ(ok.ok(), mesh.vertex_count <= 0x10000 || mesh.corners.empty());
  if (ok) {
    EXPECT_TRUE(std::equal(narrow.begin(), narrow.end(), mesh.corners.begin(), mesh.corners.end()));
  } else {
    EXPECT_EQ(ok.error().code, ErrorCode::bad_option);
  }
}

TEST(Decoder, GivesInPartsWhatDecodeGives) {
  for (const auto& golden : clers::test::golden_cases()) {
    SCOPED_TRACE(golden.name);
    const auto coded = encode(golden.meshes, golden.options);
    ASSERT_TRUE(coded.ok());
    const auto whole = decode(coded->bytes);
    DecodeOptions options;
    options.threads = 2;
    const auto decoder = Decoder::open(coded->bytes, options);
    ASSERT_TRUE(whole.ok() && decoder.ok());
    const auto info = decoder->info();
    ASSERT_TRUE(info.ok());
    ASSERT_EQ(decoder->mesh_count(), golden.meshes.size());
    ASSERT_EQ(info->meshes.size(), golden.meshes.size());
    const auto again = decoder->decode();
    ASSERT_TRUE(again.ok());
    std::size_t pieces = 0;
    for (std::size_t i = 0; i < whole->size(); ++i) {
      expect_mesh((*again)[i], (*whole)[i]);
      expect_parts(*decoder, i, info->meshes[i], (*whole)[i]);
      test::expect_same_info(info->meshes[i], coded->report[i]);
      EXPECT_EQ(info->meshes[i].metadata.size(), golden.meshes[i].metadata.size());
      pieces += info->meshes[i].pieces;
    }
    EXPECT_EQ(decoder->piece_count(), pieces);
  }
}

struct Vertex {
  std::array<float, 3> position;
  std::uint8_t colour[4];
  double weight;
};

/// A grid whose vertices are structs, and the same as a Mesh.
std::vector<Vertex> vertices_of(std::uint32_t count) {
  std::vector<Vertex> vertices(count);
  for (std::uint32_t v = 0; v < count; ++v) {
    const auto x = static_cast<float>(v % 11), y = static_cast<float>(v / 11);
    const auto c = static_cast<std::uint8_t>(v);
    vertices[v] = {{x, y, x * y}, {c, 1, 2, 3}, 0.5 * v};
  }
  return vertices;
}

TEST(Decoder, FillsAnInterleavedVertexBuffer) {
  const Mesh grid = corpus::grid(10, 10);
  const std::vector<Vertex> vertices = vertices_of(grid.vertex_count);
  const AttributeView views[] = {attribute_view("position", vertices, &Vertex::position),
                                 attribute_view("colour", vertices, &Vertex::colour),
                                 attribute_view("weight", vertices, &Vertex::weight)};
  MeshView view = grid;
  view.attributes = views;
  const auto coded = encode(view);
  ASSERT_TRUE(coded.ok()) << describe(coded.error());
  const auto decoder = Decoder::open(coded->bytes);
  ASSERT_TRUE(decoder.ok());

  std::vector<Vertex> back(grid.vertex_count);
  std::vector<std::uint32_t> indices(grid.corners.size());
  const AttributeTarget targets[] = {attribute_target("weight", back, &Vertex::weight),
                                     attribute_target("position", back, &Vertex::position),
                                     attribute_target("colour", back, &Vertex::colour)};
  const auto ok = decoder->decode_into(0, {.corners = indices, .attributes = targets});
  ASSERT_TRUE(ok.ok()) << describe(ok.error());
  for (std::size_t v = 0; v < back.size(); ++v) {
    const Vertex& was = vertices[coded->permutations[0].vertices[v]];
    EXPECT_EQ(back[v].position, was.position);
    EXPECT_EQ(std::memcmp(back[v].colour, was.colour, 4), 0);
    EXPECT_EQ(back[v].weight, was.weight);
  }
  EXPECT_EQ(indices, decode(coded->bytes)->front().corners);

  std::vector<double> weights(grid.vertex_count);
  const AttributeTarget packed[] = {attribute_target("weight", weights, 1)};
  ASSERT_TRUE(decoder->decode_into(0, {.attributes = packed}).ok());
  for (std::size_t v = 0; v < back.size(); ++v) EXPECT_EQ(weights[v], back[v].weight);
}

/// What is refused, and in which words.
TEST(Decoder, RefusesMemoryThatDoesNotFit) {
  Mesh mesh = corpus::icosphere(1);  // 42 vertices, 80 faces
  mesh.attributes = {attribute<float>("position", Domain::vertex, Scalar::float32, 3,
                                      std::vector<float>(3 * mesh.vertex_count))};
  const auto coded = encode(mesh);
  ASSERT_TRUE(coded.ok());
  const auto decoder = Decoder::open(coded->bytes);
  ASSERT_TRUE(decoder.ok());
  const auto what = [&](const MeshTarget& target, std::size_t index = 0) {
    const auto ok = decoder->decode_into(index, target);
    EXPECT_FALSE(ok.ok());
    if (ok) return std::string("decoded");
    EXPECT_EQ(ok.error().code, ErrorCode::bad_option);
    return ok.error().what;
  };
  std::vector<std::uint32_t> corners(241);
  std::vector<std::uint16_t> narrow(240);
  EXPECT_EQ(what({.corners = corners}), "memory for 241 corners, expected 240");
  EXPECT_EQ(what({.corners = std::span(corners).first(239)}),
            "memory for 239 corners, expected 240");
  EXPECT_EQ(what({.corners_16 = std::span(narrow).first(1)}), "memory for 1 corners, expected 240");
  EXPECT_EQ(what({.corners = std::span(corners).first(240), .corners_16 = narrow}),
            "memory for corners of 16 and of 32 bits, expected one of the two");
  EXPECT_EQ(what({.face_sizes = std::span(corners).first(81)}),
            "memory for 81 face sizes, expected 80");
  EXPECT_EQ(what({.opposites = std::span(corners).first(80)}),
            "memory for 80 opposites, expected 240");
  EXPECT_EQ(what({}, 1), "mesh 1, there are 1");
  EXPECT_EQ(decoder->decode(1).error().code, ErrorCode::bad_option);

  std::vector<std::byte> memory(42 * 16);
  const auto attribute_error = [&](AttributeTarget target) {
    return what({.attributes = std::span(&target, 1)});
  };
  const std::span<std::byte> all(memory);
  const Domain vertex = Domain::vertex;
  const Scalar f32 = Scalar::float32;
  EXPECT_EQ(attribute_error({"normal", vertex, f32, 3, all, 16}),
            "no vertex attribute \"normal\" in the mesh");
  EXPECT_EQ(attribute_error({"position", Domain::face, f32, 3, all, 16}),
            "no face attribute \"position\" in the mesh");
  EXPECT_EQ(attribute_error({"position", vertex, Scalar::float64, 3, all, 16}),
            "attribute \"position\" has values of 3 float32, memory is for 3 float64");
  EXPECT_EQ(attribute_error({"position", vertex, f32, 4, all, 16}),
            "attribute \"position\" has values of 3 float32, memory is for 4 float32");
  EXPECT_EQ(attribute_error({"position", vertex, f32, 3, all.first(41 * 16 + 11), 16}),
            "attribute \"position\" has memory of 667 bytes, expected 42 times 16");
  EXPECT_EQ(attribute_error({"position", vertex, f32, 3, all, 0}),
            "attribute \"position\" has memory of 672 bytes, expected 42 times 12");
  EXPECT_EQ(attribute_error({"position", vertex, f32, 3, all, 8}),
            "attribute \"position\" has values of 12 bytes, memory is for one in 8");
  EXPECT_EQ(attribute_error({"position", vertex, f32, 3, all, std::size_t(1) << 62}),
            "attribute \"position\" has memory of 672 bytes, expected 42 times "
            "4611686018427387904");
  EXPECT_EQ(attribute_error({"position", vertex, static_cast<Scalar>(10), 3, all, 16}),
            "memory for an attribute of scalar 10, expected 0 to 9");
  EXPECT_EQ(attribute_error({"position", vertex, f32, 0, all, 16}),
            "memory for an attribute of 0 components, expected 1 to 255");
  // The last value needs no whole stride.
  const AttributeTarget fits{"position", vertex, f32, 3, all.first(41 * 16 + 12), 16};
  EXPECT_TRUE(decoder->decode_into(0, {.attributes = std::span(&fits, 1)}).ok());
  EXPECT_TRUE(decoder->decode_into(0, {}).ok());
}

TEST(Decoder, SixteenBitsAreForSixtyFourThousandVertices) {
  for (const std::uint32_t vertices : {0x10000u, 0x10001u}) {
    Mesh mesh;
    mesh.vertex_count = vertices;
    mesh.corners = {0, 1, vertices - 1};
    const auto coded = encode(mesh);
    ASSERT_TRUE(coded.ok());
    std::vector<std::uint16_t> narrow(3);
    const auto ok = decode_into(coded->bytes, {.corners_16 = narrow});
    EXPECT_EQ(ok.ok(), vertices == 0x10000);
    if (ok) continue;
    EXPECT_EQ(ok.error().what, "65537 vertices, 16 bits have numbers for at most 65536");
  }
}

TEST(Decoder, OfNothing) {
  const auto none = encode(std::span<const Mesh>());
  ASSERT_TRUE(none.ok());
  const auto empty_file = Decoder::open(none->bytes);
  ASSERT_TRUE(empty_file.ok());
  EXPECT_EQ(empty_file->mesh_count(), 0u);
  EXPECT_EQ(empty_file->piece_count(), 0u);
  EXPECT_TRUE(empty_file->info()->meshes.empty());
  EXPECT_TRUE(empty_file->decode()->empty());
  EXPECT_EQ(empty_file->decode_into(0, {}).error().code, ErrorCode::bad_option);
  EXPECT_EQ(empty_file->decode_piece(0).error().what, "piece 0, there are 0");

  Mesh empty;
  empty.attributes = {{"position", Domain::vertex, Scalar::float32, 3, {}}};
  const auto coded = encode(empty);
  ASSERT_TRUE(coded.ok());
  const auto decoder = Decoder::open(coded->bytes);
  ASSERT_TRUE(decoder.ok());
  EXPECT_EQ(decoder->piece_count(), 1u);
  EXPECT_EQ(decoder->info()->meshes[0].corners, 0u);
  std::vector<Vertex> vertices;
  const AttributeTarget target = attribute_target("position", vertices, &Vertex::position);
  EXPECT_TRUE(decoder->decode_into(0, {.attributes = std::span(&target, 1)}).ok());
  std::vector<std::uint32_t> one(1);
  EXPECT_EQ(decoder->decode_into(0, {.corners = one}).error().what,
            "memory for 1 corners, expected 0");
}

/// Bytes that are no file are refused when it is opened; damage within, at the latest when decoded.
TEST(Decoder, RefusesWhatDecodeRefuses) {
  const Mesh mesh = corpus::torus(5, 6);
  const auto coded = encode(mesh);
  ASSERT_TRUE(coded.ok());
  for (std::size_t size = 0; size < coded->bytes.size(); ++size) {
    const auto prefix = std::span(coded->bytes).first(size);
    const auto opened = Decoder::open(prefix);
    ASSERT_FALSE(opened.ok());
    EXPECT_EQ(describe(opened.error()), describe(decode(prefix).error()));
  }
  for (std::size_t at = 0; at < coded->bytes.size(); ++at) {
    auto damaged = coded->bytes;
    damaged[at] ^= std::byte{4};
    EXPECT_FALSE(Decoder::open(damaged).ok());
  }
}

/// Vertices that no byte is spent on are counted before a caller makes memory for them.
TEST(Decoder, ClaimsOfVerticesAreLimited) {
  const Bytes bytes =
      test::FileBuilder().section(SectionKind::mesh, test::tetrahedron_mesh(500'000'000)).finish();
  const auto opened = Decoder::open(bytes);
  ASSERT_FALSE(opened.ok());
  EXPECT_EQ(opened.error().limited, Limited::memory);
}

TEST(Decoder, CallsMayRunAtTheSameTime) {
  const Mesh mesh = corpus::shuffle(corpus::icosphere(3), 1);
  EncodeOptions how;
  how.piece_faces = 200;
  const auto coded = encode(mesh, how);
  ASSERT_TRUE(coded.ok());
  const auto decoder = Decoder::open(coded->bytes);
  ASSERT_TRUE(decoder.ok());
  const auto expected = decoder->decode(0);
  ASSERT_TRUE(expected.ok());
  std::vector<std::vector<std::uint32_t>> corners(
      4, std::vector<std::uint32_t>(expected->corners.size()));
  std::vector<std::thread> threads;
  for (auto& own : corners)
    threads.emplace_back([&own, copy = *decoder] {
      EXPECT_TRUE(copy.decode_into(0, {.corners = own}).ok());
      EXPECT_TRUE(copy.decode_piece(1).ok());
      EXPECT_TRUE(copy.info().ok());
    });
  for (std::thread& thread : threads) thread.join();
  for (const auto& own : corners) EXPECT_EQ(own, expected->corners);
}

TEST(Decoder, TellsProgress) {
  const Mesh mesh = corpus::icosphere(3);
  EncodeOptions how;
  how.piece_faces = 100;
  const auto coded = encode(mesh, how);
  ASSERT_TRUE(coded.ok());
  double last = -1;
  DecodeOptions options;
  options.progress = [&](std::string_view, double done) {
    EXPECT_GE(done, last);
    last = done;
  };
  const auto decoder = Decoder::open(coded->bytes, options);
  std::vector<std::uint32_t> corners(mesh.corners.size());
  ASSERT_TRUE(decoder->decode_into(0, {.corners = corners}).ok());
  EXPECT_EQ(last, 1.0);
  last = -1;
  ASSERT_TRUE(decoder->decode().ok());
  EXPECT_EQ(last, 1.0);
}

}  // namespace
}  // namespace clers::internal

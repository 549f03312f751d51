// Values that elements share or miss: meshes with random seams there and back, in every order, with
// the same sharing; into memory of a caller; and bytes that no encoder makes.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "codec/compare.h"
#include "codec/decode.h"
#include "codec/decoder.h"
#include "codec/encode.h"
#include "codec/file/container.h"
#include "codec/soup/corner_map.h"
#include "codec/soup/polygon_sizes.h"
#include "codec/soup/raw_faces.h"
#include "codec/test/attribute.h"
#include "codec/test/decoding.h"
#include "codec/test/round_trip.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::internal {
namespace {

using corpus::Random;

/// Faces of all kinds: manifold or not, polygons, repeated, reversed, folded, degenerate ones.
Mesh random_faces(Random& random) {
  const std::uint64_t seed = random.next();
  switch (random.below(10)) {
    case 0: return corpus::icosphere(random.below(3));
    case 1: return corpus::punch_holes(corpus::torus(9, 7), 3, seed);
    case 2: return corpus::reverse_some(corpus::icosphere(2), 30, seed);
    case 3: return corpus::doubled(corpus::grid(3, 4));
    case 4: return corpus::add_fins(corpus::icosphere(1), 9, seed);
    case 5: return corpus::random_soup(5, 1 + random.below(9), 3, seed);
    case 6: return corpus::random_soup(12, 30, 6, seed);
    case 7: return corpus::isolate(corpus::two_sided(corpus::cylinder(5, 3)), 3);
    case 8: return corpus::book(5);
    default: return corpus::moebius_strip(7, 2);
  }
}

/// Some triangles of two as quads.
Mesh with_quads(Mesh mesh, Random& random) {
  if (!mesh.triangles_only()) return mesh;
  Mesh out = mesh;
  out.corners.clear();
  for (std::size_t f = 0; f + 1 < mesh.face_count(); ++f) {
    const auto a = std::span(mesh.corners).subspan(3 * f, 3),
               b = std::span(mesh.corners).subspan(3 * f + 3, 3);
    const bool quad = a[0] == b[0] && a[2] == b[1] && a[1] != b[2] && random.chance(70);
    if (quad) {
      out.corners.insert(out.corners.end(), {a[0], a[1], a[2], b[2]});
      ++f;
    } else {
      out.corners.insert(out.corners.end(), a.begin(), a.end());
    }
    out.face_sizes.push_back(quad ? 4 : 3);
  }
  return out;
}

std::size_t elements(const Mesh& mesh, Domain domain) {
  return mesh.value_count(domain);
}

/// Values that charts of faces part; some faces have none; by index or not. Indices are shared by
/// wedges, by none, by all that are equal, or at random, and some values are used by none.
Attribute random_attribute(const Mesh& mesh, const std::string& name, Random& random) {
  const Domain domain = static_cast<Domain>(random.below(3));
  const unsigned charts = 1 + random.below(4), kinds = random.chance(30) ? 3 : 1000;
  const bool by_index = random.chance(70), missing = by_index && random.chance(50);
  const unsigned style = random.below(4);
  std::vector<std::int16_t> values;
  std::vector<std::uint32_t> indices;
  std::map<std::pair<std::uint32_t, unsigned>, std::uint32_t> known;
  std::vector<std::int16_t> expanded;
  const auto add = [&](std::uint32_t at, unsigned chart, bool has) {
    const auto value = static_cast<std::int16_t>((at * 7 + chart * 100) % kinds);
    expanded.insert(expanded.end(), {value, static_cast<std::int16_t>(-value)});
    if (!has) return indices.push_back(no_value);
    auto next = static_cast<std::uint32_t>(values.size() / 2);
    if (style == 1) chart += 10 * next;                                 // each its own
    if (style == 2) at = static_cast<std::uint32_t>(value), chart = 0;  // all that are equal
    if (style == 3) chart = 10 * random.below(2) + chart;
    const auto [found, is_new] = known.insert({{at, chart}, next});
    indices.push_back(found->second);
    if (is_new) values.insert(values.end(), {value, static_cast<std::int16_t>(-value)});
  };
  if (domain == Domain::corner) {
    std::size_t c = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const unsigned chart = static_cast<unsigned>(f * charts / mesh.face_count());
      const bool none = missing && random.chance(20);
      for (std::uint32_t i = 0; i < size_of_face(mesh, f); ++i)
        add(mesh.corners[c++], chart, !none && !(missing && random.chance(3)));
    }
  } else {
    for (std::uint32_t i = 0; i < elements(mesh, domain); ++i)
      add(i, i % charts, !(missing && random.chance(20)));
  }
  if (!by_index || indices.empty())
    return test::attribute(name, domain, Scalar::int16, 2, expanded);
  if (random.chance(30)) values.insert(values.end(), {77, 78, 79, 80});
  const auto count = static_cast<std::uint32_t>(values.size() / 2);
  if (random.chance(50)) {  // numbers at random
    const auto to = random.permutation(count);
    std::vector<std::int16_t> moved(values.size());
    for (std::uint32_t i = 0; i < count; ++i)
      std::copy_n(values.begin() + 2 * i, 2, moved.begin() + 2 * to[i]);
    for (std::uint32_t& i : indices)
      if (i != no_value) i = to[i];
    values = moved;
  }
  Attribute a = test::attribute(name, domain, Scalar::int16, 2, values);
  a.indices = indices;
  return a;
}

Mesh random_mesh(std::uint64_t seed) {
  Random random(seed);
  Mesh mesh = random_faces(random);
  if (random.chance(40)) mesh = with_quads(std::move(mesh), random);
  const unsigned count = 1 + random.below(3);
  for (unsigned i = 0; i < count; ++i)
    mesh.attributes.push_back(
        random_attribute(mesh, std::string(1, static_cast<char>('a' + i)), random));
  return mesh;
}

/// What is wrong with arrays as such; empty: nothing.
std::string disorder(const Mesh& mesh) {
  for (const Attribute& a : mesh.attributes) {
    if (a.data.size() % a.stride() != 0) return "a part of a value";
    if (a.indices.empty()) {
      if (a.value_count() != elements(mesh, a.domain)) return "values are missing";
      continue;
    }
    if (a.indices.size() != elements(mesh, a.domain)) return "indices are missing";
    for (const std::uint32_t i : a.indices)
      if (i != no_value && i >= a.value_count()) return "an index of no value";
  }
  return {};
}

/// Numbers of values are those of their first use, and then come those that none has.
bool are_numbered_by_use(const Attribute& a) {
  std::uint32_t next = 0;
  for (const std::uint32_t i : a.indices) {
    if (i == no_value || i < next) continue;
    if (i != next++) return false;
  }
  return true;
}

void check(const Mesh& mesh, int level, Order order, std::optional<std::uint32_t> pieces = {}) {
  EncodeOptions options;
  options.level = level;
  options.order = order;
  options.piece_faces = pieces;
  const auto coded = encode(mesh, options);
  ASSERT_TRUE(coded.ok()) << describe(coded.error());
  const auto decoded = decode(coded->bytes);
  ASSERT_TRUE(decoded.ok()) << describe(decoded.error());
  const Mesh& out = decoded->front();
  ASSERT_EQ(disorder(out), "");
  const auto same = compare(mesh, out, {}, coded->permutations[0]);
  ASSERT_TRUE(same.ok()) << describe(same.error());
  ASSERT_EQ(same->verdict, Verdict::same) << same->what;
  for (std::size_t k = 0; k < mesh.attributes.size(); ++k) {
    const Attribute &a = mesh.attributes[k], &b = out.attributes[k];
    ASSERT_EQ(a.indices.empty(), b.indices.empty());
    ASSERT_EQ(a.value_count(), b.value_count());
    ASSERT_EQ(coded->report[0].attributes[k].count, b.value_count());
    if (order == Order::keep) {
      ASSERT_EQ(a.indices, b.indices);
      ASSERT_EQ(a.data, b.data);
    } else if (!b.indices.empty()) {
      ASSERT_TRUE(are_numbered_by_use(b));
    }
  }
  const auto info = inspect(coded->bytes);
  ASSERT_TRUE(info.ok());
  test::expect_same_info(info->file.meshes[0], coded->report[0]);
  for (std::size_t k = 0; k < mesh.attributes.size(); ++k)
    EXPECT_EQ(info->file.meshes[0].attributes[k].structure,
              coded->report[0].attributes[k].structure);
}

RC_GTEST_PROP(Wedges, ComeBack, (std::uint64_t seed)) {
  const Mesh mesh = random_mesh(seed);
  Random random(seed);
  check(mesh, 1 + static_cast<int>(random.below(9)), random.chance(50) ? Order::keep : Order::free);
  RC_ASSERT(!testing::Test::HasFatalFailure());
}

RC_GTEST_PROP(Wedges, ComeBackInPieces, (std::uint64_t seed)) {
  Random random(seed);
  Mesh mesh = corpus::icosphere(2);
  for (unsigned i = 0; i < 2; ++i) {
    Attribute a = random_attribute(mesh, std::string(1, static_cast<char>('a' + i)), random);
    if (!a.indices.empty()) continue;
    mesh.attributes.push_back(std::move(a));
  }
  check(mesh, 5, random.chance(50) ? Order::keep : Order::free, 1 + random.below(100));
  RC_ASSERT(!testing::Test::HasFatalFailure());
}

/// A mesh whose vertices charts of faces had split, as glTF has it: the copies of a vertex have its
/// position, and values that are those of the vertex or not.
Mesh split_mesh(Random& random) {
  Mesh mesh = random_faces(random);
  if (random.chance(30)) mesh = with_quads(std::move(mesh), random);
  mesh.attributes.clear();
  const unsigned charts = 2 + random.below(3), places = 3 + random.below(3000);
  std::vector<std::uint32_t> vertices;  // what each was
  std::map<std::pair<std::uint32_t, unsigned>, std::uint32_t> known;
  std::size_t c = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const unsigned chart =
        random.chance(5) ? random.below(9) : static_cast<unsigned>(f * charts / mesh.face_count());
    for (std::uint32_t i = 0; i < size_of_face(mesh, f); ++i, ++c) {
      const auto [found, is_new] =
          known.insert({{mesh.corners[c], chart}, static_cast<std::uint32_t>(vertices.size())});
      if (is_new) vertices.push_back(mesh.corners[c]);
      mesh.corners[c] = found->second;
    }
  }
  if (random.chance(30))
    vertices.insert(vertices.end(), {0, 1, 0});  // isolated, at places of others
  mesh.vertex_count = static_cast<std::uint32_t>(vertices.size());
  std::vector<float> positions;
  std::vector<std::int16_t> weights, normals;
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const auto at = static_cast<float>(vertices[v] % places);
    positions.insert(positions.end(), {at, at * 0.5f, -at});
    weights.push_back(static_cast<std::int16_t>(vertices[v] % places));
    normals.push_back(static_cast<std::int16_t>(v));
  }
  mesh.attributes = {test::attribute("normal", Domain::vertex, Scalar::int16, 1, normals),
                     test::attribute("position", Domain::vertex, Scalar::float32, 3, positions),
                     test::attribute("weights", Domain::vertex, Scalar::int16, 1, weights)};
  for (const char* const name : {"a", "b"})
    if (random.chance(40)) mesh.attributes.push_back(random_attribute(mesh, name, random));
  return mesh;
}

RC_GTEST_PROP(Welds, ComeBack, (std::uint64_t seed)) {
  Random random(seed);
  const Mesh mesh = split_mesh(random);
  check(mesh, random.chance(80) ? 5 : 1 + static_cast<int>(random.below(9)),
        random.chance(50) ? Order::keep : Order::free);
  RC_ASSERT(!testing::Test::HasFatalFailure());
}

/// A cylinder that a seam opened, and what its copies share.
Mesh seamed_cylinder() {
  constexpr std::uint32_t around = 40, rows = 20;
  Mesh mesh = corpus::grid(around, rows);
  std::vector<float> positions;
  std::vector<std::int32_t> sides;
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v) {
    const std::uint32_t x = v % (around + 1), y = v / (around + 1);
    Random random(y * around + x % around);
    for (unsigned i = 0; i < 3; ++i) positions.push_back(static_cast<float>(random.below(1 << 24)));
    sides.push_back(static_cast<std::int32_t>(x));
  }
  mesh.attributes = {test::attribute("position", Domain::vertex, Scalar::float32, 3, positions),
                     test::attribute("side", Domain::vertex, Scalar::int32, 1, sides)};
  return mesh;
}

TEST(Welds, AreMadeWhereTheySave) {
  const Mesh mesh = seamed_cylinder();
  const auto coded = encode(mesh);
  ASSERT_TRUE(coded.ok());
  EXPECT_EQ(coded->report[0].welded_vertices, 21u);
  EXPECT_EQ(coded->report[0].attributes[0].structure, "welded");
  EXPECT_EQ(coded->report[0].attributes[1].structure, "");
  for (const Order order : {Order::free, Order::keep}) {
    check(mesh, 5, order);
    check(mesh, 9, order);
    check(mesh, 5, order, 300);
  }
  // Corners alone, and values alone.
  std::vector<std::uint32_t> corners(mesh.corners.size());
  std::vector<std::int32_t> sides(mesh.vertex_count);
  const AttributeTarget target[] = {attribute_target("side", sides, 1)};
  ASSERT_TRUE(test::decode_into(coded->bytes, {.corners = corners}).ok());
  ASSERT_TRUE(test::decode_into(coded->bytes, {.attributes = target}).ok());
  const auto decoded = decode(coded->bytes);
  ASSERT_TRUE(decoded.ok());
  EXPECT_EQ(decoded->front().corners, corners);
  EXPECT_TRUE(equal(decoded->front().attributes[1].data, std::as_bytes(std::span(sides))));
}

/// A sphere in two charts, as an OBJ has it, and its normals, whose seams are the same.
Mesh two_charts() {
  Mesh mesh = corpus::icosphere(3);
  mesh.attributes.clear();
  for (const char* const name : {"texcoord", "normal"}) {
    std::vector<std::int32_t> values;
    std::vector<std::uint32_t> indices;
    std::map<std::pair<std::uint32_t, bool>, std::uint32_t> known;
    for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
      const bool second = 2 * c >= mesh.corners.size();
      const auto [found, is_new] =
          known.insert({{mesh.corners[c], second}, static_cast<std::uint32_t>(values.size())});
      if (is_new) values.push_back(static_cast<std::int32_t>(mesh.corners[c]) + 10000 * second);
      indices.push_back(found->second);
    }
    mesh.attributes.push_back(test::attribute(name, Domain::corner, Scalar::int32, 1, values));
    mesh.attributes.back().indices = indices;
  }
  return mesh;
}

TEST(Wedges, SeamsAreCodedOnce) {
  Mesh mesh = two_charts();
  const auto both = encode(mesh);
  mesh.attributes.erase(mesh.attributes.begin());
  const auto alone = encode(mesh);
  ASSERT_TRUE(both.ok() && alone.ok());
  EXPECT_EQ(alone->report[0].attributes[0].structure, "wedges, by index");
  EXPECT_LT(both->report[0].attributes[1].bytes, alone->report[0].attributes[0].bytes);
  EXPECT_LT(alone->report[0].attributes[0].bytes, 1200u);
}

TEST(Wedges, CornersOfPolygonsAreThoseOfTheirTriangles) {
  const std::vector<std::uint32_t> sizes = {3, 5, 4, 3};
  const std::vector<std::uint32_t> triangles = {0, 1, 2, 3,  4,  5, 5,  4,  6,  6, 4,
                                                7, 8, 9, 10, 10, 9, 11, 12, 13, 14};
  std::vector<std::uint32_t> polygons;
  append_polygons(triangles, sizes, polygons);
  const auto corner_of = corners_of_polygons(sizes, triangles.size());
  ASSERT_EQ(corner_of.size(), triangles.size());
  for (std::size_t h = 0; h < triangles.size(); ++h)
    EXPECT_EQ(polygons[corner_of[h]], triangles[h]) << h;
  const std::vector<std::uint32_t> faces = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  const std::vector<std::uint32_t> all = {1, 4, 0, 5};
  const auto fans = fan_triangles(faces, all);
  EXPECT_EQ(corners_of_fans(all, fans.size()), fans);
}

/// Every attribute alone: what it needs of others is decoded too, and no more.
RC_GTEST_PROP(Wedges, AreExpandedIntoMemory, (std::uint64_t seed)) {
  Random random(seed);
  const Mesh mesh = random.chance(30) ? split_mesh(random) : random_mesh(seed);
  EncodeOptions options;
  options.level = 1 + static_cast<int>(random.below(9));
  options.order = random.chance(50) ? Order::keep : Order::free;
  const auto coded = encode(mesh, options);
  RC_ASSERT(coded.ok());
  const auto decoded = decode(coded->bytes);
  RC_ASSERT(decoded.ok());
  for (const Attribute& a : decoded->front().attributes) {
    const std::size_t count = elements(mesh, a.domain);
    std::vector<std::byte> memory(count * a.stride(), std::byte{0x5a}), again = memory;
    const AttributeTarget targets[] = {{a.name, a.domain, a.scalar, a.components, memory},
                                       {a.name, a.domain, a.scalar, a.components, again}};
    RC_ASSERT(test::decode_into(coded->bytes, {.attributes = targets}).ok());
    RC_ASSERT(memory == again);
    for (std::size_t i = 0; i < count; ++i) {
      const auto there = std::span(memory).subspan(i * a.stride(), a.stride());
      const std::size_t v = a.indices.empty() ? i : a.indices[i];
      if (v == no_value)
        RC_ASSERT(std::all_of(there.begin(), there.end(),
                              [](std::byte b) { return b == std::byte{0x5a}; }));
      else
        RC_ASSERT(equal(there, value(a, v)));
    }
  }
}

/// The sections of a file with one of them changed, and right checksums.
Bytes changed(std::span<const std::byte> bytes, Random& random) {
  ContainerReader in(bytes);
  EXPECT_TRUE(in.open().ok());
  std::vector<Section> sections;
  for (;;) {
    auto section = in.next();
    EXPECT_TRUE(section.ok());
    if (section->kind == SectionKind::end) break;
    sections.push_back(*section);
  }
  const std::size_t victim = random.below(static_cast<std::uint32_t>(sections.size()));
  ContainerWriter out(5);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    Bytes payload(sections[i].payload.begin(), sections[i].payload.end());
    if (i == victim && !payload.empty()) {
      const auto size = static_cast<std::uint32_t>(payload.size());
      if (random.chance(20)) payload.resize(random.below(size));
      for (unsigned k = random.below(3); !payload.empty() && k < 3; ++k)
        payload[random.below(static_cast<std::uint32_t>(
            random.chance(50) ? std::min<std::size_t>(payload.size(), 24) : payload.size()))] ^=
            static_cast<std::byte>(1u << random.below(8));
    }
    out.section(sections[i].kind, payload);
  }
  return out.finish(1);
}

RC_GTEST_PROP(Wedges, OfAnyBytesAreRefusedOrInBounds, (std::uint64_t seed)) {
  Random random(seed);
  const Mesh mesh = random.chance(30) ? split_mesh(random) : random_mesh(seed);
  EncodeOptions options;
  options.level = 1 + static_cast<int>(random.below(9));
  options.order = random.chance(50) ? Order::keep : Order::free;
  const auto coded = encode(mesh, options);
  RC_ASSERT(coded.ok());
  for (unsigned i = 0; i < 20; ++i) {
    const auto decoded = decode(changed(coded->bytes, random));
    if (decoded) RC_ASSERT(disorder(decoded->front()) == "");
  }
}

TEST(Wedges, OfWrongArraysAreRefused) {
  const auto refused = [](const Mesh& mesh) {
    const auto coded = encode(mesh);
    ASSERT_FALSE(coded.ok());
    EXPECT_EQ(coded.error().code, ErrorCode::inconsistent_mesh) << describe(coded.error());
  };
  Mesh mesh = two_charts();
  mesh.attributes[1].indices[7] = static_cast<std::uint32_t>(mesh.attributes[1].value_count());
  refused(mesh);
  mesh = two_charts();
  mesh.attributes[0].indices.pop_back();
  refused(mesh);
  mesh = two_charts();
  mesh.attributes[0].data.pop_back();
  refused(mesh);
  mesh = two_charts();
  Attribute position =
      test::attribute("position", Domain::vertex, Scalar::float32, 3, std::vector<float>{1, 2, 3});
  position.indices.assign(mesh.vertex_count, 0);
  mesh.attributes.push_back(position);
  refused(mesh);
}

TEST(Wedges, AreToldApartWhereOthersShare) {
  const Mesh mesh = two_charts();
  Mesh other = mesh;
  Attribute& a = other.attributes[0];
  EXPECT_EQ(compare(mesh, other)->verdict, Verdict::same);
  // Other numbers are the same; a value of its own for one corner is not.
  std::rotate(a.data.begin(), a.data.begin() + 4, a.data.end());
  const auto count = static_cast<std::uint32_t>(a.value_count());
  for (std::uint32_t& i : a.indices) i = (i + count - 1) % count;
  EXPECT_EQ(compare(mesh, other)->verdict, Verdict::same);
  Mesh split = other;
  const auto copied = value(split.attributes[0], split.attributes[0].indices[5]);
  const Bytes own(copied.begin(), copied.end());
  split.attributes[0].data.insert(split.attributes[0].data.end(), own.begin(), own.end());
  split.attributes[0].indices[5] = count;
  EXPECT_EQ(compare(mesh, split)->verdict, Verdict::different);
  // No value is another than any value, and one that no corner has counts too.
  Mesh missing = other;
  missing.attributes[0].indices[5] = no_value;
  EXPECT_EQ(compare(mesh, missing)->verdict, Verdict::different);
  EXPECT_EQ(compare(missing, missing)->verdict, Verdict::same);
  Mesh more = other;
  more.attributes[0].data.resize(more.attributes[0].data.size() + 4);
  EXPECT_EQ(compare(mesh, more)->verdict, Verdict::different);
}

}  // namespace
}  // namespace clers::internal

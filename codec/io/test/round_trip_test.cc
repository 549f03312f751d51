#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>

#include "codec/base/utf8.h"
#include "codec/io/test/meshes.h"

namespace clers::io {
namespace {

using Bits = std::vector<std::byte>;

// Any bits, but no NaN where a text could not tell its bits.
Attribute random_attribute(std::string name, Domain domain, Scalar scalar, unsigned components,
                           std::size_t count, bool any_nan) {
  Attribute a{std::move(name), domain, scalar, static_cast<std::uint8_t>(components), {}};
  a.data.resize(count * a.stride());
  const auto fill = [&]<class T>(T) {
    for (std::size_t i = 0; i < a.data.size() / sizeof(T); ++i) {
      T value;
      if constexpr (std::is_floating_point_v<T>) {
        using Word = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
        // rapidcheck's integers are small at first; shifted they reach the exponent.
        value = *rc::gen::oneOf(
            rc::gen::map(rc::gen::arbitrary<Word>(), [](Word w) { return std::bit_cast<T>(w); }),
            rc::gen::map(rc::gen::arbitrary<std::int16_t>(),
                         [](std::int16_t w) { return static_cast<T>(w) / T(100); }),
            rc::gen::element(std::numeric_limits<T>::infinity(), T(-0.0), T(1) / T(3),
                             std::numeric_limits<T>::denorm_min(), std::numeric_limits<T>::max()));
        if (std::isnan(value) && !any_nan) value = std::numeric_limits<T>::quiet_NaN();
      } else {
        value = *rc::gen::arbitrary<T>();
      }
      std::memcpy(a.data.data() + i * sizeof value, &value, sizeof value);
    }
  };
  switch (scalar) {
    case Scalar::int8: fill(std::int8_t{}); break;
    case Scalar::uint8: fill(std::uint8_t{}); break;
    case Scalar::int16: fill(std::int16_t{}); break;
    case Scalar::uint16: fill(std::uint16_t{}); break;
    case Scalar::int32: fill(std::int32_t{}); break;
    case Scalar::uint32: fill(std::uint32_t{}); break;
    case Scalar::float32: fill(float{}); break;
    case Scalar::float64: fill(double{}); break;
    default: break;
  }
  return a;
}

Mesh random_faces(std::uint32_t least_size, std::uint32_t most_size) {
  Mesh mesh;
  mesh.vertex_count = *rc::gen::inRange<std::uint32_t>(1, 20);
  const std::size_t faces = *rc::gen::inRange<std::size_t>(0, 8);
  bool triangles = true;
  for (std::size_t f = 0; f < faces; ++f) {
    mesh.face_sizes.push_back(*rc::gen::inRange(least_size, most_size + 1));
    triangles = triangles && mesh.face_sizes.back() == 3;
    for (std::uint32_t i = 0; i < mesh.face_sizes.back(); ++i)
      mesh.corners.push_back(*rc::gen::inRange<std::uint32_t>(0, mesh.vertex_count));
  }
  if (triangles) mesh.face_sizes.clear();
  return mesh;
}

std::size_t count(const Mesh& mesh, Domain domain) {
  return domain == Domain::vertex   ? mesh.vertex_count
         : domain == Domain::corner ? mesh.corners.size()
                                    : mesh.face_count();
}

void add(Mesh& mesh, std::string name, Domain domain, Scalar scalar, unsigned components,
         bool any_nan = false) {
  mesh.attributes.push_back(
      random_attribute(std::move(name), domain, scalar, components, count(mesh, domain), any_nan));
}

Scalar random_float() {
  return *rc::gen::element(Scalar::float32, Scalar::float64);
}

// UTF-8 of at most 255 bytes.
std::string random_name() {
  auto name = *rc::gen::arbitrary<std::string>();
  name.resize(std::min<std::size_t>(internal::first_not_utf8(name), 200));
  name.resize(internal::first_not_utf8(name));
  if (*rc::gen::arbitrary<bool>()) name += "\xc3\xbc";
  return name;
}

void ply_round_trip(Encoding encoding) {
  Mesh mesh = random_faces(0, 12);
  mesh.name = random_name();
  add(mesh, "first", Domain::vertex, Scalar::uint8, 1);
  const int n = *rc::gen::inRange(0, 8);
  for (int i = 0; i < n; ++i) {
    std::string name = *rc::gen::oneOf(
        rc::gen::element<std::string>("position", "normal", "color", "texcoord", "x", "y", "z", "s",
                                      "t", "u", "v", "red", "green", "blue", "alpha", "a", "a_1",
                                      "vertex_index", "list"),
        rc::gen::exec([] { return random_name(); }));
    const Domain domain = *rc::gen::element(Domain::vertex, Domain::corner, Domain::face);
    const bool used =
        std::any_of(mesh.attributes.begin(), mesh.attributes.end(),
                    [&](const Attribute& a) { return a.name == name && a.domain == domain; });
    const Scalar scalar =
        *rc::gen::element(Scalar::int8, Scalar::uint8, Scalar::int16, Scalar::uint16, Scalar::int32,
                          Scalar::uint32, Scalar::float32, Scalar::float64);
    if (!used)
      add(mesh, std::move(name), domain, scalar, *rc::gen::inRange(1u, 6u),
          encoding == Encoding::binary);
  }
  const WriteResult written = must_write(mesh, Format::ply, encoding);
  const ::testing::AssertionResult result =
      same(must_read(written.bytes, Format::ply).meshes[0], mesh);
  RC_ASSERT(result);
  RC_ASSERT(written.notes.empty());
}

RC_GTEST_PROP(RoundTrip, BinaryPlyKeepsEverything, ()) {
  ply_round_trip(Encoding::binary);
}
RC_GTEST_PROP(RoundTrip, TextPlyKeepsEverything, ()) {
  ply_round_trip(Encoding::text);
}

// A format without types may call float64 values float32 if they are.
void narrow_as(Mesh& mesh, const Mesh& read) {
  for (Attribute& a : mesh.attributes)
    for (const Attribute& b : read.attributes)
      if (a.name == b.name && a.domain == b.domain && a.scalar == Scalar::float64 &&
          b.scalar == Scalar::float32) {
        std::vector<float> values;
        for (const double wide : values_of<double>(a)) {
          values.push_back(static_cast<float>(wide));
          RC_ASSERT(std::isnan(wide) || static_cast<double>(values.back()) == wide);
        }
        a = attribute(a.name, a.domain, a.components, values);
      }
}

RC_GTEST_PROP(RoundTrip, ObjKeepsPositionsColoursAndCorners, ()) {
  Mesh mesh = random_faces(1, 12);
  add(mesh, "position", Domain::vertex, random_float(), 3);
  if (*rc::gen::arbitrary<bool>())
    add(mesh, "color", Domain::vertex, random_float(), *rc::gen::inRange(3u, 5u));
  if (*rc::gen::arbitrary<bool>() && !mesh.corners.empty())
    add(mesh, "texcoord", Domain::corner, random_float(), *rc::gen::inRange(1u, 4u));
  if (*rc::gen::arbitrary<bool>() && !mesh.corners.empty())
    add(mesh, "normal", Domain::corner, random_float(), 3);
  const WriteResult written = must_write(mesh, Format::obj);
  Mesh read = must_read(written.bytes, Format::obj).meshes[0];
  // Colours that are 255ths all come back as bytes, which is said.
  std::size_t as_bytes = 0;
  for (Attribute& a : read.attributes) {
    if (a.scalar != Scalar::uint8) continue;
    ++as_bytes;
    std::vector<float> values;
    for (const std::uint8_t k : values_of<std::uint8_t>(a))
      values.push_back(static_cast<float>(k) / 255);
    a = attribute(a.name, a.domain, a.components, values);
  }
  RC_ASSERT(written.notes.size() == as_bytes);
  narrow_as(mesh, read);
  RC_ASSERT(same(read, mesh));
}

RC_GTEST_PROP(RoundTrip, OffKeepsVerticesAndColours, ()) {
  Mesh mesh = random_faces(0, 12);
  const auto color = [] {
    return *rc::gen::element(Scalar::uint8, Scalar::float32, Scalar::float64);
  };
  add(mesh, "position", Domain::vertex, random_float(), 3);
  if (*rc::gen::arbitrary<bool>()) add(mesh, "normal", Domain::vertex, random_float(), 3);
  if (*rc::gen::arbitrary<bool>())
    add(mesh, "color", Domain::vertex, color(), *rc::gen::inRange(3u, 5u));
  if (*rc::gen::arbitrary<bool>()) add(mesh, "texcoord", Domain::vertex, random_float(), 2);
  if (*rc::gen::arbitrary<bool>() && mesh.face_count() > 0)
    add(mesh, "color", Domain::face, color(), *rc::gen::inRange(3u, 5u));
  const WriteResult written = must_write(mesh, Format::off);
  RC_ASSERT(written.notes.empty());
  const Mesh read = must_read(written.bytes, Format::off).meshes[0];
  narrow_as(mesh, read);
  RC_ASSERT(same(read, mesh));
}

// Every corner keeps its position, bit for bit; vertices are numbered anew.
RC_GTEST_PROP(RoundTrip, StlKeepsCorners, ()) {
  Mesh mesh = random_faces(3, 3);
  const Encoding encoding = *rc::gen::element(Encoding::text, Encoding::binary);
  add(mesh, "position", Domain::vertex, Scalar::float32, 3, encoding == Encoding::binary);
  const WriteResult written = must_write(mesh, Format::stl, encoding);
  const Mesh read = must_read(written.bytes, Format::stl).meshes[0];
  const auto places = [](const Mesh& m) {
    std::vector<Bits> list;
    for (const std::uint32_t v : m.corners) {
      const std::byte* from = m.position()->data.data() + v * m.position()->stride();
      list.emplace_back(from, from + m.position()->stride());
    }
    return list;
  };
  RC_ASSERT(read.corners.size() == mesh.corners.size());
  RC_ASSERT(mesh.corners.empty() || places(read) == places(mesh));
}

TEST(Write, RefusesInconsistentMeshes) {
  const auto refuses = [](auto change) {
    Mesh mesh;
    mesh.vertex_count = 3;
    mesh.corners = {0, 1, 2};
    mesh.attributes = {attribute<float>("position", Domain::vertex, 3, std::vector<float>(9, 0))};
    EXPECT_TRUE(write({&mesh, 1}, Format::ply).ok());
    change(mesh);
    for (const Format format : {Format::ply, Format::obj, Format::off, Format::stl}) {
      const Expected<WriteResult> result = write({&mesh, 1}, format);
      ASSERT_FALSE(result.ok());
      EXPECT_EQ(result.error().code, ErrorCode::inconsistent_mesh);
    }
  };
  refuses([](Mesh& m) { m.corners.push_back(0); });
  refuses([](Mesh& m) { m.face_sizes = {4}; });
  refuses([](Mesh& m) { m.corners[2] = 3; });
  refuses([](Mesh& m) { m.attributes[0].data.pop_back(); });
  refuses([](Mesh& m) { m.attributes[0].components = 0; });
  refuses([](Mesh& m) { m.attributes[0].scalar = static_cast<Scalar>(10); });
  refuses([](Mesh& m) { m.attributes[0].domain = static_cast<Domain>(3); });
  refuses([](Mesh& m) { m.attributes.push_back(m.attributes[0]); });
}

TEST(Write, NeedsPositions) {
  Mesh mesh;
  mesh.vertex_count = 3;
  mesh.corners = {0, 1, 2};
  for (const Format format : {Format::ply, Format::obj, Format::off, Format::stl}) {
    const Expected<WriteResult> result = write({&mesh, 1}, format);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::unsupported);
  }
}

TEST(Write, AnEmptyMeshReadsBack) {
  const Mesh mesh;
  for (const Format format : {Format::ply, Format::obj, Format::off, Format::stl}) {
    const Mesh read = must_read(must_write(mesh, format).bytes, format).meshes[0];
    EXPECT_EQ(read.vertex_count, 0u);
    EXPECT_EQ(read.face_count(), 0u);
  }
  // No mesh at all is an OBJ, too, and like the others no file of no bytes.
  const Expected<WriteResult> none = write({}, Format::obj);
  ASSERT_TRUE(none.ok());
  EXPECT_EQ(must_read(none->bytes, Format::obj).meshes[0].vertex_count, 0u);
}

TEST(Write, NotesNaNsThatTextCannotTell) {
  Mesh mesh;
  mesh.vertex_count = 1;
  mesh.attributes = {
      attribute<float>("position", Domain::vertex, 3, {0, std::bit_cast<float>(0x7fc00001u), 0})};
  EXPECT_TRUE(notes_say(must_write(mesh, Format::obj).notes, "the bits of 1 NaN"));
  EXPECT_TRUE(notes_say(must_write(mesh, Format::off).notes, "the bits of 1 NaN"));
  EXPECT_TRUE(notes_say(must_write(mesh, Format::ply, Encoding::text).notes, "the bits of 1 NaN"));
  EXPECT_TRUE(must_write(mesh, Format::ply).notes.empty());
}

TEST(Format, ComesFromAName) {
  EXPECT_EQ(format_of("a/b.c/mesh.PLY"), Format::ply);
  EXPECT_EQ(format_of("obj"), Format::obj);
  EXPECT_EQ(format_of(".off"), Format::off);
  EXPECT_EQ(format_of("x.y.Stl"), Format::stl);
  EXPECT_EQ(format_of("mesh.gltf"), std::nullopt);
  EXPECT_EQ(format_of(""), std::nullopt);
  EXPECT_EQ(format_of("ply.gz"), std::nullopt);
}

}  // namespace
}  // namespace clers::io

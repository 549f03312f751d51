#include <bit>
#include <limits>

#include "codec/io/test/meshes.h"

namespace clers::io {
namespace {

// The values of a body, printed or packed as a format wants them.
class Body {
 public:
  enum Format { ascii, little, big };
  explicit Body(Format format) : format_(format) {}

  template <class T>
  Body& add(T value) {
    if (format_ == ascii) {
      if constexpr (sizeof(T) == 1)
        text_ += std::to_string(static_cast<int>(value)) + " ";
      else
        text_ += std::to_string(value) + " ";
      return *this;
    }
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof value);
    if ((format_ == big) == (std::endian::native == std::endian::little))
      std::reverse(bytes, bytes + sizeof bytes);
    text_.append(bytes, sizeof bytes);
    return *this;
  }
  std::string file(const std::string& header) const {
    constexpr const char* names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    return std::string("ply\nformat ") + names[format_] + " 1.0\n" + header + "end_header\n" +
           text_;
  }

 private:
  Format format_;
  std::string text_;
};

class EveryPly : public ::testing::TestWithParam<Body::Format> {};
INSTANTIATE_TEST_SUITE_P(Formats, EveryPly,
                         ::testing::Values(Body::ascii, Body::little, Body::big));

TEST_P(EveryPly, KeepsEveryTypeOfProperty) {
  const std::string header =
      "element vertex 2\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property char a\nproperty uchar b\nproperty short c\nproperty ushort d\n"
      "property int e\nproperty uint f\nproperty double g\n"
      "property int8 h\nproperty uint8 i\nproperty int16 j\nproperty uint16 k\n"
      "property int32 l\nproperty uint32 m\nproperty float32 n\nproperty float64 o\n";
  Body body(GetParam());
  for (const int sign : {1, -1}) {
    for (const float x : {1.5f, 2.25f, -3.0f}) body.add(x * static_cast<float>(sign));
    for (int twice = 0; twice < 2; ++twice) {
      body.add<std::int8_t>(sign > 0 ? 127 : -128).add<std::uint8_t>(sign > 0 ? 255 : 0);
      body.add<std::int16_t>(sign > 0 ? 32767 : -32768).add<std::uint16_t>(sign > 0 ? 65535 : 7);
      body.add<std::int32_t>(sign > 0 ? 2147483647 : -2147483647 - 1)
          .add<std::uint32_t>(sign > 0 ? 4294967295u : 9u);
      if (twice) body.add(0.5f);
      body.add(sign * 1048576.125);
    }
  }
  const Mesh mesh = must_read(body.file(header), Format::ply).meshes[0];
  ASSERT_EQ(mesh.attributes.size(), 16u);
  const auto get_vertex = [&](const char* name) { return get(mesh, name, Domain::vertex); };
  EXPECT_EQ(values_of<float>(get_vertex("position")),
            (std::vector{1.5f, 2.25f, -3.0f, -1.5f, -2.25f, 3.0f}));
  for (const char* name : {"a", "h"})
    EXPECT_EQ(values_of<std::int8_t>(get_vertex(name)), (std::vector<std::int8_t>{127, -128}));
  for (const char* name : {"b", "i"})
    EXPECT_EQ(values_of<std::uint8_t>(get_vertex(name)), (std::vector<std::uint8_t>{255, 0}));
  for (const char* name : {"c", "j"})
    EXPECT_EQ(values_of<std::int16_t>(get_vertex(name)),
              (std::vector<std::int16_t>{32767, -32768}));
  for (const char* name : {"d", "k"})
    EXPECT_EQ(values_of<std::uint16_t>(get_vertex(name)), (std::vector<std::uint16_t>{65535, 7}));
  for (const char* name : {"e", "l"})
    EXPECT_EQ(values_of<std::int32_t>(get_vertex(name)),
              (std::vector{2147483647, -2147483647 - 1}));
  for (const char* name : {"f", "m"})
    EXPECT_EQ(values_of<std::uint32_t>(get_vertex(name)), (std::vector{4294967295u, 9u}));
  for (const char* name : {"g", "o"})
    EXPECT_EQ(values_of<double>(get_vertex(name)), (std::vector{1048576.125, -1048576.125}));
  EXPECT_EQ(values_of<float>(get_vertex("n")), (std::vector{0.5f, 0.5f}));
}

TEST_P(EveryPly, ReadsIndicesOfEveryType) {
  const auto faces = [&](const char* count_type, const char* type, auto count, auto index) {
    Body body(GetParam());
    for (int v = 0; v < 5; ++v) body.add(static_cast<float>(v));
    using Count = decltype(count);
    using Index = decltype(index);
    body.add(Count{3});
    for (const int i : {0, 1, 2}) body.add(static_cast<Index>(i));
    body.add(Count{4});
    for (const int i : {4, 3, 2, 1}) body.add(static_cast<Index>(i));
    const Mesh mesh = must_read(body.file("element vertex 5\nproperty float h\n"
                                          "element face 2\nproperty list " +
                                          std::string(count_type) + " " + type + " vertex_index\n"),
                                Format::ply)
                          .meshes[0];
    EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 4, 3, 2, 1}));
    EXPECT_EQ(mesh.face_sizes, (std::vector<std::uint32_t>{3, 4}));
  };
  faces("uchar", "char", std::uint8_t{}, std::int8_t{});
  faces("char", "uchar", std::int8_t{}, std::uint8_t{});
  faces("short", "ushort", std::int16_t{}, std::uint16_t{});
  faces("ushort", "short", std::uint16_t{}, std::int16_t{});
  faces("int", "uint", std::int32_t{}, std::uint32_t{});
  faces("uint", "int", std::uint32_t{}, std::int32_t{});
}

TEST_P(EveryPly, FacesHaveScalarsAndCornersHaveLists) {
  Body body(GetParam());
  for (int v = 0; v < 4; ++v) body.add(static_cast<float>(v));
  body.add<std::uint8_t>(3);
  for (const int i : {0, 1, 2}) body.add(i);
  body.add<std::uint8_t>(6);
  for (const float t : {0.f, 1.f, 2.f, 3.f, 4.f, 5.f}) body.add(t);
  body.add<std::uint8_t>(2).add(7).add(7).add<std::uint8_t>(200);
  body.add<std::uint8_t>(4);
  for (const int i : {3, 2, 1, 0}) body.add(i);
  body.add<std::uint8_t>(8);
  for (const float t : {6.f, 7.f, 8.f, 9.f, 10.f, 11.f, 12.f, 13.f}) body.add(t);
  body.add<std::uint8_t>(1).add(7).add<std::uint8_t>(100);
  const ReadResult result = must_read(body.file("element vertex 4\nproperty float h\n"
                                                "element face 2\n"
                                                "property list uchar int vertex_indices\n"
                                                "property list uchar float texcoord\n"
                                                "property list uchar int other\n"
                                                "property uchar quality\n"),
                                      Format::ply);
  const Mesh& mesh = result.meshes[0];
  ASSERT_EQ(mesh.attributes.size(), 5u);
  const Attribute& texcoord = get(mesh, "texcoord", Domain::corner);
  EXPECT_EQ(texcoord.components, 2);
  EXPECT_EQ(values_of<float>(texcoord).back(), 13.f);
  EXPECT_EQ(values_of<std::uint8_t>(get(mesh, "quality", Domain::face)),
            (std::vector<std::uint8_t>{200, 100}));
  // Lists whose lengths differ.
  EXPECT_TRUE(result.notes.empty());
  EXPECT_EQ(metadata_of(mesh, "ply.properties"), "face-lists other other 2");
  EXPECT_EQ(get(mesh, "other.1", Domain::face).indices, (std::vector<std::uint32_t>{0, no_value}));
  const WriteResult written = must_write(mesh, Format::ply);
  EXPECT_TRUE(written.notes.empty());
  const Mesh again = must_read(written.bytes, Format::ply).meshes[0];
  EXPECT_TRUE(same(again, mesh));
  EXPECT_EQ(metadata_of(again, "ply.properties"), metadata_of(mesh, "ply.properties"));
}

TEST(Ply, TheCornersOfSomeFacesHaveNoValues) {
  const std::string file =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 3\nproperty list uchar int vertex_indices\n"
      "property list uchar float texcoord\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
      "3 0 1 2 0\n3 1 2 0 6 1 2 3 4 5 6\n3 2 1 0 0\n";
  const Mesh mesh = must_read(file, Format::ply).meshes[0];
  const Attribute& texcoord = get(mesh, "texcoord", Domain::corner);
  constexpr std::uint32_t n = no_value;
  EXPECT_EQ(texcoord.components, 2);
  EXPECT_EQ(texcoord.indices, (std::vector<std::uint32_t>{n, n, n, 0, 1, 2, n, n, n}));
  const WriteResult written = must_write(mesh, Format::ply, Encoding::text);
  EXPECT_TRUE(written.notes.empty());
  EXPECT_EQ(text_of(written.bytes), file);
}

TEST(Ply, NoCornerHasAValue) {
  const Mesh mesh = must_read("v 0 0 0\nvt 1 1\nf 1 1 1\n", Format::obj).meshes[0];
  const WriteResult written = must_write(mesh, Format::ply, Encoding::text);
  const Mesh again = must_read(written.bytes, Format::ply).meshes[0];
  EXPECT_EQ(get(again, "texcoord", Domain::corner).components, 2);
  EXPECT_TRUE(same(again, mesh));
}

TEST(Ply, MissingValuesOfVerticesBecomeZeros) {
  Mesh mesh;
  mesh.vertex_count = 2;
  mesh.attributes = {attribute<float>("a", Domain::vertex, 1, {7}),
                     attribute<std::uint8_t>("b.0", Domain::vertex, 1, {1, 2}),
                     attribute<std::uint8_t>("b.1", Domain::vertex, 1, {3})};
  mesh.attributes[0].indices = {no_value, 0};
  mesh.attributes[2].indices = {0, no_value};
  const WriteResult written = must_write(mesh, Format::ply);
  EXPECT_TRUE(notes_say(written.notes, "'a' (1 x float32): 1 missing value became zeros"));
  const Mesh again = must_read(written.bytes, Format::ply).meshes[0];
  EXPECT_EQ(values_of<float>(get(again, "a", Domain::vertex)), (std::vector<float>{0, 7}));
  // Without the names of the lists, they are three properties.
  EXPECT_TRUE(notes_say(written.notes, "'b.1' (1 x uint8): 1 missing value became zeros"));
  EXPECT_EQ(again.attributes.size(), 3u);
}

TEST_P(EveryPly, ElementsMayComeInAnyOrderAndOthersAreNoted) {
  Body body(GetParam());
  body.add<std::uint8_t>(3);
  for (const int i : {0, 1, 2}) body.add(i);
  body.add(1).add(2).add<std::uint8_t>(1).add(0.5f);
  for (int v = 0; v < 3; ++v) body.add(static_cast<float>(v));
  const ReadResult result = must_read(
      body.file("comment one\nobj_info two\ncomment three\n"
                "element face 1\nproperty list uchar int vertex_indices\n"
                "element edge 1\nproperty int v1\nproperty int v2\nproperty list uchar float w\n"
                "element vertex 3\nproperty float h\n"),
      Format::ply);
  EXPECT_EQ(result.meshes[0].corners, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_TRUE(result.meshes[0].triangles_only());
  EXPECT_TRUE(notes_say(result.notes, "1 element was left out: not part of a mesh: 'edge'"));
  EXPECT_EQ(metadata_of(result.meshes[0], "comment"), " one\n three");
  EXPECT_EQ(metadata_of(result.meshes[0], "obj_info"), " two");
}

// Two strips, the second with a restart and with vertices that are repeated to join.
TEST_P(EveryPly, StripsBecomeTriangles) {
  Body body(GetParam());
  for (int v = 0; v < 6; ++v) body.add(static_cast<float>(v));
  body.add(5);
  for (const int i : {0, 1, 2, 3, 4}) body.add(i);
  body.add(9);
  for (const int i : {0, 1, 2, -1, 3, 4, 5, 5, 0}) body.add(i);
  const ReadResult result = must_read(body.file("element vertex 6\nproperty float h\n"
                                                "element tristrips 2\n"
                                                "property list int int vertex_indices\n"),
                                      Format::ply);
  EXPECT_EQ(result.meshes[0].corners, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3, 2, 3, 4,  //
                                                                  0, 1, 2, 3, 4, 5}));
  EXPECT_TRUE(notes_say(result.notes, "2 triangle strips became 5 faces"));
  EXPECT_TRUE(notes_say(result.notes, "2 places"));
}

TEST(Ply, StripsBesideAnElementFaceWithoutEntries) {
  const std::string vertices = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float h\n";
  const std::string faces =
      "element face 0\nproperty list uchar int vertex_indices\nproperty float quality\n";
  const std::string strips = "element tristrips 1\nproperty list uchar int vertex_indices\n";
  for (const std::string& header : {vertices + faces + strips, vertices + strips + faces}) {
    const Mesh mesh = must_read(header + "end_header\n1 2 3\n3 0 1 2\n", Format::ply).meshes[0];
    EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(mesh.attributes.size(), 1u);
  }
}

TEST(Ply, ConventionalNamesBecomeAttributes) {
  const Mesh mesh = must_read(
                        "ply\r\nformat ascii 1.0\r\nelement vertex 1\r\n"
                        "property float nx\r\nproperty float ny\r\nproperty float nz\r\n"
                        "property double z\r\nproperty double y\r\nproperty double x\r\n"
                        "property float u\r\nproperty float v\r\nproperty float s\r\n"
                        "property uchar red\r\nproperty uchar green\r\nproperty uchar blue\r\n"
                        "property uchar alpha\r\nproperty float quality\r\n"
                        "end_header\r\n"
                        "1 2 3 6 5 4 7 8 9 10 11 12 13 14\r\n",
                        Format::ply)
                        .meshes[0];
  ASSERT_EQ(mesh.attributes.size(), 6u);
  EXPECT_EQ(values_of<float>(get(mesh, "normal", Domain::vertex)), (std::vector{1.f, 2.f, 3.f}));
  EXPECT_EQ(values_of<double>(get(mesh, "position", Domain::vertex)), (std::vector{4., 5., 6.}));
  EXPECT_EQ(values_of<float>(get(mesh, "texcoord", Domain::vertex)), (std::vector{7.f, 8.f}));
  EXPECT_EQ(values_of<float>(get(mesh, "s", Domain::vertex)), (std::vector{9.f}));
  EXPECT_EQ(values_of<std::uint8_t>(get(mesh, "color", Domain::vertex)),
            (std::vector<std::uint8_t>{10, 11, 12, 13}));
  EXPECT_EQ(values_of<float>(get(mesh, "quality", Domain::vertex)), (std::vector{14.f}));
}

TEST(Ply, PositionsOfDifferentTypesBecomeTheWidestFloat) {
  const auto type_of = [](const char* x, const char* y, const char* z) {
    const Mesh mesh =
        must_read(std::string("ply\nformat ascii 1.0\nelement vertex 1\nproperty ") + x +
                      " x\nproperty " + y + " y\nproperty " + z + " z\nend_header\n1 2 3\n",
                  Format::ply)
            .meshes[0];
    return mesh.position()->scalar;
  };
  EXPECT_EQ(type_of("int", "int", "int"), Scalar::int32);
  EXPECT_EQ(type_of("double", "double", "double"), Scalar::float64);
  EXPECT_EQ(type_of("float", "double", "float"), Scalar::float64);
  EXPECT_EQ(type_of("float", "float", "int"), Scalar::float64);
  EXPECT_EQ(type_of("float", "float", "short"), Scalar::float32);
  EXPECT_EQ(type_of("uchar", "short", "short"), Scalar::float32);
}

TEST(Ply, TextValuesMayRunOverLines) {
  const Mesh mesh = must_read(
                        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                        "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                        "1e-400 +2\n\n inf\t3 0\n1 2",
                        Format::ply)
                        .meshes[0];
  EXPECT_EQ(values_of<float>(mesh.attributes[0]),
            (std::vector{0.f, 2.f, std::numeric_limits<float>::infinity()}));
}

TEST(Ply, BytesAfterABinaryBodyAreNoted) {
  const ReadResult result = must_read(
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar a\nend_header\nAxyz",
      Format::ply);
  EXPECT_TRUE(notes_say(result.notes, "3 bytes were left out: after the last element"));
}

TEST(Ply, WriterUsesTheConventionalNames) {
  Mesh mesh;
  mesh.vertex_count = 3;
  mesh.corners = {0, 1, 2};
  mesh.name = "a b";
  mesh.attributes = {
      attribute<float>("position", Domain::vertex, 3, {0, 0, 0, 1, 0, 0, 0, 1, 0}),
      attribute<std::uint8_t>("color", Domain::face, 3, {1, 2, 3}),
      attribute<float>("texcoord", Domain::corner, 2, {0, 0, 1, 0, 0, 1}),
      attribute<float>("w\nx", Domain::vertex, 2, {1, 2, 3, 4, 5, 6}),
      attribute<std::int64_t>("id", Domain::vertex, 1, {1, 2, 3}),
  };
  const WriteResult written = must_write(mesh, Format::ply, Encoding::text);
  EXPECT_EQ(text_of(written.bytes),
            "ply\n"
            "format ascii 1.0\n"
            "comment clers mesh a%20b\n"
            "element vertex 3\n"
            "property float x\nproperty float y\nproperty float z\n"
            "comment clers attribute 2 w%0Ax\n"
            "property float w_x\nproperty float w_x_1\n"
            "element face 1\n"
            "property list uchar int vertex_indices\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\n"
            "property list uchar float texcoord\n"
            "end_header\n"
            "0 0 0 1 2\n1 0 0 3 4\n0 1 0 5 6\n"
            "3 0 1 2 1 2 3 6 0 0 1 0 0 1\n");
  EXPECT_TRUE(notes_say(written.notes,
                        "1 vertex attribute was left out: PLY has no 64-bit integers: 'id'"));
}

TEST(Ply, NamesThatCollideComeBack) {
  Mesh mesh;
  mesh.vertex_count = 1;
  for (const char* name : {"x", "y", "z", "x_", "position", "", "a b", "a_b", "a", "a_1",
                           "vertex_indices", "texcoord", "normal", "color", "red", "100%"})
    for (const Domain domain : {Domain::vertex, Domain::face, Domain::corner}) {
      const unsigned components = 1 + static_cast<unsigned>(mesh.attributes.size() % 4);
      mesh.attributes.push_back(
          attribute(name, domain, components,
                    std::vector<float>(domain == Domain::vertex ? components : 0, 0.1f)));
    }
  for (const Encoding encoding : {Encoding::text, Encoding::binary}) {
    const WriteResult written = must_write(mesh, Format::ply, encoding);
    EXPECT_TRUE(same(must_read(written.bytes, Format::ply).meshes[0], mesh));
  }
}

}  // namespace
}  // namespace clers::io

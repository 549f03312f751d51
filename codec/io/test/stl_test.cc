#include <cmath>
#include <limits>

#include "codec/io/test/meshes.h"

namespace clers::io {
namespace {

std::string little(float value) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  std::string text;
  for (int i = 0; i < 4; ++i) text += static_cast<char>(bits >> (8 * i));
  return text;
}

// Two triangles of a square; the first has a normal, the second attribute bytes.
std::string square(const std::string& header) {
  std::string file = header + std::string(80 - header.size(), '\0') + std::string("\2\0\0\0", 4);
  for (const float x : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f})
    file += little(x);
  file += std::string("\0\0", 2);
  for (const float x : {0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f})
    file += little(x);
  return file + "\7" + '\0';
}

TEST(Stl, WeldsABinaryFileEvenIfItBeginsWithSolid) {
  for (const char* header : {"", "solid but binary"}) {
    const ReadResult result = must_read(square(header), Format::stl);
    const Mesh& mesh = result.meshes[0];
    EXPECT_EQ(mesh.vertex_count, 4u);
    EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(values_of<float>(*mesh.position()),
              (std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
    for (const char* note : {"6 corners became 4 vertices", "1 facet normal came from the corners"})
      EXPECT_TRUE(notes_say(result.notes, note)) << note;
    EXPECT_EQ(values_of<std::uint16_t>(get(mesh, "stl.bits", Domain::face)),
              (std::vector<std::uint16_t>{0, 7}));
    const std::string back = text_of(must_write(mesh, Format::stl).bytes);
    EXPECT_EQ(back.substr(back.size() - 2), std::string("\7\0", 2));
    EXPECT_TRUE(notes_say(must_write(mesh, Format::stl, Encoding::text).notes, "'stl.bits'"));
  }
  EXPECT_TRUE(notes_say(must_read(square("") + "xyz", Format::stl).notes,
                        "3 bytes were left out: after the last triangle"));
}

TEST(Stl, WeldsByValueAndKeepsTheSignOfTheFirst) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::string file = std::string(80, '\0') + std::string("\1\0\0\0", 4);
  for (const float x : {0.f, 0.f, 0.f, -0.f, nan, 0.f, 0.f, nan, -0.f, 0.f, nan, -nan})
    file += little(x);
  const ReadResult result = must_read(file + std::string(2, '\0'), Format::stl);
  EXPECT_EQ(result.meshes[0].corners, (std::vector<std::uint32_t>{0, 0, 1}));
  EXPECT_TRUE(std::signbit(values_of<float>(*result.meshes[0].position())[0]));
  EXPECT_TRUE(notes_say(result.notes, "the signs of 2 zeros changed"));
}

constexpr char text_square[] =
    "SOLID my square\n"
    "  facet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1 0 0\n vertex 1 1 0\n endloop\n"
    "  endfacet\n"
    "  FACET NORMAL 0 0 0\n OUTER LOOP\n VERTEX 0 0 0\n VERTEX 1 1 0\n VERTEX 0 1 0\n ENDLOOP\n"
    "  ENDFACET\n"
    "endsolid my square\n";

TEST(Stl, ReadsText) {
  const ReadResult result = must_read(text_square, Format::stl);
  const Mesh& mesh = result.meshes[0];
  EXPECT_EQ(mesh.name, "my square");
  EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_TRUE(notes_say(result.notes, "1 facet normal came from the corners"));
  const ReadResult two = must_read(std::string(text_square) + text_square, Format::stl);
  EXPECT_EQ(two.meshes[0].face_count(), 4u);
  EXPECT_EQ(two.meshes[0].vertex_count, 4u);
  EXPECT_TRUE(notes_say(two.notes, "2 solids were left out: they became one mesh"));
}

TEST(Stl, WritesTrianglesAndPolygonsAsFans) {
  Mesh mesh = must_read(text_square, Format::stl).meshes[0];
  for (const Encoding encoding : {Encoding::text, Encoding::binary}) {
    Mesh read = must_read(must_write(mesh, Format::stl, encoding).bytes, Format::stl).meshes[0];
    if (encoding == Encoding::binary) read.name = mesh.name;
    EXPECT_TRUE(same(read, mesh));
  }
  EXPECT_EQ(must_write(mesh, Format::stl).bytes.size(), 84u + 2 * 50);
  mesh.face_sizes = {3, 3};
  EXPECT_EQ(must_write(mesh, Format::stl).bytes.size(), 84u + 2 * 50);
  mesh.face_sizes = {2, 4};
  const WriteResult fanned = must_write(mesh, Format::stl);
  EXPECT_TRUE(notes_say(fanned.notes, "1 polygon became 2 triangles"));
  EXPECT_TRUE(notes_say(fanned.notes, "1 face of fewer than three corners was left out"));
  EXPECT_EQ(fanned.bytes.size(), 84u + 2 * 50);
}

TEST(Stl, NotesWhatItCannotHold) {
  Mesh mesh;
  mesh.vertex_count = 4;
  mesh.corners = {0, 1, 2};
  mesh.name = "a";
  mesh.attributes = {
      attribute<double>("position", Domain::vertex, 3, {0, 0, 0, .5, .1, 0, 0, 1, 0, 9, 9, 1e300}),
      attribute<float>("quality", Domain::face, 1, {1}),
  };
  const WriteResult written = must_write(mesh, Format::stl);
  for (const char* note : {"1 coordinate was rounded to float32",
                           "1 coordinate is too large for float32 and became infinite",
                           "'quality' (1 x float32) was left", "1 vertex of no face was left out",
                           "the name 'a' was left out"})
    EXPECT_TRUE(notes_say(written.notes, note)) << note;
}

}  // namespace
}  // namespace clers::io

#include "codec/io/test/meshes.h"

namespace clers::io {
namespace {

TEST(Off, ReadsEveryKindOfVertex) {
  const Mesh mesh = must_read(
                        "# made by hand\nSTCNOFF # kind\n\n3 2 # no edges\n"
                        "0 0 0  0 0 1  255 0 0 255  0.5 1\n"
                        "1 0 0  0 0 1  0 255 0 255  0 1\n"
                        "0 1 0  0 0 1  0 0 255 0  1 1\n"
                        "3 0 1 2\n3\n2 1\n0\n",
                        Format::off)
                        .meshes[0];
  EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 0}));
  ASSERT_EQ(mesh.attributes.size(), 4u);
  EXPECT_EQ(values_of<float>(*mesh.position())[7], 1.f);
  EXPECT_EQ(values_of<float>(get(mesh, "normal", Domain::vertex))[2], 1.f);
  EXPECT_EQ(values_of<std::uint8_t>(get(mesh, "color", Domain::vertex))[5], 255);
  EXPECT_EQ(get(mesh, "color", Domain::vertex).components, 4);
  EXPECT_EQ(values_of<float>(get(mesh, "texcoord", Domain::vertex))[0], .5f);
}

TEST(Off, ColoursAreBytesIfAllAreWholeAndSmall) {
  const auto scalar = [](const char* colors) {
    return get(must_read("COFF\n1 0 0\n0 0 0 " + std::string(colors) + "\n", Format::off).meshes[0],
               "color", Domain::vertex)
        .scalar;
  };
  EXPECT_EQ(scalar("0 1 255"), Scalar::uint8);
  EXPECT_EQ(scalar("0 1 1.0"), Scalar::float32);
  EXPECT_EQ(scalar("0 1 256"), Scalar::float32);
  EXPECT_EQ(scalar("0 1 -1"), Scalar::float32);
}

TEST(Off, ColoursOfFacesAreKept) {
  const std::string start = "OFF 3 2 0\n0 0 0\n1 0 0\n0 1 0\n";
  const Mesh mesh = must_read(start + "3 0 1 2 1 2 3\n2 0 1 4 5 6", Format::off).meshes[0];
  EXPECT_EQ(mesh.face_sizes, (std::vector<std::uint32_t>{3, 2}));
  EXPECT_EQ(values_of<std::uint8_t>(get(mesh, "color", Domain::face)),
            (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6}));
  const Mesh some = must_read(start + "3 0 1 2\n3 0 1 2 1 2 3\n", Format::off).meshes[0];
  EXPECT_EQ(get(some, "color", Domain::face).indices, (std::vector<std::uint32_t>{no_value, 0}));
  EXPECT_EQ(text_of(must_write(some, Format::off).bytes),
            "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2 1 2 3\n");
  for (const char* faces : {"3 0 1 2 1 2 3\n3 0 1 2 1 2 3 4\n", "3 0 1 2 7\n3 0 1 2 8 8 8\n"}) {
    const ReadResult result = must_read(start + faces, Format::off);
    EXPECT_EQ(result.meshes[0].attributes.size(), 1u);
    EXPECT_TRUE(notes_say(result.notes, "left out")) << faces;
  }
}

TEST(Off, SomeVerticesHaveNoColour) {
  const std::string file = "OFF\n2 0 0\n0 0 0\n1 0 0 1 2 3\n";
  Mesh mesh = must_read(file, Format::off).meshes[0];
  EXPECT_EQ(get(mesh, "color", Domain::vertex).indices, (std::vector<std::uint32_t>{no_value, 0}));
  WriteResult written = must_write(mesh, Format::off);
  EXPECT_EQ(text_of(written.bytes), file);
  EXPECT_TRUE(written.notes.empty());
  // With other values beside them every line has to have one.
  mesh.attributes.push_back(attribute<float>("normal", Domain::vertex, 3, {0, 0, 1, 0, 0, 1}));
  written = must_write(mesh, Format::off);
  EXPECT_TRUE(notes_say(written.notes, "1 missing value became zeros"));
  EXPECT_NE(text_of(written.bytes).find("0 0 0 0 0 1 0 0 0"), std::string::npos);
}

TEST(Off, Writes) {
  Mesh mesh;
  mesh.vertex_count = 2;
  mesh.corners = {0, 1, 0, 1};
  mesh.face_sizes = {4};
  mesh.name = "a";
  mesh.attributes = {
      attribute<float>("position", Domain::vertex, 3, {.1f, 2, 3, 4, 5, 6}),
      attribute<float>("color", Domain::vertex, 3, {0, 1, .5f, 0, 0, 256}),
      attribute<std::uint8_t>("color", Domain::face, 4, {1, 2, 3, 4}),
      attribute<float>("normal", Domain::corner, 3, std::vector<float>(12, 0)),
  };
  const WriteResult written = must_write(mesh, Format::off);
  EXPECT_EQ(text_of(written.bytes),
            "COFF\n2 1 0\n0.1 2 3 0.0 1.0 0.5\n4 5 6 0.0 0.0 256\n4 0 1 0 1 1 2 3 4\n");
  EXPECT_TRUE(notes_say(written.notes, "corner attribute 'normal' (3 x float32) was left out"));
  EXPECT_TRUE(notes_say(written.notes, "the name 'a' was left out"));
}

}  // namespace
}  // namespace clers::io

#include <cmath>

#include "codec/io/test/meshes.h"

namespace clers::io {
namespace {

TEST(Obj, ReadsPolygonsOfAnySize) {
  std::string file;
  for (int i = 0; i < 1000; ++i) file += "v " + std::to_string(i) + " 0 0\n";
  file += "f 1 2 3\nf";
  for (int i = 1; i <= 1000; ++i) file += " " + std::to_string(i);
  const Mesh mesh = must_read(file, Format::obj).meshes[0];
  EXPECT_EQ(mesh.vertex_count, 1000u);
  EXPECT_EQ(mesh.face_sizes, (std::vector<std::uint32_t>{3, 1000}));
  EXPECT_EQ(mesh.corners[3], 0u);
  EXPECT_EQ(mesh.corners.back(), 999u);
}

TEST(Obj, ReadsEveryFormOfCorner) {
  const std::string values = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt .5\nvt 1 2\nvn 0 0 1\nvn 0 1 0\n";
  const auto attributes = [&](const char* face) {
    const Mesh mesh = must_read(values + face, Format::obj).meshes[0];
    EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2})) << face;
    std::string names;
    for (const Attribute& a : mesh.attributes)
      if (std::any_of(a.indices.begin(), a.indices.end(), [](auto i) { return i != no_value; }))
        names += a.name + " ";
    return names;
  };
  EXPECT_EQ(attributes("f 1 2 3"), "");
  EXPECT_EQ(attributes("f -3 -2 -1"), "");
  EXPECT_EQ(attributes("f 1/1 2/2 3/1"), "texcoord ");
  EXPECT_EQ(attributes("f 1/1/ 2/2/ 3/1/"), "texcoord ");
  EXPECT_EQ(attributes("f 1//1 2//2 3//1"), "normal ");
  EXPECT_EQ(attributes("f -3/-2/-2 -2/-1/-1 -1/-2/-2"), "texcoord normal ");
  EXPECT_EQ(attributes("f 1/1 2 3/1"), "texcoord ");
  const Mesh mesh = must_read(values + "f 1/1/2 2/2/1 3/1/1", Format::obj).meshes[0];
  const Attribute& texcoord = get(mesh, "texcoord", Domain::corner);
  EXPECT_EQ(texcoord.components, 2);
  EXPECT_EQ(values_of<float>(texcoord), (std::vector{.5f, 0.f, 1.f, 2.f}));
  EXPECT_EQ(texcoord.indices, (std::vector<std::uint32_t>{0, 1, 0}));
  const Attribute& normal = get(mesh, "normal", Domain::corner);
  EXPECT_EQ(values_of<float>(normal), (std::vector{0.f, 0.f, 1.f, 0.f, 1.f, 0.f}));
  EXPECT_EQ(normal.indices, (std::vector<std::uint32_t>{1, 0, 0}));
}

TEST(Obj, NotesWhatIsLeftOut) {
  const ReadResult result = must_read(
      "v 0 0 0 2\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/0 2/1 3\nl 1 2\ng a \\\nb c\n"
      "mg 1 .5\n",
      Format::obj);
  for (const char* note : {"1 vertex weight was", "1 line was left out",
                           "1 index 0 was left out: of normals", "1 merging group was left out",
                           "part of a name before it, which ends in a backslash, such as 'b c'"})
    EXPECT_TRUE(notes_say(result.notes, note)) << note;
  EXPECT_EQ(result.notes.size(), 5u);

  const ReadResult unused = must_read("v 0 0 0\nvt 0\nvt 1\n", Format::obj);
  EXPECT_TRUE(notes_say(unused.notes,
                        "2 texture coordinates were left out: there are no faces to use them"));
}

TEST(Obj, SomeCornersHaveNoValue) {
  const Mesh mesh = must_read(
                        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvt 1 1\nvt 7 7\n"
                        "f 1 2 3\nf 1/3 2 3/2\nf 1 2 3\n",
                        Format::obj)
                        .meshes[0];
  const Attribute& texcoord = get(mesh, "texcoord", Domain::corner);
  // Of the equal ones each is kept, and the one that no face uses.
  EXPECT_EQ(values_of<float>(texcoord), (std::vector{0.f, 0.f, 1.f, 1.f, 1.f, 1.f, 7.f, 7.f}));
  constexpr std::uint32_t n = no_value;
  EXPECT_EQ(texcoord.indices, (std::vector<std::uint32_t>{n, n, n, 2, n, 1, n, n, n}));
  const std::string text = text_of(must_write(mesh, Format::obj).bytes);
  EXPECT_NE(text.find("vt 7 7\nf 1 2 3\nf 1/3 2 3/2\nf 1 2 3\n"), text.npos) << text;
  EXPECT_TRUE(same(must_read(text, Format::obj).meshes[0], mesh));
}

TEST(Obj, StatesOfFacesAreAttributes) {
  const std::string file =
      "mtllib a.mtl\nmtllib b c.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no one\ng left right\n"
      "usemtl red\ns 1\nf 2 3 1\no two\ng\nusemtl blue\ns off\nf 3 2 1\nusemtl unused\n";
  const Mesh mesh = must_read(file, Format::obj).meshes[0];
  constexpr std::uint32_t n = no_value;
  for (const char* name : {"object", "group", "material", "smoothing"})
    EXPECT_EQ(get(mesh, name, Domain::face).indices, (std::vector<std::uint32_t>{n, 0, 1})) << name;
  EXPECT_EQ(metadata_of(mesh, "obj.objects"), "one\ntwo");
  EXPECT_EQ(metadata_of(mesh, "obj.groups"), "left right\n");
  EXPECT_EQ(metadata_of(mesh, "obj.materials"), "red\nblue\nunused");
  EXPECT_EQ(metadata_of(mesh, "obj.smoothing"), "1\noff");
  EXPECT_EQ(metadata_of(mesh, "obj.mtllib"), "a.mtl\nb c.mtl");
  const WriteResult written = must_write(mesh, Format::obj);
  EXPECT_EQ(text_of(written.bytes), file);
  EXPECT_TRUE(written.notes.empty());
}

TEST(Obj, FacesAreWrittenByTheirStates) {
  const Mesh mesh = must_read(
                        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl a\nf 1 2 3\nusemtl b\n"
                        "f 2 3 1\nusemtl a\nf 3 1 2\n",
                        Format::obj)
                        .meshes[0];
  const WriteResult written = must_write(mesh, Format::obj);
  EXPECT_EQ(text_of(written.bytes),
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl a\nf 1 2 3\nf 3 1 2\nusemtl b\nf 2 3 1\n");
  EXPECT_TRUE(notes_say(written.notes, "4 faces were put together by what their statements say"));
}

TEST(Obj, TheOnlyObjectNamesTheMesh) {
  EXPECT_EQ(must_read("o  my mesh #1 \r\nv 0 0 0\n", Format::obj).meshes[0].name, "my mesh #1");
}

TEST(Obj, VertexColours) {
  const Mesh mesh = must_read("v 0 0 0 .1 .2 .3\nv 1 1 1 .4 .5 .6\n", Format::obj).meshes[0];
  EXPECT_EQ(values_of<float>(get(mesh, "color", Domain::vertex)),
            (std::vector{.1f, .2f, .3f, .4f, .5f, .6f}));
  EXPECT_EQ(get(must_read("v 0 0 0 1 2 3 4\n", Format::obj).meshes[0], "color", Domain::vertex)
                .components,
            4);
  const ReadResult mixed =
      must_read("v 0 0 0 1 2 3\nv 0 0 0 1 2 3 4\nv 0 0 0 1 2 3\n", Format::obj);
  EXPECT_EQ(get(mixed.meshes[0], "color", Domain::vertex).indices,
            (std::vector<std::uint32_t>{0, no_value, 1}));
  EXPECT_TRUE(
      notes_say(mixed.notes, "1 vertex colour was left out: with fewer or more components"));
  const Mesh some = must_read("v 0 0 0\nv 0 0 0 1 2 3\nv 1 1 1\n", Format::obj).meshes[0];
  EXPECT_EQ(get(some, "color", Domain::vertex).indices,
            (std::vector<std::uint32_t>{no_value, 0, no_value}));
  EXPECT_EQ(text_of(must_write(some, Format::obj).bytes), "v 0 0 0\nv 0 0 0 1 2 3\nv 1 1 1\n");
}

TEST(Obj, LinesContinueAndCommentsEnd) {
  const Mesh mesh = must_read(
                        "# a comment \\\nv 0 \\\n0 \\\r\n0 # v 1 1 1\r\nv\t1 1 1\n\n  v 2 2 2\n"
                        "f 1 \\\n 2\\\n 3",
                        Format::obj)
                        .meshes[0];
  EXPECT_EQ(mesh.vertex_count, 3u);
  EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(Obj, AFaceMayComeBeforeItsVertices) {
  EXPECT_EQ(must_read("f 1 2 3\nv 0 0 0\nv 0 0 1\nv 0 1 0\n", Format::obj).meshes[0].corners,
            (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(Obj, ReadsNumbersThatAreNone) {
  const Mesh mesh = must_read("v inf nan +inf\nv -nan -0.0 -Inf\n", Format::obj).meshes[0];
  const std::vector<float> values = values_of<float>(*mesh.position());
  EXPECT_TRUE(std::isinf(values[0]) && !std::signbit(values[0]));
  EXPECT_TRUE(std::isnan(values[1]) && !std::signbit(values[1]));
  EXPECT_TRUE(std::isnan(values[3]) && std::signbit(values[3]));
  EXPECT_TRUE(values[4] == 0 && std::signbit(values[4]));
  EXPECT_TRUE(std::isinf(values[5]) && std::signbit(values[5]));
}

TEST(Obj, TrailingZeroBytesAreNoted) {
  const ReadResult result = must_read(std::string("v 0 0 0\n\0\0", 10), Format::obj);
  EXPECT_TRUE(notes_say(result.notes, "2 bytes were padding at the end of the file"));
}

Mesh triangle() {
  Mesh mesh;
  mesh.vertex_count = 3;
  mesh.corners = {0, 1, 2};
  mesh.attributes = {
      attribute<float>("position", Domain::vertex, 3, {0, 0, 0, 1, 0, 0, 0, .1f, 0})};
  return mesh;
}

TEST(Obj, WritesCornersOnceForEqualValues) {
  Mesh mesh = triangle();
  mesh.name = "one\nv";
  mesh.attributes.push_back(attribute<float>("texcoord", Domain::corner, 2, {0, 1, 2, 3, 0, 1}));
  mesh.attributes.push_back(
      attribute<double>("normal", Domain::vertex, 3, {0, 0, 1, 0, 0, 1, 0, 0, 1}));
  mesh.attributes.push_back(
      attribute<std::uint8_t>("color", Domain::vertex, 3, {0, 51, 255, 0, 51, 255, 0, 51, 255}));
  const WriteResult written = must_write(mesh, Format::obj);
  EXPECT_EQ(text_of(written.bytes),
            "o one v\nv 0 0 0 0 0.2 1\nv 1 0 0 0 0.2 1\nv 0 0.1 0 0 0.2 1\nvt 0 1\nvt 2 3\nvn 0 0 "
            "1\nvn 0 0 1\nvn 0 0 1\n"
            "f 1/1/1 2/2/2 3/1/3\n");
  EXPECT_TRUE(get(must_read(written.bytes, Format::obj).meshes[0], "color", Domain::vertex).data ==
              mesh.attributes.back().data);
  EXPECT_TRUE(notes_say(written.notes, "'normal' (3 x float64) is written by corner"));
}

TEST(Obj, SeveralMeshesBecomeObjects) {
  Mesh a = triangle(), b = triangle();
  a.name = "a";
  a.attributes.push_back(attribute<float>("texcoord", Domain::corner, 1, {0, 0, 0}));
  b.attributes.push_back(attribute<float>("texcoord", Domain::corner, 1, {1, 2, 1}));
  const Mesh meshes[] = {a, b};
  const Expected<WriteResult> written = write(meshes, Format::obj);
  ASSERT_TRUE(written.ok());
  EXPECT_EQ(text_of(written->bytes),
            "o a\nv 0 0 0\nv 1 0 0\nv 0 0.1 0\nvt 0\nf 1/1 2/1 3/1\n"
            "o \nv 0 0 0\nv 1 0 0\nv 0 0.1 0\nvt 1\nvt 2\nf 4/2 5/3 6/2\n");
  for (const Format format : {Format::ply, Format::off, Format::stl}) {
    const Expected<WriteResult> refused = write(meshes, format);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
  }
}

TEST(Obj, BinaryIsUnsupported) {
  const Mesh mesh = triangle();
  for (const Format format : {Format::obj, Format::off}) {
    const Expected<WriteResult> refused = write({&mesh, 1}, format, Encoding::binary);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
  }
}

}  // namespace
}  // namespace clers::io

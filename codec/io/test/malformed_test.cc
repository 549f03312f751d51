// One case for each rule of each format: which code, where, and what is said.
#include "codec/io/test/meshes.h"

namespace clers::io {
namespace {

using namespace std::string_literals;

struct Case {
  Format format;
  std::string file;
  Error expected;  // `what` may be a part
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.expected.what;
}

class Malformed : public ::testing::TestWithParam<Case> {};

TEST_P(Malformed, IsRefusedWithItsPlace) {
  const Expected<ReadResult> result = read(bytes_of(GetParam().file), GetParam().format);
  ASSERT_FALSE(result.ok()) << GetParam().file;
  const Error& expected = GetParam().expected;
  const Error& error = result.error();
  EXPECT_EQ(error.code, expected.code) << describe(error);
  EXPECT_EQ(error.place, expected.place) << describe(error);
  EXPECT_EQ(error.at, expected.at) << describe(error);
  EXPECT_NE(error.what.find(expected.what), std::string::npos) << describe(error);
}

Error line(std::uint64_t at, std::string what) {
  return {ErrorCode::malformed, Place::line, at, std::move(what)};
}
Error byte(std::uint64_t at, std::string what) {
  return {ErrorCode::malformed, Place::byte, at, std::move(what)};
}
Error unsupported(std::uint64_t at, std::string what) {
  return {ErrorCode::unsupported, at ? Place::line : Place::nowhere, at, std::move(what)};
}

// A header in text, lines from 3 on.
Case ply(const std::string& rest, Error expected) {
  return {Format::ply, "ply\nformat ascii 1.0\n" + rest, std::move(expected)};
}
// A body in text, lines from 8 on, after 3 vertices of one property and faces.
Case ply_text(const std::string& faces, const std::string& body, Error expected) {
  return ply("element vertex 3\nproperty float x\nelement face " + faces +
                 "\nproperty list uchar int vertex_indices\nend_header\n" + body,
             std::move(expected));
}
// The same in binary; bytes count from the body, which begins with the vertices' 12.
Case ply_binary(const std::string& body, Error expected) {
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
      "element face 1\nproperty list char short vertex_indices\nend_header\n";
  expected.at += header.size();
  return {Format::ply, header + body, std::move(expected)};
}

Case ply_big_endian(const std::string& elements, const std::string& body, Error expected) {
  const std::string header = "ply\nformat binary_big_endian 1.0\n" + elements + "end_header\n";
  expected.at += header.size();
  return {Format::ply, header + body, std::move(expected)};
}

INSTANTIATE_TEST_SUITE_P(
    PlyHeader, Malformed,
    ::testing::Values(
        Case{Format::ply, "", line(1, "expected the line 'ply'")},
        Case{Format::ply, "plyformat", line(1, "expected the line 'ply'")},
        Case{Format::ply, "ply\n", line(2, "found the end of the file")},
        Case{Format::ply, "ply\nelement vertex 0\n", line(2, "expected the line 'format ...'")},
        Case{Format::ply, "ply\nformat asci 1.0\n", line(2, "found 'asci'")},
        Case{Format::ply, "ply\nformat ascii 2.0\n", line(2, "expected version 1.0, found '2.0'")},
        Case{Format::ply, "ply\nformat ascii 1.0 x\n", line(2, "expected the end of the line")},
        ply("format ascii 1.0\n", line(3, "a second line 'format'")),
        ply("\n", line(4, "found the end of the file")),
        ply("vertex 3\n", line(3, "'element', 'property'")),
        ply("property float x\n", line(3, "expected an element")),
        ply("element\n", line(3, "the name of the element")),
        ply("element vertex\n", line(3, "the number of entries")),
        ply("element vertex -1\n", line(3, "the number of entries, found '-1'")),
        ply("element vertex 99999999999999999999\n", line(3, "the number of entries")),
        ply("element vertex 0\nelement vertex 0\n", line(4, "a second element 'vertex'")),
        ply("element vertex 0\nproperty real x\n", line(4, "found 'real'")),
        ply("element vertex 0\nproperty float\n", line(4, "the name of the property")),
        ply("element vertex 0\nproperty float x y\n", line(4, "expected the end of the line")),
        ply("element vertex 0\nproperty float x\nproperty int x\n",
            line(5, "a second property 'x'")),
        ply("element vertex 0\nproperty list float int x\n", line(4, "lengths of lists")),
        ply("element vertex 0\nproperty list int x\n", line(4, "found 'x'")),
        ply("element vertex 4\nelement face 0\n", line(3, "to have properties")),
        ply("element vertex 4\nend_header\n", line(3, "to have properties")),
        ply("element vertex 0\nelement face 1\nproperty int a\nend_header\n",
            line(4, "to have a list vertex_indices")),
        ply("element vertex 0\nelement face 1\nproperty int vertex_index\n",
            line(5, "to be a list of integers")),
        ply("element vertex 0\nelement face 1\nproperty list int float vertex_index\n",
            line(5, "to be a list of integers")),
        ply("element face 0\nend_header\n", line(4, "expected an element 'vertex'")),
        ply("element vertex 0\nelement face 1\nproperty list int int vertex_index\n"
            "element tristrips 1\nproperty list int int vertex_index\nend_header\n",
            unsupported(6, "both faces and triangle strips")),
        ply("element vertex 4294967295\nproperty float x\nend_header\n",
            {ErrorCode::too_large, Place::line, 3, "fewer than 4294967295"})));

INSTANTIATE_TEST_SUITE_P(
    PlyText, Malformed,
    ::testing::Values(
        ply_text("1", "1\n2\n    \n",
                 line(11, "expected a float32 for property 'x', found the end")),
        ply_text("1", "1\n2\n3a\n3 0 1 2\n", line(10, "found '3a'")),
        ply_text("1", "1\n2\n1e39\n3 0 1 2\n", line(10, "found '1e39'")),
        ply_text("1", "1\n2\n++3\n3 0 1 2\n", line(10, "found '++3'")),
        ply_text("1", "1\n2\n3\n", line(11, "1 entry of element 'face', which 0 bytes")),
        ply_text("1", "1\n2\n3\n\n\n-1 0 1 2\n", line(13, "length of list 'vertex_indices'")),
        ply_text("1", "1\n2\n3\n3 0 1 3\n", line(11, "a vertex index below 3, found '3'")),
        ply_text("1", "1\n2\n3\n3 0 1 -1\n", line(11, "a vertex index below 3, found '-1'")),
        ply_text("1", "1\n2\n3\n3 0 1.0 2\n", line(11, "a vertex index below 3, found '1.0'")),
        ply_text("1", "1\n2\n3\n3 0 1\n", line(12, "found the end of the file")),
        ply_text("1", "1\n2\n3\n3 0 1 2\n3 0 1 2\n", line(12, "expected the end of the file")),
        ply_text("100", "1\n2\n3\n3 0 1 2\n", line(11, "100 entries of element 'face'")),
        ply("element vertex 1000000\nproperty float x\nend_header\n1 2 3\n",
            line(6, "1000000 entries of element 'vertex', which 6 bytes cannot hold")),
        ply("element vertex 1\nproperty uchar a\nend_header\n256\n",
            line(6, "expected a uint8 for property 'a', found '256'")),
        ply("element vertex 1\nproperty float x\nelement tristrips 1\n"
            "property list uchar int vertex_index\nend_header\n0\n3 0 0 -2\n",
            line(9, "a vertex index below 1 or -1, found '-2'"))));

INSTANTIATE_TEST_SUITE_P(
    PlyBinary, Malformed,
    ::testing::Values(
        ply_binary("", byte(0, "3 entries of element 'vertex', which 0 bytes")),
        ply_binary("aaaabbbbccc", byte(0, "3 entries of element 'vertex', which 11 bytes")),
        ply_binary("aaaabbbbcccc", byte(12, "1 entry of element 'face', which 0 bytes")),
        ply_binary("aaaabbbbcccc\003\0\0\1\0\2"s, byte(12, "that 5 bytes can hold, found 3")),
        ply_binary("aaaabbbbcccc\xff\0\0\1\0\2\0"s, byte(12, "that 6 bytes can hold, found -1")),
        ply_binary("aaaabbbbcccc\003\0\0\1\0\3\0"s, byte(17, "a vertex index below 3, found 3")),
        ply_binary("aaaabbbbcccc\003\0\0\xff\xff\2\0"s,
                   byte(15, "a vertex index below 3, found -1")),
        ply_big_endian("element vertex 1\nproperty list uchar char a\nproperty int b\n",
                       "\1x\0\0\0"s,
                       byte(2, "expected an int32 for property 'b', found the end of the file")),
        ply_big_endian("element vertex 2\nproperty list int char a\n", "\0\0\0\1xyzw"s,
                       byte(5, "expected the length of list 'a', found the end of the file"))));

Case obj(const std::string& file, Error expected) {
  return {Format::obj, file, std::move(expected)};
}
const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

INSTANTIATE_TEST_SUITE_P(
    Obj, Malformed,
    ::testing::Values(
        obj("v 0 0\n", line(1, "expected a coordinate, found the end of the line")),
        obj("v 0 0 x\n", line(1, "expected a coordinate, found 'x'")),
        obj("v 0 0 1e999\n", line(1, "expected a coordinate, found '1e999'")),
        obj("v 0 0 0 0 x\n", line(1, "expected a number, found 'x'")),
        obj("v 0 0 0 1 1 red\n", line(1, "expected a number, found 'red'")),
        obj("vt\n", line(1, "expected a texture coordinate")),
        obj("vt 0 0 0 0\n", line(1, "expected the end of the line, found '0'")),
        obj("vn 0 0\n", line(1, "expected a component of a normal")),
        obj("vn 0 0 0 0\n", line(1, "expected the end of the line")),
        obj("# ok\nvertex 1 2 3\n", line(2, "such as 'v' or 'f', found 'vertex'")),
        obj("\x01\x02", line(1, "found '\?\?'")),
        obj(three + "f\n", line(4, "expected a vertex index, found the end of the line")),
        obj(three + "f a b c\n", line(4, "expected a vertex index, found 'a'")),
        obj(three + "f 0 1 2\n", line(4, "a vertex index from 1, or from -1 down to -3, found 0")),
        obj(three + "f -1 -2 -4\n", line(4, "from -1 down to -3, found -4")),
        obj(three + "f 1 2 4\n", line(4, "a vertex index of at most 3, found 4")),
        obj(three + "\\\n\nf 1 2 \\\n4\n", line(7, "a vertex index of at most 3, found 4")),
        obj(three + "f 1 2 99999999999999999999\n", line(4, "found '99999999999999999999'")),
        obj(three + "f 1/2/3/4 2 3\n", line(4, "expected a corner such as 1, 1/2")),
        obj(three + "f 1x 2 3\n", line(4, "expected a corner such as 1, 1/2")),
        obj(three + "vt 0 0\nf 1/1 2/2 3/1\n", line(5, "a texture coordinate index of at most 1")),
        obj(three + "vn 0 0 1\nf 1//1 2//2 3//1\n",
            line(5, "a normal index of at most 1, found 2")),
        obj(three + "f 1//-1 2//1 3//1\nvn 0 0 1\n", line(4, "found one that counts back"))));

Case off(const std::string& file, Error expected) {
  return {Format::off, file, std::move(expected)};
}
const std::string off_three = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";

INSTANTIATE_TEST_SUITE_P(
    Off, Malformed,
    ::testing::Values(
        off("", line(1, "expected OFF, COFF, NOFF, STOFF or such, found ''")),
        off("FOO\n", line(1, "found 'FOO'")), off("4OFF\n0 0 0\n", unsupported(1, "found '4OFF'")),
        off("\nSTCN4nOFF\n0 0 0\n", unsupported(2, "found 'STCN4nOFF'")),
        off("OFF BINARY\n", unsupported(1, "found 'OFF BINARY'")),
        off("OFF\n", line(2, "expected the number of vertices")),
        off("OFF\n3\n", line(2, "expected the number of faces")),
        off("OFF\n3 x\n", line(2, "expected the number of faces, found 'x'")),
        off("OFF\n3 1 z\n", line(2, "expected the number of edges, found 'z'")),
        off("OFF\n0 0 0 0\n", line(2, "expected the end of the line")),
        off("OFF\n# 1\n999999 1 0\n0 0 0\n", line(3, "999999 vertices and 1 face, which")),
        off("OFF\n1 999999 0\n0 0 0\n", line(2, "1 vertex and 999999 faces, which")),
        off("OFF\n2 0 0\n0 0 0\n0 0 # \n\n", line(4, "expected a coordinate, found the end")),
        off("OFF\n2 0 0\n0 0 0\n0 0 a b c\n", line(4, "expected a coordinate, found 'a'")),
        off("OFF\n1 0 0\n0 0 0 0\n", line(3, "or a colour of 3 or 4 numbers, found '0'")),
        off("NOFF\n1 0 0\n0 0 0 0 0 x\n", line(3, "a component of a normal, found 'x'")),
        off("COFF\n1 0 0\n0 0 0 1 1\n", line(3, "a colour of 3 or 4 numbers")),
        off("COFF\n1 0 0\n0 0 0 1 1 x\n", line(3, "expected a number of a colour, found 'x'")),
        off("STOFF\n1 0 0\n0 0 0 1 x\n", line(3, "expected a texture coordinate, found 'x'")),
        off(off_three + "x 0 1 2\n", line(6, "expected the number of corners of a face")),
        off(off_three + "3 0 1 3\n", line(6, "a vertex index below 3, found '3'")),
        off(off_three + "3 0 1\n", line(7, "a vertex index below 3, found the end of the file")),
        off(off_three + "3 0 1 2 0 0\n", line(6, "a colour of 1, 3 or 4 numbers")),
        off(off_three + "3 0 1 2 0 0 x\n", line(6, "expected a number of a colour, found 'x'")),
        off(off_three + "3 0 1 2\n3 0 1 2\n", line(7, "expected the end of the file"))));

Case stl(const std::string& file, Error expected) {
  return {Format::stl, file, std::move(expected)};
}
const std::string facet =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";

INSTANTIATE_TEST_SUITE_P(
    Stl, Malformed,
    ::testing::Values(
        stl("", byte(0, "expected 84 bytes")),
        stl("sol", byte(3, "or text that begins with 'solid'")),
        stl(std::string(80, ' ') + "\2\0\0\0"s + std::string(99, 'x'),
            byte(80, "of which it holds 1, found 2")),
        stl("solid", line(1, "'facet normal' or 'endsolid', found the end of the file")),
        stl("solid a\nfacet abnormal 0 0 0", line(2, "found 'abnormal'")),
        stl("solid a\nfacet normal 0 0\nouter loop", line(3, "a component of the normal")),
        stl("solid a\nfacet normal 0 0 0\ninner loop", line(3, "expected 'outer loop'")),
        stl("solid a\nfacet normal 0 0 0\nouter loop\nvortex", line(4, "expected 'vertex'")),
        stl("solid a\nfacet normal 0 0 0\nouter loop\nvertex 1 2 x", line(4, "a coordinate")),
        stl(facet + "vertex 0 0 0\nendloop\n", line(7, "expected 'endloop' after three vertices")),
        stl(facet + "endloop\nfacet\n", line(8, "expected 'endfacet'")),
        stl(facet + "endloop\nendfacet\nendsolid a\nmore\n", line(10, "expected 'solid'"))));

}  // namespace
}  // namespace clers::io

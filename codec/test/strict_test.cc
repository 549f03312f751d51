// What format.md forbids is refused, one small file a rule, with the byte.
#include <gtest/gtest.h>
#include <zstd.h>

#include <limits>
#include <string>
#include <vector>

#include "codec/base/utf8.h"
#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/inspect.h"
#include "codec/test/attribute.h"
#include "codec/test/decoding.h"
#include "codec/test/file_builder.h"
#include "corpus/generate.h"

namespace clers::internal {
namespace {

using test::decode_pieces;

using test::FileBuilder;
using test::Payload;

/// Every call refuses the file in the same words.
void expect_invalid(const Bytes& bytes, const char* what) {
  const auto out = decode(bytes);
  ASSERT_FALSE(out.ok());
  EXPECT_EQ(out.error().code, ErrorCode::invalid);
  EXPECT_EQ(describe(out.error()), what);
  const auto info = inspect(bytes);
  ASSERT_FALSE(info.ok());
  EXPECT_EQ(describe(info.error()), what);
  const auto pieces = decode_pieces(bytes, [](const Piece&) {});
  ASSERT_FALSE(pieces.ok());
  EXPECT_EQ(describe(pieces.error()), what);
}

FileBuilder tetrahedron() {
  return std::move(FileBuilder().section(SectionKind::mesh, test::tetrahedron_mesh()));
}

TEST(Strict, Levels) {
  for (const int level : {0, 10, 255})
    expect_invalid(
        FileBuilder(level).finish(),
        ("byte 6: made with level " + std::to_string(level) + ", expected 1 to 9").c_str());
  for (int level = min_level; level <= max_level; ++level)
    EXPECT_TRUE(decode(FileBuilder(level).finish()).ok());
}

TEST(Strict, NamesOfMeshes) {
  const Payload name = std::move(Payload().text("a name"));
  EXPECT_TRUE(decode(tetrahedron().section(SectionKind::name, name).finish()).ok());
  expect_invalid(
      tetrahedron().section(SectionKind::name, name).section(SectionKind::name, Payload()).finish(),
      "byte 35: a second name of a mesh");
  expect_invalid(tetrahedron().section(SectionKind::name, Payload().text("a\xff")).finish(),
                 "byte 24: the name is not UTF-8 from here");
}

TEST(Strict, Orders) {
  // Of no faces, so that an order may be empty but for the state of its stream.
  const Payload points = std::move(Payload().u8(0).varint(3).varint(0)),
                order = std::move(Payload().u8(0).u8(1));
  const auto mesh = [&] { return std::move(FileBuilder().section(SectionKind::mesh, points)); };
  EXPECT_TRUE(decode(mesh().section(SectionKind::order, order).finish()).ok());
  expect_invalid(
      mesh().section(SectionKind::order, order).section(SectionKind::order, order).finish(),
      "byte 26: an order where none can be");
  expect_invalid(mesh().section(SectionKind::order, Payload()).finish(),
                 "byte 18: the orders do not end where their bytes end");
}

TEST(Strict, ValuesAreOneFrame) {
  const std::vector<std::byte> values(4, std::byte{7});
  const Bytes frame = test::zstd_frame(values);
  const auto file = [&](const Payload& packed) {
    return tetrahedron()
        .section(SectionKind::attribute,
                 test::attribute_section("a", Domain::vertex, Scalar::uint8, 1, packed.bytes))
        .finish();
  };
  EXPECT_TRUE(decode(file(Payload().raw(frame))).ok());
  const Bytes none = test::zstd_frame({});
  const Payload secret = std::move(
      Payload().u8(0x50).u8(0x2a).u8(0x4d).u8(0x18).u8(7).u8(0).u8(0).u8(0).text("secret!"));
  const std::string after = "byte " + std::to_string(30 + frame.size()) + ": ";
  expect_invalid(file(Payload().raw(frame).raw(secret.bytes)),
                 (after + "15 bytes after the zstd frame of the values").c_str());
  expect_invalid(
      file(Payload().raw(frame).raw(none)),
      (after + std::to_string(none.size()) + " bytes after the zstd frame of the values").c_str());
  expect_invalid(file(Payload().raw(secret.bytes).raw(frame)),
                 "byte 30: no zstd frame, which the values must be");
  expect_invalid(file(Payload().raw(std::span(frame).first(frame.size() - 1))),
                 "byte 30: zstd: Src size is incorrect");
  const Bytes fewer = test::zstd_frame(std::span(values).first(3));
  expect_invalid(file(Payload().raw(fewer)), "byte 30: the values take 3 bytes, expected 4");
}

TEST(Strict, NoValuesAreAFrameToo) {
  const Payload points = test::raw_mesh(0, 0, 0);
  const auto file = [&](const Bytes& packed) {
    return FileBuilder()
        .section(SectionKind::mesh, points)
        .section(SectionKind::attribute,
                 test::attribute_section("a", Domain::vertex, Scalar::uint8, 1, packed))
        .finish();
  };
  EXPECT_TRUE(decode(file(test::zstd_frame({}))).ok());
  expect_invalid(file({}), "byte 28: no zstd frame, which the values must be");
}

TEST(Strict, NamesOfAttributes) {
  expect_invalid(tetrahedron()
                     .section(SectionKind::attribute,
                              test::attribute_section("caf\xe9", Domain::vertex, Scalar::uint8, 1,
                                                      test::zstd_frame(std::vector<std::byte>(4))))
                     .finish(),
                 "byte 27: the name is not UTF-8 from here");
}

TEST(Strict, MoreSThanThereIsRoomFor) {
  // E, then S at once: nothing is pending, and no S was declared.
  Payload mesh;
  mesh.u8(0).varint(0).varint(2).u8(0).u8(0).u8(0).varint(1).u8(7);  // the prefix code of S
  const auto out = decode(FileBuilder().section(SectionKind::mesh, mesh.u8(0).u8(1)).finish());
  ASSERT_FALSE(out.ok());
  EXPECT_EQ(describe(out.error()), "symbol 1: more S than declared");
}

/// By the table of well-formed byte sequences (Unicode 3-7).
TEST(Utf8, Characters) {
  for (const char* good : {"", "a", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf",
                           "\xee\x80\x80", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf", "caf\xc3\xa9"})
    EXPECT_TRUE(is_utf8(good)) << good;
  for (const char* bad :
       {"\x80", "\xc1\xbf", "\xc2", "\xc2z", "\xe0\x9f\xbf", "\xe1\x80", "\xed\xa0\x80",
        "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff"}) {
    EXPECT_EQ(first_not_utf8(bad), 0u) << bad;
    EXPECT_EQ(first_not_utf8("ab" + std::string(bad)), 2u) << bad;
  }
}

TEST(Encode, WritesNoNameThatNoDecoderTakes) {
  Mesh mesh = corpus::tetrahedron();
  mesh.name = "caf\xe9";
  EXPECT_EQ(encode({&mesh, 1}).error().code, ErrorCode::inconsistent_mesh);
  mesh.name = "";
  mesh.attributes[0].name = "\xff";
  EXPECT_EQ(encode({&mesh, 1}).error().code, ErrorCode::inconsistent_mesh);
}

TEST(Encode, NumbersOutOfRangeAreNamed) {
  Mesh mesh = corpus::tetrahedron();
  mesh.attributes = {{"a", static_cast<Domain>(3), Scalar::uint8, 1, {}}};
  const auto what = [&] {
    EXPECT_EQ(measure(mesh).error().what, encode({&mesh, 1}).error().what);
    EXPECT_EQ(encode({&mesh, 1}).error().code, ErrorCode::inconsistent_mesh);
    return encode({&mesh, 1}).error().what;
  };
  EXPECT_EQ(what(), "attribute \"a\" has domain 3, expected 0 to 2");
  for (const unsigned scalar : {10u, 255u}) {
    mesh.attributes = {{"a", Domain::vertex, static_cast<Scalar>(scalar), 1, {}}};
    EXPECT_EQ(what(), "attribute \"a\" has scalar " + std::to_string(scalar) + ", expected 0 to 9");
  }
  mesh.attributes = {{"a", Domain::vertex, Scalar::uint8, 0, {}}};
  EXPECT_EQ(what(), "attribute \"a\" has 0 components, expected 1 to 255");
}

TEST(Encode, OptionsOutOfRangeAreRefused) {
  const Mesh mesh = corpus::tetrahedron();
  const auto code = [&](const EncodeOptions& options) {
    auto coded = encode({&mesh, 1}, options);
    return coded ? ErrorCode::internal : coded.error().code;
  };
  for (const unsigned number : {2u, 3u, 200u}) {
    EncodeOptions options;
    options.order = static_cast<Order>(number);
    EXPECT_EQ(code(options), ErrorCode::bad_option);
    for (DefectPolicy EncodeOptions::*on :
         {&EncodeOptions::on_nonmanifold, &EncodeOptions::on_degenerate,
          &EncodeOptions::on_duplicate}) {
      options = {};
      options.*on = static_cast<DefectPolicy>(number);
      EXPECT_EQ(code(options), ErrorCode::bad_option);
    }
  }
}

TEST(Encode, PiecesOfNoFacesAreRefused) {
  const Mesh mesh = corpus::tetrahedron();
  EncodeOptions options;
  options.piece_faces = 0;
  EXPECT_EQ(encode(mesh, options).error().code, ErrorCode::bad_option);
}

TEST(Threads, AnyNumberMayBeAskedFor) {
  const Mesh mesh = corpus::icosphere(3);
  EncodeOptions how;
  how.piece_faces = 300;
  const auto coded = encode({&mesh, 1}, how);
  ASSERT_TRUE(coded.ok());
  for (const unsigned threads : {0u, 7u, 1000u, std::numeric_limits<unsigned>::max()}) {
    how.threads = threads;
    const auto again = encode({&mesh, 1}, how);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again->bytes, coded->bytes);
    DecodeOptions back;
    back.threads = threads;
    const auto out = decode(coded->bytes, back);
    ASSERT_TRUE(out.ok());
    EXPECT_EQ((*out)[0].corners, (*decode(coded->bytes))[0].corners);
  }
}

}  // namespace
}  // namespace clers::internal

#include "codec/file/metadata.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "codec/compare.h"
#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/file/container.h"
#include "codec/inspect.h"
#include "codec/test/decoding.h"

namespace clers::internal {
namespace {

using test::decode_pieces;

Mesh tetrahedron(std::vector<MetadataEntry> metadata) {
  Mesh mesh;
  mesh.vertex_count = 4;
  mesh.corners = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
  mesh.metadata = std::move(metadata);
  return mesh;
}

Bytes encoded(const Mesh& mesh, const EncodeOptions& options = {}) {
  auto result = encode(std::span(&mesh, 1), options);
  EXPECT_TRUE(result) << (result ? "" : describe(result.error()));
  return result ? result->bytes : Bytes();
}

bool same(const std::vector<MetadataEntry>& a, const std::vector<MetadataEntry>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.key == y.key && x.value == y.value;
  });
}

/// A file with this payload of metadata, or with two.
Bytes file_with(std::span<const std::byte> payload, int times = 1) {
  const Bytes plain = encoded(tetrahedron({}));
  ContainerReader in(plain);
  EXPECT_TRUE(in.open());
  ContainerWriter out(default_level);
  for (;;) {
    const auto section = in.next();
    if (!section || section->kind == SectionKind::end) break;
    out.section(section->kind, section->payload);
  }
  for (int i = 0; i < times; ++i) out.section(SectionKind::metadata, payload);
  return out.finish(1);
}

void expect_refused(const Bytes& file, ErrorCode code, std::string_view what) {
  const auto result = decode(file);
  ASSERT_FALSE(result) << what;
  EXPECT_EQ(result.error().code, code) << describe(result.error());
  EXPECT_NE(result.error().what.find(what), std::string::npos) << describe(result.error());
}

RC_GTEST_PROP(Metadata, ComeBackInTheirOrder, ()) {
  Mesh mesh = tetrahedron({});
  const int n = *rc::gen::inRange(0, 6);
  for (int i = 0; i < n; ++i)
    mesh.metadata.push_back(
        {std::to_string((i * 7) % 6) + "\xc3\xbc", *rc::gen::arbitrary<std::string>()});
  const Bytes bytes = encoded(mesh);
  const auto back = decode(bytes);
  RC_ASSERT(back.ok());
  RC_ASSERT(same(back->front().metadata, mesh.metadata));
  RC_ASSERT(metadata_difference(back->front(), mesh).empty());
  RC_ASSERT(encoded(back->front()) == bytes);
}

TEST(Metadata, BelongToTheMeshAndToTheFirstPiece) {
  Mesh grid;
  constexpr std::uint32_t side = 20;
  grid.vertex_count = (side + 1) * (side + 1);
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t v = y * (side + 1) + x;
      grid.corners.insert(grid.corners.end(), {v, v + 1, v + side + 1});
      grid.corners.insert(grid.corners.end(), {v + 1, v + side + 2, v + side + 1});
    }
  grid.metadata = {{"comment", "two\nlines"}, {"empty", ""}};
  EncodeOptions options;
  options.piece_faces = 200;
  const Bytes bytes = encoded(grid, options);
  const auto back = decode(bytes);
  ASSERT_TRUE(back);
  EXPECT_TRUE(same(back->front().metadata, grid.metadata));
  std::size_t pieces = 0;
  ASSERT_TRUE(decode_pieces(bytes, [&](const Piece& piece) {
    ++pieces;
    EXPECT_EQ(piece.mesh.metadata.size(), piece.index == 0 ? 2u : 0u);
  }));
  EXPECT_GT(pieces, 1u);
  const auto info = inspect(bytes);
  ASSERT_TRUE(info);
  EXPECT_GT(info->file.meshes[0].metadata_bytes, 0u);
  EXPECT_TRUE(same(info->file.meshes[0].metadata, grid.metadata));
}

TEST(Metadata, EncodingRefusesKeysThatAreNone) {
  for (const std::vector<MetadataEntry>& entries : {std::vector<MetadataEntry>{{"", "a"}},
                                                    {{std::string(256, 'a'), ""}},
                                                    {{"\xff", ""}},
                                                    {{"a", "1"}, {"b", ""}, {"a", "2"}}}) {
    const Mesh mesh = tetrahedron(entries);
    const auto result = encode(std::span(&mesh, 1));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::inconsistent_mesh);
  }
  const Mesh longest = tetrahedron({{std::string(255, 'a'), std::string(1, '\0')}});
  EXPECT_TRUE(decode(encoded(longest)));
}

TEST(Metadata, DecodingRefusesWhatTheFormatDoes) {
  const auto payload = [](std::vector<MetadataEntry> entries) { return *encode_metadata(entries); };
  EXPECT_TRUE(decode(file_with(payload({{"a", "b"}}))));
  expect_refused(file_with(payload({{"a", "b"}}), 2), ErrorCode::invalid, "metadata where none");
  expect_refused(file_with(payload({})), ErrorCode::invalid, "0 entries of metadata");
  expect_refused(file_with(payload({{"", "b"}})), ErrorCode::invalid, "a key of metadata");
  expect_refused(file_with(payload({{"\xc0\x80", "b"}})), ErrorCode::invalid, "a key of metadata");
  expect_refused(file_with(payload({{"a", "b"}, {"a", "b"}})), ErrorCode::invalid, "have one key");
  Bytes more = payload({{"aaa", "bbb"}, {"c", "d"}});
  more[0] = std::byte{1};  // entries
  expect_refused(file_with(more), ErrorCode::invalid, "bytes after the last entry");
  more[0] = std::byte{3};
  expect_refused(file_with(more), ErrorCode::invalid, "metadata: the data end");
  more[0] = std::byte{5};
  expect_refused(file_with(more), ErrorCode::invalid, "5 entries of metadata");
  more[0] = std::byte{2};
  more[1] = std::byte{13};  // size: one too much
  expect_refused(file_with(more), ErrorCode::invalid, "expected 13");
  more.pop_back();
  expect_refused(file_with(more), ErrorCode::invalid, "zstd");
  expect_refused(file_with({}), ErrorCode::truncated, "the data end here");
}

TEST(Metadata, CountAgainstTheLimitOfMemory) {
  const Mesh mesh = tetrahedron({{"a", std::string(50u << 20, 'x')}});
  const Bytes bytes = encoded(mesh);
  EXPECT_LT(bytes.size(), 100u << 10);
  DecodeOptions options;
  options.limits.memory = 40u << 20;
  const auto refused = decode(bytes, options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::limit);
  options.limits.memory = 200u << 20;
  EXPECT_TRUE(decode(bytes, options));
}

TEST(Metadata, DifferencesAreNamed) {
  const auto difference = [](std::vector<MetadataEntry> a, std::vector<MetadataEntry> b) {
    return metadata_difference(tetrahedron(std::move(a)), tetrahedron(std::move(b)));
  };
  EXPECT_EQ(difference({{"a", "1"}, {"b", "2"}}, {{"b", "2"}, {"a", "1"}}), "");
  EXPECT_EQ(difference({{"a", "1"}}, {}), "metadata 'a': only the first has it");
  EXPECT_EQ(difference({{"b", ""}}, {{"a", ""}, {"b", ""}}),
            "metadata 'a': only the second has it");
  EXPECT_EQ(difference({{"a", "1"}}, {{"a", "2"}}), "metadata 'a': different values");
}

TEST(Metadata, FormatZeroPointOneIsRefusedByName) {
  Bytes bytes = encoded(tetrahedron({}));
  bytes[5] = std::byte{0x01};
  expect_refused(bytes, ErrorCode::unsupported_version, "format 0.1, this program reads 0.2");
}

}  // namespace
}  // namespace clers::internal

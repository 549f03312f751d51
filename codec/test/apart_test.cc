// Pieces that are encoded apart, and joined, are the file that encode() makes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <clers/apart.h>
#include <clers/encode.h>

namespace clers {
namespace {

/// A wavy rectangle with all that a piece may have: polygons where asked, values of all domains.
struct Input {
  std::vector<std::uint32_t> corners, sizes;
  std::vector<std::array<float, 3>> places, normals;
  std::vector<std::uint16_t> of_faces;
  std::vector<float> of_corners;
  std::vector<AttributeView> attributes;
  std::vector<MetadataEntry> metadata = {{"source", "a test"}};

  explicit Input(bool quads, std::uint32_t n = 28) {
    for (std::uint32_t y = 0; y < n; ++y)
      for (std::uint32_t x = 0; x < n; ++x) {
        const float fx = static_cast<float>(x) / 7, fy = static_cast<float>(y) / 9;
        places.push_back({fx, fy, std::sin(fx) * std::cos(fy)});
        normals.push_back({0, 0.6f, 0.8f});
      }
    for (std::uint32_t y = 0; y + 1 < n; ++y)
      for (std::uint32_t x = 0; x + 1 < n; ++x) {
        const std::uint32_t v = y * n + x;
        if (quads && (x + y) % 2 == 0) {
          corners.insert(corners.end(), {v, v + 1, v + n + 1, v + n});
          sizes.push_back(4);
        } else {
          corners.insert(corners.end(), {v, v + 1, v + n, v + n, v + 1, v + n + 1});
          if (quads) sizes.insert(sizes.end(), {3, 3});
        }
      }
    const std::size_t faces = quads ? sizes.size() : corners.size() / 3;
    for (std::size_t f = 0; f < faces; ++f) of_faces.push_back(static_cast<std::uint16_t>(f / 9));
    for (const std::uint32_t v : corners) of_corners.push_back(static_cast<float>(v % 5) / 3);
    attributes = {attribute_view("position", places), attribute_view("normal", normals),
                  attribute_view("part", of_faces, Domain::face),
                  attribute_view("u", of_corners, Domain::corner)};
  }

  MeshView view() const {
    MeshView mesh;
    mesh.vertex_count = static_cast<std::uint32_t>(places.size());
    mesh.corners = corners;
    mesh.face_sizes = sizes;
    mesh.attributes = AttributeViews(attributes);
    mesh.name = "wave";
    mesh.metadata = metadata;
    return mesh;
  }
};

Expected<std::vector<CodedPiece>> code_all(const PiecesApart& apart, const EncodeOptions& options) {
  std::vector<CodedPiece> pieces;
  for (std::size_t i = 0; i < apart.count(); ++i) {
    const auto piece = apart.piece(i);
    if (!piece) return Failure{piece.error()};
    auto coded = encode_piece(*piece, apart.plan(), options);
    if (!coded) return Failure{coded.error()};
    pieces.push_back(std::move(*coded));
  }
  return pieces;
}

void expect_same(const MeshView& mesh, const EncodeOptions& options) {
  const auto together = encode(mesh, options);
  ASSERT_TRUE(together) << describe(together.error());
  const auto apart = PiecesApart::cut(mesh, options);
  ASSERT_TRUE(apart) << describe(apart.error());
  ASSERT_GT(apart->count(), 2u);
  const auto pieces = code_all(*apart, options);
  ASSERT_TRUE(pieces) << describe(pieces.error());
  const auto joined = apart->join(*pieces);
  ASSERT_TRUE(joined) << describe(joined.error());
  EXPECT_TRUE(joined->bytes == together->bytes);
  EXPECT_EQ(joined->order.vertices, together->permutations[0].vertices);
  EXPECT_EQ(joined->order.faces, together->permutations[0].faces);
  EXPECT_EQ(joined->order.first_corners, together->permutations[0].first_corners);
}

TEST(Apart, SameBytes) {
  const std::vector<std::vector<AttributePrecision>> precisions = {
      {},
      {{"position", Precision::of_bits(11)}, {"u", Precision::of_bits(6), Domain::corner}},
      {{"position", Precision::of_error(1e-3)}, {"normal", Precision::of_directions(8)}},
      {{"position", Precision::of_step(1e-3)}, {"normal", Precision::recomputed(20)}},
      {{"u", Precision::on_grid({0}, 0.01)}, {"part", Precision::of_step(4)}}};
  for (const bool quads : {false, true}) {
    const Input input(quads);
    for (const auto& asked : precisions)
      for (const int level : {1, 5}) {
        EncodeOptions options;
        options.level = level;
        options.piece_faces = 350;
        options.precisions = asked;
        options.order = level == 1 ? Order::keep : Order::free;
        expect_same(input.view(), options);
      }
  }
}

TEST(Apart, WholeMeshesAreNotCut) {
  const Input input(false, 5);
  const auto apart = PiecesApart::cut(input.view(), {});
  ASSERT_TRUE(apart);
  EXPECT_EQ(apart->count(), 0u);
  EXPECT_EQ(apart->piece(0).error().code, ErrorCode::bad_option);
  EXPECT_EQ(apart->join({}).error().code, ErrorCode::bad_option);
}

TEST(Apart, RefusesWhatIsNoPiece) {
  const Input input(false);
  EncodeOptions options;
  options.piece_faces = 350;
  options.precisions = {{"position", Precision::of_bits(11)}};
  const auto apart = PiecesApart::cut(input.view(), options);
  ASSERT_TRUE(apart);
  const auto pieces = code_all(*apart, options);
  ASSERT_TRUE(pieces);
  const auto code = [&](std::size_t piece, auto&& change) {
    std::vector<CodedPiece> wrong = *pieces;
    change(wrong[piece]);
    const auto joined = apart->join(wrong);
    return joined ? ErrorCode::internal : joined.error().code;
  };
  EXPECT_EQ(code(1, [](CodedPiece& p) { p.bytes.pop_back(); }), ErrorCode::truncated);
  EXPECT_EQ(code(1, [](CodedPiece& p) { p.bytes[p.bytes.size() / 2] ^= std::byte{4}; }),
            ErrorCode::corrupt);
  EXPECT_EQ(code(0, [](CodedPiece& p) { p.order.vertices[0] = p.order.vertices[1]; }),
            ErrorCode::bad_option);
  EXPECT_EQ(code(0, [](CodedPiece& p) { p.order.faces.pop_back(); }), ErrorCode::bad_option);
  EXPECT_EQ(code(0, [](CodedPiece& p) { p.order.first_corners.clear(); }), ErrorCode::bad_option);
  EXPECT_EQ(code(0, [](CodedPiece& p) { p.order.first_corners[3] = 3; }), ErrorCode::bad_option);
  EXPECT_EQ(code(0, [&](CodedPiece& p) { p = pieces->back(); }), ErrorCode::bad_option);
  EXPECT_EQ(apart->join(std::span(*pieces).first(1)).error().code, ErrorCode::bad_option);

  const auto piece = apart->piece(0);
  ASSERT_TRUE(piece);
  std::vector<std::byte> plan(apart->plan().begin(), apart->plan().end());
  for (std::size_t i = 0; i < plan.size(); ++i) {
    plan[i] ^= std::byte{1};
    EXPECT_EQ(encode_piece(*piece, plan, options).error().code, ErrorCode::corrupt) << i;
    plan[i] ^= std::byte{1};
    EXPECT_FALSE(encode_piece(*piece, std::span(plan).first(i), options)) << i;
  }
}

}  // namespace
}  // namespace clers

// Ways to decode that tests compare.
#ifndef CLERS_CODEC_TEST_DECODING_H
#define CLERS_CODEC_TEST_DECODING_H

#include <gtest/gtest.h>

#include <cstddef>
#include <span>

#include "codec/decoder.h"

namespace clers::internal::test {

/// Hands out one piece after the other.
template <class Take>
Expected<Done> decode_pieces(std::span<const std::byte> bytes, Take take,
                             const DecodeOptions& options = {}) {
  const auto decoder = Decoder::open(bytes, options);
  if (!decoder) return Failure{decoder.error()};
  for (std::size_t i = 0; i < decoder->piece_count(); ++i) {
    const auto piece = decoder->decode_piece(i);
    if (!piece) return Failure{piece.error()};
    take(*piece);
  }
  return Done{};
}

/// The first mesh of a file.
inline Expected<Done> decode_into(std::span<const std::byte> bytes, const MeshTarget& target,
                                  const DecodeOptions& options = {}) {
  const auto decoder = Decoder::open(bytes, options);
  if (!decoder) return Failure{decoder.error()};
  return decoder->decode_into(0, target);
}

/// Everything but the metadata, of which an encoder's report has none.
inline void expect_same_info(const MeshInfo& a, const MeshInfo& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.corners, b.corners);
  EXPECT_EQ(a.triangles_only, b.triangles_only);
  EXPECT_EQ(a.pieces, b.pieces);
  EXPECT_EQ(a.copied_vertices, b.copied_vertices);
  EXPECT_EQ(a.welded_vertices, b.welded_vertices);
  EXPECT_EQ(a.repeated_faces, b.repeated_faces);
  EXPECT_EQ(a.degenerate_faces, b.degenerate_faces);
  EXPECT_EQ(a.connectivity_bytes, b.connectivity_bytes);
  EXPECT_EQ(a.polygon_bytes, b.polygon_bytes);
  EXPECT_EQ(a.stitching_bytes, b.stitching_bytes);
  EXPECT_EQ(a.order_bytes, b.order_bytes);
  EXPECT_EQ(a.position_bytes, b.position_bytes);
  EXPECT_EQ(a.attribute_bytes, b.attribute_bytes);
  EXPECT_EQ(a.metadata_bytes, b.metadata_bytes);
  ASSERT_EQ(a.attributes.size(), b.attributes.size());
  for (std::size_t i = 0; i < a.attributes.size(); ++i) {
    const AttributeInfo &x = a.attributes[i], &y = b.attributes[i];
    EXPECT_EQ(x.name, y.name);
    EXPECT_EQ(x.domain, y.domain);
    EXPECT_EQ(x.scalar, y.scalar);
    EXPECT_EQ(x.components, y.components);
    EXPECT_EQ(x.count, y.count);
    EXPECT_EQ(x.bytes, y.bytes);
  }
}

}  // namespace clers::internal::test

#endif

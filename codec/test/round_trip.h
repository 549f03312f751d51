// Round trips checked by the permutations that encoding returns.
#ifndef CLERS_CODEC_TEST_ROUND_TRIP_H
#define CLERS_CODEC_TEST_ROUND_TRIP_H

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <vector>

#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/inspect.h"

namespace clers::internal {

inline std::uint32_t size_of_face(const Mesh& mesh, std::size_t f) {
  return mesh.triangles_only() ? 3 : mesh.face_sizes[f];
}

inline std::span<const std::byte> value(const Attribute& a, std::size_t i) {
  return std::span(a.data).subspan(i * a.stride(), a.stride());
}

inline bool equal(std::span<const std::byte> a, std::span<const std::byte> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

/// The decoded mesh is the input renumbered as the permutation says, bit for bit.
inline void expect_permuted(const Mesh& in, const Mesh& out, const Permutation& order) {
  ASSERT_EQ(out.vertex_count, in.vertex_count);
  ASSERT_EQ(out.corners.size(), in.corners.size());
  ASSERT_EQ(order.vertices.size(), in.vertex_count);
  ASSERT_EQ(order.faces.size(), in.face_count());
  EXPECT_EQ(out.name, in.name);
  std::vector<bool> vertex(in.vertex_count), face(in.face_count());
  for (const std::uint32_t v : order.vertices) {
    ASSERT_FALSE(vertex[v]);
    vertex[v] = true;
  }
  std::vector<std::size_t> begin = {0}, old_corner;
  for (std::size_t f = 0; f < in.face_count(); ++f) begin.push_back(begin[f] + size_of_face(in, f));
  std::size_t corner = 0;
  for (std::size_t i = 0; i < order.faces.size(); ++i) {
    const std::uint32_t f = order.faces[i];
    ASSERT_FALSE(face[f]);
    face[f] = true;
    const std::uint32_t size = size_of_face(in, f);
    ASSERT_EQ(size_of_face(out, i), size);
    for (std::uint32_t j = 0; j < size; ++j, ++corner) {
      old_corner.push_back(begin[f] + (order.first_corners[i] + j) % size);
      ASSERT_EQ(order.vertices[out.corners[corner]], in.corners[old_corner.back()]);
    }
  }
  ASSERT_EQ(out.attributes.size(), in.attributes.size());
  for (std::size_t k = 0; k < in.attributes.size(); ++k) {
    const Attribute &a = in.attributes[k], &b = out.attributes[k];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.domain, b.domain);
    EXPECT_EQ(a.scalar, b.scalar);
    EXPECT_EQ(a.components, b.components);
    ASSERT_EQ(a.data.size(), b.data.size());
    switch (a.domain) {
      case Domain::vertex:
        for (std::uint32_t v = 0; v < in.vertex_count; ++v)
          ASSERT_TRUE(equal(value(b, v), value(a, order.vertices[v])));
        break;
      case Domain::face:
        for (std::size_t f = 0; f < in.face_count(); ++f)
          ASSERT_TRUE(equal(value(b, f), value(a, order.faces[f])));
        break;
      case Domain::corner:
        for (std::size_t c = 0; c < in.corners.size(); ++c)
          ASSERT_TRUE(equal(value(b, c), value(a, old_corner[c])));
        break;
    }
  }
}

/// Whether a mesh is an oriented manifold: then coding it again once decoded gives the same bytes.
inline bool is_manifold(const Mesh& mesh) {
  const auto shape = measure(mesh);
  return shape && shape->nonmanifold_edges + shape->nonmanifold_vertices +
                          shape->misoriented_edges + shape->degenerate_faces ==
                      0;
}

/// Encodes, decodes, checks against the permutations, and encodes a manifold again to the same
/// bytes.
inline std::vector<std::byte> round_trip(std::span<const Mesh> meshes, int level = default_level,
                                         Order order = Order::free) {
  EncodeOptions options;
  options.level = level;
  options.order = order;
  auto coded = encode(meshes, options);
  EXPECT_TRUE(coded.ok()) << (coded.ok() ? "" : describe(coded.error()));
  if (!coded) return {};
  auto out = decode(coded->bytes);
  EXPECT_TRUE(out.ok()) << (out.ok() ? "" : describe(out.error()));
  if (!out) return {};
  EXPECT_EQ(out->size(), meshes.size());
  for (std::size_t i = 0; i < meshes.size(); ++i)
    expect_permuted(meshes[i], (*out)[i], coded->permutations[i]);
  if (std::all_of(meshes.begin(), meshes.end(), is_manifold)) {
    auto again = encode(*out, options);
    EXPECT_TRUE(again.ok() && again->bytes == coded->bytes) << "encoding is not idempotent";
  }
  return coded->bytes;
}

}  // namespace clers::internal

#endif

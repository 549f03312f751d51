// Coded surfaces of all kinds, to predict values along.
#ifndef CLERS_CODEC_TEST_CODED_SURFACES_H
#define CLERS_CODEC_TEST_CODED_SURFACES_H

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "codec/connectivity/coded_surface.h"
#include "codec/connectivity/connectivity.h"
#include "codec/soup/adjacency.h"
#include "codec/test/legal_streams.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::internal::test {

inline CodedArrays decoded(std::span<const std::byte> bytes) {
  const auto header = read_connectivity_header(bytes, 0);
  EXPECT_TRUE(header.ok());
  CodedArrays s;
  s.corners.resize(3 * std::size_t(header->faces));
  s.twins.resize(s.corners.size());
  s.introduced_by.resize(header->vertices);
  EXPECT_TRUE(decode_connectivity(bytes, 0, *header, s.corners, s.twins, s.introduced_by).ok());
  return s;
}

inline CodedArrays coded(const Mesh& mesh) {
  auto twins = find_twins({mesh.corners, mesh.face_sizes}, mesh.vertex_count);
  EXPECT_TRUE(twins.ok());
  const auto bytes = encode_connectivity({mesh.corners, *twins, mesh.vertex_count}, 5);
  EXPECT_TRUE(bytes.ok());
  return decoded(bytes->bytes);
}

/// A torus, with places by what `at(i, j)` says: i around it, j across. Three integers a vertex.
template <class Int, class At>
std::pair<CodedArrays, std::vector<Int>> coded_torus(std::uint32_t around, std::uint32_t across,
                                                     At at) {
  const Mesh mesh = corpus::torus(around, across);
  auto twins = find_twins({mesh.corners, mesh.face_sizes}, mesh.vertex_count);
  EXPECT_TRUE(twins.ok());
  const auto coded = encode_connectivity({mesh.corners, *twins, mesh.vertex_count}, 5);
  EXPECT_TRUE(coded.ok());
  std::vector<Int> rows;
  for (const std::uint32_t v : coded->vertices)
    for (const std::uint64_t x : at(v / across, v % across)) rows.push_back(static_cast<Int>(x));
  return {decoded(coded->bytes), rows};
}

/// A number of so many bits, always the same for a key.
inline std::uint64_t rough(std::uint64_t key, unsigned bits) {
  corpus::Random random(key);
  return random.next() >> (64 - bits);
}

/// A torus that is a rough profile moved along z: a place is three numbers that were there before.
template <class Int>
std::pair<CodedArrays, std::vector<Int>> moved_profile(unsigned bits) {
  return coded_torus<Int>(40, 30, [bits](std::uint32_t i, std::uint32_t j) {
    return std::array{rough(j, bits), rough(100 + j, bits), rough(200 + i, bits)};
  });
}

/// The surface with some of its vertices made one, as copies are.
inline CodedArrays stitched(CodedArrays s, corpus::Random& random) {
  const auto vertices = static_cast<std::uint32_t>(s.introduced_by.size());
  const std::uint32_t least = 1 + random.below(vertices);
  for (std::uint32_t& v : s.corners)
    if (v >= least) v = (v * 7 + 3) % least;
  s.introduced_by.assign(least, 0);
  find_introducing(s.corners, s.introduced_by);
  return s;
}

/// All kinds: closed, with holes, handles, components, and some at random; then vertices made one.
inline std::vector<CodedArrays> coded_surfaces(std::uint64_t at_random = 300) {
  std::vector<CodedArrays> all;
  for (const Mesh& mesh :
       {corpus::single_triangle(), corpus::glued_pair(), corpus::tetrahedron(),
        corpus::icosphere(2), corpus::torus(9, 7), corpus::grid(9, 5), corpus::loose_triangles(5),
        corpus::punch_holes(corpus::torus(20, 15), 12, 1),
        corpus::copies(corpus::punch_holes(corpus::icosphere(2), 3, 1), 3)})
    all.push_back(coded(mesh));
  for (std::uint64_t seed = 0; seed < at_random; ++seed) {
    corpus::Random random(seed);
    const LegalStream stream =
        legal_stream(1 + random.below(60), [&](std::uint32_t n) { return random.below(n); });
    all.push_back(decoded(stream.bytes));
  }
  corpus::Random random(1);
  for (std::size_t i = 0, n = all.size(); i < n; ++i) all.push_back(stitched(all[i], random));
  return all;
}

}  // namespace clers::internal::test

#endif

// Meshes for tests of comparisons: attributes made of values, and everything in another order.
#ifndef CLERS_CODEC_TEST_SHUFFLED_H
#define CLERS_CODEC_TEST_SHUFFLED_H

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "codec/mesh.h"
#include "codec/test/attribute.h"

namespace clers::internal::test {

using Index = std::uint32_t;

inline Index size_of_face(const Mesh& m, std::size_t f) {
  return m.triangles_only() ? 3 : m.face_sizes[f];
}

/// Renumbers vertices, reorders faces, turns cycles and reorders attributes at random.
inline Mesh shuffled(const Mesh& m, std::mt19937& random) {
  std::vector<Index> to(m.vertex_count), faces(m.face_count()), begin(m.face_count());
  std::iota(to.begin(), to.end(), 0u);
  std::shuffle(to.begin(), to.end(), random);
  std::iota(faces.begin(), faces.end(), 0u);
  std::shuffle(faces.begin(), faces.end(), random);
  for (Index f = 0, at = 0; f < begin.size(); ++f) {
    begin[f] = at;
    at += size_of_face(m, f);
  }
  std::vector<Index> old_vertex(m.vertex_count), old_corner;
  for (Index v = 0; v < m.vertex_count; ++v) old_vertex[to[v]] = v;
  Mesh out;
  out.vertex_count = m.vertex_count;
  for (const Index f : faces) {
    const Index n = size_of_face(m, f);
    if (!m.triangles_only()) out.face_sizes.push_back(n);
    const Index turn = n == 0 ? 0 : static_cast<Index>(random() % n);
    for (Index j = 0; j < n; ++j) old_corner.push_back(begin[f] + (j + turn) % n);
  }
  for (const Index c : old_corner) out.corners.push_back(to[m.corners[c]]);
  for (const Attribute& a : m.attributes) {
    Attribute moved = a;
    moved.data.clear();
    const auto& old = a.domain == Domain::vertex   ? old_vertex
                      : a.domain == Domain::corner ? old_corner
                                                   : faces;
    for (const Index i : old)
      moved.data.insert(moved.data.end(), a.data.begin() + std::ptrdiff_t(i * a.stride()),
                        a.data.begin() + std::ptrdiff_t((i + 1) * a.stride()));
    out.attributes.push_back(std::move(moved));
  }
  std::shuffle(out.attributes.begin(), out.attributes.end(), random);
  return out;
}

}  // namespace clers::internal::test

#endif

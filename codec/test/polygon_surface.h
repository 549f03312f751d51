// Surfaces of polygons by half-edges, of any topology: triangulated ones that lose edges.
#ifndef CLERS_CODEC_TEST_POLYGON_SURFACE_H
#define CLERS_CODEC_TEST_POLYGON_SURFACE_H

#include <algorithm>
#include <cstdint>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "codec/connectivity/edgebreaker.h"
#include "codec/mesh.h"
#include "codec/soup/adjacency.h"
#include "corpus/random_gluing.h"
#include "topology/ids.h"

namespace clers::internal::test {

/// Arrays that own their memory; no sizes: triangles.
struct SurfaceCopy {
  std::vector<std::uint32_t> org;
  std::vector<HalfEdge> twins;
  std::uint32_t vertex_count = 0;
  std::vector<std::uint32_t> sizes;

  SurfaceArrays arrays() { return {org, twins, vertex_count, sizes}; }
  std::size_t triangles() const {
    return sizes.empty() ? org.size() / 3 : org.size() - 2 * sizes.size();
  }
};

/// Precondition: an oriented manifold.
inline SurfaceCopy surface_of(const Mesh& mesh) {
  return {mesh.corners, *find_twins({mesh.corners, mesh.face_sizes}, mesh.vertex_count),
          mesh.vertex_count, mesh.face_sizes};
}

inline SurfaceCopy surface_of(const corpus::Gluing& gluing) {
  SurfaceCopy s{gluing.org, {}, gluing.vertex_count, {}};
  for (const std::uint32_t t : gluing.twin) s.twins.emplace_back(t);
  return s;
}

/// Of 100 edges of a triangulated surface so many go, as far as no face would repeat a vertex or
/// have more than `most` corners. Faces begin at a random corner.
inline SurfaceCopy without_edges(const SurfaceCopy& in, unsigned of_100, std::size_t most,
                                 std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto count = static_cast<std::uint32_t>(in.org.size());
  std::vector<std::vector<std::uint32_t>> cycles(count / 3);
  std::vector<std::uint32_t> face(count), edges(count);
  for (std::uint32_t h = 0; h < count; ++h) {
    cycles[h / 3].push_back(h);
    face[h] = h / 3;
    edges[h] = h;
  }
  std::shuffle(edges.begin(), edges.end(), random);
  for (const std::uint32_t h : edges) {
    const HalfEdge twin = in.twins[h];
    if (!twin || twin.index() < h || random() % 100 >= of_100) continue;
    const std::uint32_t f = face[h], g = face[twin.index()];
    if (f == g || cycles[f].size() + cycles[g].size() - 2 > most) continue;
    std::vector<std::uint32_t> merged;
    for (const auto& [cycle, gone] :
         {std::pair(cycles[f], h), std::pair(cycles[g], twin.index())}) {
      const auto at = std::find(cycle.begin(), cycle.end(), gone);
      merged.insert(merged.end(), at + 1, cycle.end());
      merged.insert(merged.end(), cycle.begin(), at);
    }
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t k : merged) vertices.push_back(in.org[k]);
    std::sort(vertices.begin(), vertices.end());
    if (std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end()) continue;
    for (const std::uint32_t k : merged) face[k] = f;
    cycles[f] = std::move(merged);
    cycles[g].clear();
  }
  SurfaceCopy out;
  out.vertex_count = in.vertex_count;
  std::vector<HalfEdge> number(count);
  for (std::vector<std::uint32_t>& cycle : cycles) {
    if (cycle.empty()) continue;
    std::rotate(cycle.begin(), cycle.begin() + static_cast<std::ptrdiff_t>(random() % cycle.size()),
                cycle.end());
    out.sizes.push_back(static_cast<std::uint32_t>(cycle.size()));
    for (const std::uint32_t h : cycle) {
      number[h] = HalfEdge(static_cast<std::uint32_t>(out.org.size()));
      out.org.push_back(in.org[h]);
    }
  }
  out.twins.resize(out.org.size());
  for (std::uint32_t h = 0; h < count; ++h)
    if (number[h] && in.twins[h]) out.twins[number[h].index()] = number[in.twins[h].index()];
  return out;
}

}  // namespace clers::internal::test

#endif

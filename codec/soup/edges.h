// The half-edges of faces, those of one edge together: any edges, without a word on what a surface
// may have.
#ifndef CLERS_CODEC_SOUP_EDGES_H
#define CLERS_CODEC_SOUP_EDGES_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "codec/base/faces.h"
#include "topology/buckets.h"

namespace clers::internal {

/// Bytes that for_each_edge takes.
constexpr std::uint64_t edges_memory(std::uint64_t corners, std::uint64_t vertices) {
  return 2 * sizeof(std::uint32_t) * corners + sizeof(std::uint32_t) * (vertices + 1);
}

/// Calls visit with all half-edges of an edge, in file order, for every edge, by its smaller and
/// then its larger vertex. Cost: linear (two passes of counting sort).
template <class Visit>
void for_each_edge(const Faces& faces, std::uint32_t vertex_count, Visit visit) {
  const std::uint32_t n = static_cast<std::uint32_t>(faces.org.size());
  const auto ends = [&](std::uint32_t h) {
    return std::minmax(faces.org[h], faces.org[faces.next(h)]);
  };
  const auto low = [&](std::uint32_t h) { return ends(h).first; };
  const auto high = [&](std::uint32_t h) { return ends(h).second; };
  std::vector<std::uint32_t> order = Buckets(n, vertex_count, high).items();
  order = Buckets(order, vertex_count, low).items();
  for (std::uint32_t i = 0; i < n;) {
    std::uint32_t j = i + 1;
    while (j < n && ends(order[i]) == ends(order[j])) ++j;
    visit(std::span<const std::uint32_t>(order).subspan(i, j - i));
    i = j;
  }
}

}  // namespace clers::internal

#endif

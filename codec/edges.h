// Half-edges of a triangle mesh as raw numbers, and sorted by their edge.
#ifndef CLERS_CODEC_EDGES_H
#define CLERS_CODEC_EDGES_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace clers {

inline std::uint32_t next_corner(std::uint32_t h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}
inline std::uint32_t previous_corner(std::uint32_t h) {
  return h % 3 == 0 ? h + 2 : h - 1;
}

/// The two ends of a half-edge's edge, smaller first.
inline std::pair<std::uint32_t, std::uint32_t> edge_of(std::span<const std::uint32_t> org,
                                                       std::uint32_t h) {
  return std::minmax({org[h], org[next_corner(h)]});
}

/// All half-edges, those of one edge together, in file order among themselves. Cost: a sort.
inline std::vector<std::uint32_t> sorted_by_edge(std::span<const std::uint32_t> org) {
  std::vector<std::uint32_t> order(org.size());
  for (std::uint32_t h = 0; h < order.size(); ++h) order[h] = h;
  std::sort(order.begin(), order.end(), [&](std::uint32_t g, std::uint32_t h) {
    const auto a = edge_of(org, g), b = edge_of(org, h);
    return a != b ? a < b : g < h;
  });
  return order;
}

}  // namespace clers

#endif

#include "codec/orientation.h"

#include <string>

#include "codec/edges.h"

namespace clers {

Expected<std::vector<bool>> find_orientation(std::span<const std::uint32_t> corners) {
  constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t> across(corners.size(), none);
  {
    const std::vector<std::uint32_t> order = sorted_by_edge(corners);
    for (std::size_t i = 0; i < order.size();) {
      std::size_t j = i + 1;
      while (j < order.size() && edge_of(corners, order[i]) == edge_of(corners, order[j])) ++j;
      if (j - i == 2) {
        across[order[i]] = order[i + 1];
        across[order[i + 1]] = order[i];
      }
      i = j;
    }
  }
  const std::size_t faces = corners.size() / 3;
  std::vector<bool> turned(faces), reached(faces);
  std::vector<std::uint32_t> component;
  for (std::uint32_t first = 0; first < faces; ++first) {
    if (reached[first]) continue;
    reached[first] = true;
    component.assign(1, first);
    std::size_t turned_count = 0;
    for (std::size_t i = 0; i < component.size(); ++i) {
      const std::uint32_t f = component[i];
      for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
        if (across[h] == none) continue;
        const std::uint32_t g = across[h] / 3;
        const bool same_way = corners[h] == corners[across[h]];
        const bool turn = turned[f] != same_way;
        if (!reached[g]) {
          reached[g] = true;
          turned[g] = turn;
          turned_count += turn;
          component.push_back(g);
        } else if (turned[g] != turn) {
          return fail(ErrorCode::nonorientable, Place::face, g,
                      "its component has no consistent orientation (the edge of vertices " +
                          std::to_string(corners[h]) + " and " +
                          std::to_string(corners[next_corner(h)]) + " shows it)");
        }
      }
    }
    if (2 * turned_count > component.size())
      for (const std::uint32_t f : component) turned[f] = !turned[f];
  }
  return turned;
}

}  // namespace clers

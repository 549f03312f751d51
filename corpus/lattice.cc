#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "corpus/build.h"
#include "corpus/generate.h"

namespace clers::corpus {

// Corner c of a cube lies at (c & 1, c >> 1 & 1, c >> 2).
Mesh lattice(std::uint32_t n) {
  struct Side {
    unsigned axis;
    bool upper;
    std::array<unsigned, 4> corners;  ///< counterclockwise from outside
  };
  static constexpr Side sides[] = {{0, false, {0, 4, 6, 2}}, {0, true, {1, 3, 7, 5}},
                                   {1, false, {0, 1, 5, 4}}, {1, true, {2, 6, 7, 3}},
                                   {2, false, {0, 2, 3, 1}}, {2, true, {4, 5, 7, 6}}};
  const std::size_t cubes = std::size_t{n} * n * n;
  Points points(8 * cubes);
  std::vector<std::uint32_t> corners;
  corners.reserve(72 * cubes);
  for (std::uint32_t z = 0; z < n; ++z)
    for (std::uint32_t y = 0; y < n; ++y)
      for (std::uint32_t x = 0; x < n; ++x) {
        const std::uint32_t cube = points.size();
        for (unsigned c = 0; c < 8; ++c)
          points.add(2.0 * x + (c & 1), 2.0 * y + (c >> 1 & 1), 2.0 * z + (c >> 2));
        const std::array<std::uint32_t, 3> at = {x, y, z};
        const std::array<std::uint32_t, 3> next = {8, 8 * n, 8 * n * n};
        for (const Side& side : sides) {
          const auto vertex = [&](unsigned k) { return cube + side.corners[k % 4]; };
          if (at[side.axis] == (side.upper ? n - 1 : 0)) {
            add_quad(corners, {vertex(0), vertex(1), vertex(2), vertex(3)});
          } else if (side.upper) {
            // The tube ends at the cube behind, at the corners that lie across.
            const std::uint32_t across = next[side.axis] - (1u << side.axis);
            for (unsigned k = 0; k < 4; ++k)
              add_quad(corners,
                       {vertex(k), vertex(k + 1), vertex(k + 1) + across, vertex(k) + across});
          }
        }
      }
  return make_mesh(points, std::move(corners));
}

}  // namespace clers::corpus

// Is what a codec gives back the mesh that went in?
#ifndef CLERS_BENCH_FIDELITY_H
#define CLERS_BENCH_FIDELITY_H

#include <cstdint>
#include <string>

#include "bench/codec.h"

namespace clers::bench {

/// Counted under the renumbering of vertices that the codec claims. Triangles are the same if they
/// have the same vertices in the same cyclic order. In mode file all is zero: what is not the same
/// bit for bit has failed.
struct Fidelity {
  std::uint64_t triangles_lost = 0;   ///< in the input, not in the output
  std::uint64_t triangles_added = 0;  ///< in the output, not in the input
  std::uint64_t vertices_lost = 0;    ///< of the input, with no vertex of the output
  std::uint64_t vertices_added = 0;   ///< further copies of a vertex of the input
  std::uint64_t positions_off = 0;    ///< further away than half a step, or, lossless, other bits

  bool same() const {
    return triangles_lost + triangles_added + vertices_lost + vertices_added + positions_off == 0;
  }
};

Fidelity check(const Input& input, const Output& output, Mode mode);

/// Step of the grid of `bits` bits, and the corner of the bounding box it starts from.
struct Grid {
  float origin[3];
  float side;
  float step;
};
Grid grid_of(const Input& input, int bits);

/// Positions on a grid of at most 16 bits, for those who do not quantise themselves, and back.
std::vector<std::uint16_t> on_grid(const std::vector<float>& positions, const Grid& grid);
std::vector<float> off_grid(const std::vector<std::uint16_t>& numbers, const Grid& grid);

}  // namespace clers::bench

#endif

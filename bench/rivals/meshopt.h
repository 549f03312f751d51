// meshoptimizer: index and vertex codecs, with zstd after them as its author advises.
#ifndef CLERS_BENCH_RIVALS_MESHOPT_H
#define CLERS_BENCH_RIVALS_MESHOPT_H

#include <string>
#include <vector>

#include "bench/codec.h"
#include "bench/fidelity.h"

namespace clers::bench {

/// meshopt-VERSION-{vcache,strip} by the order of triangles, raw and with -zstd19.
std::vector<CodecEntry> meshopt_codecs();
std::string meshopt_version();

/// Vertices as its codec takes them, in multiples of four bytes: three floats, or four 16-bit
/// numbers on the grid, the fourth 0.
std::vector<std::uint8_t> meshopt_vertices(const Input& input, Mode mode);
/// The way back of numbers on the grid, into `positions`.
void meshopt_off_grid(const std::uint8_t* vertices, std::size_t count, const Grid& grid,
                      float* positions);
constexpr std::size_t meshopt_stride(Mode mode) {
  return bits(mode) ? 8 : 12;
}
/// Bytes of what a decoder has to be told besides: three counts and, quantised, origin and step.
constexpr std::size_t meshopt_header(Mode mode) {
  return mode == Mode::connectivity ? 0 : bits(mode) ? 28 : 12;
}

}  // namespace clers::bench

#endif

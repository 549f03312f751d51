// Integers of vertices <-> bytes, fast: predicted along the order of triangles (hexagon.h), coded
// by static shares (residual_streams.h).
//
// Decoding has two steps, so that two threads can share it: residuals come from the bytes alone;
// values from residuals and the surface, whose twins are not needed.
#ifndef CLERS_CODEC_ATTRIBUTES_ORDERED_INTEGERS_H
#define CLERS_CODEC_ATTRIBUTES_ORDERED_INTEGERS_H

#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/attributes/hexagon.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// The bytes of rows of integers, one a vertex; none where there is nothing to say: no vertex, or
/// every top is 0. Palettes are not looked at. Preconditions: each integer is in 0 .. top; 1 .. 255
/// axes. Level 1 does not look for parts with shares of their own: that takes as long as all the
/// rest. Cost: linear.
template <class Int>
Bytes encode_ordered(const Lattice<const Int>& values, const CodedSurface& surface, int level);

/// Bytes that decode_residuals takes at most, besides the rows: weights, tables of states, and a
/// byte for a block of rows.
constexpr std::uint64_t residuals_memory(std::uint64_t count, std::uint64_t axes) {
  return (std::uint64_t(256) << 10) + 2200 * axes + count / 64;
}

/// Reads rows of residuals. `at` is the offset of `bytes` in the file. Errors: truncated, invalid.
template <class Int>
Expected<OrderPredictor> decode_residuals(std::span<const std::byte> bytes, std::uint64_t at,
                                          const Lattice<Int>& rows);

/// Makes values of rows of residuals, in place, with no memory besides. `at` is where they were
/// read. Errors: invalid, if one is not in 0 .. top; then what rows hold is anything.
template <class Int>
Expected<Done> add_steps(OrderPredictor predictor, const CodedSurface& surface, std::uint64_t at,
                         const Lattice<Int>& rows);

}  // namespace clers::internal

#endif

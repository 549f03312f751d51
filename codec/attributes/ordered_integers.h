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
#include "codec/attributes/lattice.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"

namespace clers::internal {

/// The bytes of rows of integers, one a vertex; none where there is nothing to say: no vertex, or
/// every top is 0. Palettes are not looked at. Preconditions: each integer is in 0 .. top; 1 .. 255
/// axes. Cost: linear.
template <class Int>
Bytes encode_ordered(const Lattice<const Int>& values, const CodedSurface& surface);

/// What decode_residuals takes at most.
inline constexpr std::uint64_t residuals_memory = 1 << 20;

/// Reads rows of residuals. Memory: residuals_memory at most. `at` is the offset of `bytes` in the
/// file. Errors: truncated, invalid.
template <class Int>
Expected<OrderPredictor> decode_residuals(std::span<const std::byte> bytes, std::uint64_t at,
                                          const Lattice<Int>& rows);

/// Makes values of rows of residuals, in place. `at` is where they were read. Errors: invalid, if
/// one is not in 0 .. top; then what rows hold is anything.
template <class Int>
Expected<Done> add_steps(OrderPredictor predictor, const CodedSurface& surface, std::uint64_t at,
                         const Lattice<Int>& rows);

}  // namespace clers::internal

#endif

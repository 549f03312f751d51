// Positions <-> bytes: residuals from parallelograms, in contexts of how large residuals are around
// (levels 5 to 9). codec/format-values.md, Residuals in contexts.
#ifndef CLERS_CODEC_ATTRIBUTES_SIZED_POSITIONS_H
#define CLERS_CODEC_ATTRIBUTES_SIZED_POSITIONS_H

#include <cstdint>
#include <span>

#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// In which order vertices are coded. The numbers are the file format's.
enum class VisitOrder : std::uint8_t {
  introduction = 0,    ///< as triangles introduce them: faster
  parallelograms = 1,  ///< those that two parallelograms predict first (visit_order.h): smaller
};

/// Int is std::int32_t or std::int64_t. Preconditions: three axes; every integer is one of its
/// axis; the surface has no vertex beyond the rows. Twins should be there: without them the order
/// is that of introduction, and the prediction a poor one. Vertices of no triangle come last.
template <class Int>
Bytes encode_sized_positions(const CodedSurface& surface, Lattice<Int> positions, VisitOrder order);

/// `at` is the offset of the bytes in the file. Of what is in the rows before nothing is used.
/// Precondition: as above. Errors: truncated, invalid; the rows hold no matter what then. Throws
/// std::bad_alloc only.
template <class Int>
Expected<Done> decode_sized_positions(std::span<const std::byte> bytes, std::uint64_t at,
                                      const CodedSurface& surface, Lattice<Int> positions);

/// What decoding these bytes allocates, for so many positions and triangles.
std::uint64_t sized_positions_memory(std::span<const std::byte> bytes, std::uint64_t count,
                                     std::uint64_t triangles);

}  // namespace clers::internal

#endif

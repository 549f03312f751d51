// The bytes of normals -> their integers.
#ifndef CLERS_CODEC_ATTRIBUTES_NORMAL_VALUES_DECODER_H
#define CLERS_CODEC_ATTRIBUTES_NORMAL_VALUES_DECODER_H

#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/attributes/value_surface.h"
#include "codec/error.h"
#include "codec/numbers/number_system.h"

namespace clers::internal {

/// Whether values with these numbers can be coded as normals along a surface: points of an
/// octahedral grid, or three components of floats or of integers of at most 16 bits; where vertices
/// have positions of three components.
bool may_be_normals(const Numbers& numbers, const ValueSurface& along);

/// Decodes what encode_normals made of values with these numbers. All rows come to be what their
/// axes say. `at` is the offset of the bytes in the file. Errors: truncated, invalid. Cost: linear,
/// and a sort of the vertices if the file says so; memory: normals_memory. Throws std::bad_alloc
/// only.
template <class Int>
Expected<Done> decode_normals(std::span<const std::byte> bytes, std::uint64_t at,
                              const Numbers& numbers, const ValueSurface& along,
                              std::span<Int> rows);

/// Bytes that decode_normals allocates, at most.
std::uint64_t normals_memory(std::uint64_t values, std::uint64_t vertices);

}  // namespace clers::internal

#endif

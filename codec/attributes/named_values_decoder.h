// The bytes of values of any name -> their integers.
#ifndef CLERS_CODEC_ATTRIBUTES_NAMED_VALUES_DECODER_H
#define CLERS_CODEC_ATTRIBUTES_NAMED_VALUES_DECODER_H

#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/attributes/value_surface.h"
#include "codec/error.h"
#include "codec/mesh.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// Decodes what encode_named_values made of values with these axes. `rows` are axes.size() a value;
/// all come to be what their axes say. `at` is the offset of the bytes in the file. Errors:
/// truncated, invalid. Cost: linear; memory: named_values_memory. Throws std::bad_alloc only.
template <class Int>
Expected<Done> decode_named_values(std::span<const std::byte> bytes, std::uint64_t at,
                                   std::span<const Axis> axes, const ValueSurface& along,
                                   std::span<Int> rows, Domain domain = Domain::vertex);

/// Bytes that decode_named_values allocates; `vertices` are those of values of corners, else 0.
std::uint64_t named_values_memory(std::uint64_t values, std::uint64_t components,
                                  std::uint64_t vertices = 0);

}  // namespace clers::internal

#endif

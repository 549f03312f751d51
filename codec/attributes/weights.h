// Weights, which are parts of a whole: components that mostly add up to 1, many of them 0, as those
// of a skin do <-> bytes. codec/format-values.md, Weights.
#ifndef CLERS_CODEC_ATTRIBUTES_WEIGHTS_H
#define CLERS_CODEC_ATTRIBUTES_WEIGHTS_H

#include <cstdint>
#include <span>

#include "codec/attributes/value_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/numbers/number_system.h"

namespace clers::internal {

/// Whether they are numbers of 2 to 16 components that can be added up: floats, or integers that
/// are parts of the greatest of their type.
bool may_be_weights(const Numbers& numbers);

/// Whether at least half of the values add up to 1, or nearly. Precondition: may_be_weights.
template <class Int>
bool look_like_weights(std::span<const Int> rows, const Numbers& numbers);

/// Whether these are joints for so many values of so many components.
bool fit_as_joints(const Attribute& joints, std::size_t values, std::size_t components);

/// With along.joints, which fit, by what weights the same joints have around. Int is std::int32_t
/// or std::int64_t. Preconditions: may_be_weights; every integer is one of its axis; the surface
/// has no value beyond the rows. Cost: linear.
template <class Int>
Bytes encode_weights(std::span<const Int> rows, const Numbers& numbers, const ValueSurface& along);

/// With along.joints if and only if they were there. `at` is the offset of the bytes in the file.
/// Of what is in the rows before nothing is used. Errors: truncated, invalid; the rows hold no
/// matter what then. Throws std::bad_alloc only.
template <class Int>
Expected<Done> decode_weights(std::span<const std::byte> bytes, std::uint64_t at,
                              const Numbers& numbers, const ValueSurface& along,
                              std::span<Int> rows);

/// What decoding allocates.
std::uint64_t weights_memory(std::uint64_t values, std::uint64_t components,
                             std::uint64_t vertices);

}  // namespace clers::internal

#endif

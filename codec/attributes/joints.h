// Joints of a skin: the bones that a vertex moves with, a tuple of small integers that mostly is
// that of a neighbour <-> bytes. codec/format-values.md, Joints.
#ifndef CLERS_CODEC_ATTRIBUTES_JOINTS_H
#define CLERS_CODEC_ATTRIBUTES_JOINTS_H

#include <cstdint>
#include <span>

#include "codec/attributes/value_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// Whether values are tuples of 2 to 16 integers of 16 bits at most.
bool may_be_joints(std::span<const Axis> axes);

/// Whether at least half of the values are those of a neighbour. Precondition: may_be_joints.
bool look_like_joints(std::span<const std::int32_t> rows, std::span<const Axis> axes,
                      const ValueSurface& along);

/// Palettes are not used: a joint has one number in all components. Preconditions: may_be_joints;
/// every integer is in 0 .. top; the surface has no value beyond the rows. Cost: linear.
Bytes encode_joints(std::span<const std::int32_t> rows, std::span<const Axis> axes,
                    const ValueSurface& along);

/// `at` is the offset of the bytes in the file. Of what is in the rows before nothing is used.
/// Errors: truncated, invalid; the rows hold no matter what then. Throws std::bad_alloc only.
Expected<Done> decode_joints(std::span<const std::byte> bytes, std::uint64_t at,
                             std::span<const Axis> axes, const ValueSurface& along,
                             std::span<std::int32_t> rows);

/// What decoding allocates.
std::uint64_t joints_memory(std::uint64_t values, std::uint64_t components, std::uint64_t vertices);

}  // namespace clers::internal

#endif

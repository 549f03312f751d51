// Integers of normals -> bytes.
#ifndef CLERS_CODEC_ATTRIBUTES_NORMAL_VALUES_ENCODER_H
#define CLERS_CODEC_ATTRIBUTES_NORMAL_VALUES_ENCODER_H

#include <span>

#include "codec/attributes/value_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/numbers/number_system.h"

namespace clers::internal {

/// Whether at least a quarter of the values are within 25 degrees of a normal of the geometry, or
/// of its opposite: others are something else. Precondition: may_be_normals. Cost: linear.
template <class Int>
bool look_like_normals(std::span<const Int> rows, const Numbers& numbers,
                       const ValueSurface& along);

/// Encodes normals by the formula that predicts the first of them best. Preconditions:
/// may_be_normals, and what lattice.h says; points of an octahedral grid are the places that it
/// gives them. Cost: linear for each formula that is tried, twelve at most. Throws std::bad_alloc
/// only.
template <class Int>
Bytes encode_normals(std::span<const Int> rows, const Numbers& numbers, const ValueSurface& along,
                     int level);

}  // namespace clers::internal

#endif

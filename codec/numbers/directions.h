// Vectors moved to directions of an octahedral grid.
#ifndef CLERS_CODEC_NUMBERS_DIRECTIONS_H
#define CLERS_CODEC_NUMBERS_DIRECTIONS_H

#include <cstddef>

#include "codec/error.h"
#include "codec/mesh_view.h"
#include "codec/numbers/quantise.h"

namespace clers::internal {

/// How many values an attribute has.
inline std::size_t value_count(const AttributeView& a) {
  return a.data.empty() ? 0 : 1 + (a.data.size() - a.value_size()) / a.step();
}

/// Whether all values are vectors of three floats whose length is 1, to a thousandth.
bool are_unit_vectors(const AttributeView& attribute);

/// Moves each value to the nearest direction of a grid of so many bits: a vector of length 1,
/// whatever its length was. The error is the largest angle. Errors: not_on_grid, a value without
/// direction (0, NaN, infinite). Preconditions: three floats a value, bits as in octahedral.h.
/// Cost: linear.
Expected<QuantisedValues> quantise_directions(const AttributeView& attribute, unsigned bits);

/// That a value has no direction.
Failure<Error> no_direction(const AttributeView& attribute, std::size_t value);

}  // namespace clers::internal

#endif

// Values moved to the points of a grid: no more than half a step, and what their type rounds.
//
// A grid is found for all values of a mesh at once, so that its pieces share it. What comes out is
// values again, which a number system has exactly: whoever codes them loses nothing more.
#ifndef CLERS_CODEC_NUMBERS_QUANTISE_H
#define CLERS_CODEC_NUMBERS_QUANTISE_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "codec/error.h"
#include "codec/mesh_view.h"
#include "codec/numbers/number_system.h"
#include "codec/numbers/outliers.h"
#include "codec/precision.h"

namespace clers::internal {

struct QuantisedValues {
  /// Has no error where all values stay as they are, bit for bit, and no systems then but for
  /// directions. Has no systems either where numbers or steps are greater or smaller than a file
  /// says of a grid.
  AttributePlan plan;
  std::vector<std::byte> values;  ///< as they are decoded, packed, if there is an error
  std::optional<Outliers> outliers = {};
};

/// What is wrong with a precision, whatever it is for; empty: nothing.
std::string precision_fault(const Precision& precision);

/// Quantises the values of an attribute. Each component becomes the nearest of the numbers that its
/// grid has, the lower of two; so it is off by half a step at most, and by what the map of the
/// number system and the type round: less than half a unit in the last place of the type, and two
/// of a double as large as the largest number. With Precision::Kind::error it is never off by more
/// than was asked. Zeros that stay zeros keep their sign on grids that do not depend on the values.
///
/// A component that is on a coarser grid already stays as it is, and is moved to one that it is
/// nearly on (near_grid.h), unless the grid does not depend on the values.
///
/// Directions: directions.h.
///
/// Errors: bad_option (another number of origins; directions of what is not three floats),
/// not_on_grid. Preconditions: no precision_fault; not Precision::Kind::recomputed.
/// Cost: linear, and a copy of the values.
/// Where `as_values` is set, integers are never handed on instead: others need the values.
Expected<QuantisedValues> quantise(const AttributeView& attribute, const Precision& precision,
                                   bool as_values = false);

}  // namespace clers::internal

#endif

// `min` and `max` of accessors: what the values say, in the way in which whoever wrote a document
// writes numbers.
#ifndef CLERS_CODEC_GLTF_BOUNDS_H
#define CLERS_CODEC_GLTF_BOUNDS_H

#include "codec/gltf/json.h"
#include "codec/gltf/layout.h"
#include "codec/gltf/marks.h"
#include "codec/gltf/plan.h"
#include "codec/gltf/values.h"

namespace clers::gltf {

/// Makes null each `min` and `max` that is just what restore_bounds would write, in the style that
/// most are in, which the marks say. So they do of those that are wrong.
void shorten_bounds(const Layout& layout, const Plan& plan, const Buffers& buffers, Json& document,
                    Marks& marks);

/// Writes what is null, and what is not true of the values but was.
void restore_bounds(const Layout& layout, const Plan& plan, const Buffers& buffers,
                    const Marks& marks, Json& document);

/// Styles of numbers. Digits are the fewest that give back a double, or a float of 32 bits.
enum class Style : std::uint8_t {
  rapidjson,     ///< 1.0, and sometimes a digit more
  script,        ///< 1, 1e-7: as JavaScript
  python,        ///< 1.0, 1e-07
  script_float,  ///< the same of floats
  python_float,
};
std::string text_of(double value, Style style);

}  // namespace clers::gltf

#endif

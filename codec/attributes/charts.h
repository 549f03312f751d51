// Values of two components that lay a surface flat, chart by chart, as texture coordinates do <->
// bytes. codec/format-values.md, Charts.
#ifndef CLERS_CODEC_ATTRIBUTES_CHARTS_H
#define CLERS_CODEC_ATTRIBUTES_CHARTS_H

#include <cstdint>
#include <span>

#include "codec/attributes/value_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// Whether values may be coded so: two components, and others that are the same everywhere.
inline bool may_be_charts(std::span<const Axis> axes) {
  if (axes.size() < 2) return false;
  for (const Axis& axis : axes.subspan(2))
    if (axis.top != 0 && axis.palette.size() != 1) return false;
  return true;
}

/// Int is std::int32_t or std::int64_t. Preconditions: may_be_charts; every integer is one of its
/// axis; the surface has no value beyond the rows, and vertices below `along.vertex` have
/// positions, if there are any. Twins should be there: without them the prediction is a poor one.
template <class Int>
Bytes encode_charts(const Lattice<Int>& values, const ValueSurface& along, int level);

/// `at` is the offset of the bytes in the file. Of what is in the rows before nothing is used.
/// Precondition: as above. Errors: truncated, invalid; the rows hold no matter what then. Throws
/// std::bad_alloc only.
template <class Int>
Expected<Done> decode_charts(std::span<const std::byte> bytes, std::uint64_t at,
                             std::span<const Axis> axes, const ValueSurface& along,
                             std::span<Int> rows);

/// What decoding allocates.
std::uint64_t charts_memory(std::uint64_t values, std::uint64_t components, std::uint64_t vertices);

}  // namespace clers::internal

#endif

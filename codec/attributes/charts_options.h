// How charts are coded, as the encoder chose <-> bytes.
#ifndef CLERS_CODEC_ATTRIBUTES_CHARTS_OPTIONS_H
#define CLERS_CODEC_ATTRIBUTES_CHARTS_OPTIONS_H

#include <cstdint>
#include <optional>
#include <span>

#include "codec/attributes/value_repeats.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

struct ChartsOptions {
  bool by_parallelograms = false;  ///< the order of visit, else that of introduction
  bool fractions = false;          ///< small residuals have contexts by what means are rounded off
  bool same = false;               ///< is a value that which was coded last at its vertex?
  std::optional<Likeness> likeness = {};
};

inline void put_charts_options(Bytes& out, const ChartsOptions& options) {
  put_u8(out, (options.by_parallelograms ? 1 : 0) | (options.fractions ? 2 : 0) |
                  (options.same ? 4 : 0));
  put_likeness(out, options.likeness);
}

/// Reads and checks what put_charts_options wrote. Errors: truncated, invalid. Precondition: two
/// axes.
inline Expected<ChartsOptions> read_charts_options(ByteReader& in, std::span<const Axis> axes,
                                                   bool twins) {
  const std::uint64_t at = in.offset();
  const std::uint32_t bits = in.u8();
  auto likeness = read_likeness(in, axes);
  if (!likeness) return Failure{likeness.error()};
  if (bits > 7 || (!twins && ((bits & 1) != 0 || *likeness)))
    return fail(ErrorCode::invalid, Place::byte, at, "an order of charts that there is not");
  return ChartsOptions{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, *likeness};
}

}  // namespace clers::internal

#endif

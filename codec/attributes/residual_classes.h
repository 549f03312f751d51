// Residuals <-> classes of about the same size, and raw bits within. It knows single numbers only.
//
// 0, 1, 2 and 3 are a class each, then two an octave: 4-5, 6-7, 8-11, 12-15, 16-23 .. and the same
// below zero. The shares of classes adapt to any distribution, and within one it is nearly even.
#ifndef CLERS_CODEC_ATTRIBUTES_RESIDUAL_CLASSES_H
#define CLERS_CODEC_ATTRIBUTES_RESIDUAL_CLASSES_H

#include <array>
#include <bit>
#include <cstdint>

#include "codec/base/portable.h"

namespace clers::internal {

/// Of residuals below 2^62: 0, then for each magnitude that above zero and that below.
inline constexpr unsigned residual_classes = 1 + 2 * (2 * 61 + 1);

/// How many raw bits a residual of a class has.
constexpr unsigned raw_bits(unsigned residual_class) {
  const unsigned magnitude = (residual_class + 1) / 2;
  return magnitude < 4 ? 0 : magnitude / 2 - 1;
}
/// The least residual of a class.
constexpr std::int64_t least_of(unsigned residual_class) {
  const unsigned magnitude = (residual_class + 1) / 2, raw = raw_bits(residual_class);
  const std::int64_t least = magnitude < 4 ? magnitude : std::int64_t(2 | (magnitude & 1)) << raw;
  return residual_class % 2 != 0 || residual_class == 0 ? least
                                                        : -(least + (std::int64_t(1) << raw) - 1);
}

/// Precondition: -2^62 < residual < 2^62.
CLERS_ALWAYS_INLINE unsigned class_of(std::int64_t residual) {
  const std::uint64_t sign = residual < 0 ? ~std::uint64_t(0) : 0;
  const std::uint64_t m = (static_cast<std::uint64_t>(residual) ^ sign) - sign;
  const unsigned octave = static_cast<unsigned>(std::bit_width(m | 1)) - 1;
  const unsigned magnitude = 2 * octave + static_cast<unsigned>(2 * m >> octave & 1) + (m == 1);
  return 2 * magnitude - (sign == 0 && m != 0);
}

/// least_of of all classes.
template <class Int>
constexpr std::array<Int, residual_classes> least_residuals() {
  std::array<Int, residual_classes> least{};
  for (unsigned c = 0; c < residual_classes; ++c) least[c] = static_cast<Int>(least_of(c));
  return least;
}

}  // namespace clers::internal

#endif

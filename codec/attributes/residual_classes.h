// Residuals <-> classes of about the same size, and raw bits within. It knows single numbers only.
//
// 0, 1, 2 and 3 are a class each, then two an octave: 4-5, 6-7, 8-11, 12-15, 16-23 .. and the same
// below zero. The shares of classes adapt to any distribution, and within one it is nearly even.
#ifndef CLERS_CODEC_ATTRIBUTES_RESIDUAL_CLASSES_H
#define CLERS_CODEC_ATTRIBUTES_RESIDUAL_CLASSES_H

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/base/portable.h"

#if CLERS_SSE2
#include <emmintrin.h>
#endif

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

#if CLERS_SSE2
/// A float's bits begin with the octave and the mantissa bit that classes are made of. So that
/// rounding to 24 bits changes neither, bits far below the highest one are taken away first.
CLERS_ALWAYS_INLINE __m128i four_classes(__m128i residuals) {
  const __m128i sign = _mm_srai_epi32(residuals, 31);
  const __m128i m = _mm_sub_epi32(_mm_xor_si128(residuals, sign), sign);
  const __m128i rounded = _mm_andnot_si128(_mm_srli_epi32(m, 8), m);
  const __m128i bits =
      _mm_srli_epi32(_mm_castps_si128(_mm_cvtepi32_ps(rounded)), 22);  // 2 (127 + octave) + bit
  const __m128i above = _mm_subs_epu16(bits, _mm_set1_epi32(2 * 127));
  const __m128i magnitude = _mm_sub_epi32(above, _mm_cmpeq_epi32(m, _mm_set1_epi32(1)));
  return _mm_add_epi32(_mm_add_epi32(magnitude, magnitude),
                       _mm_cmpgt_epi32(residuals, _mm_setzero_si128()));
}
CLERS_ALWAYS_INLINE void sixteen_classes(const std::int32_t* residuals, std::uint8_t* classes) {
  const __m128i* from = reinterpret_cast<const __m128i*>(residuals);
  __m128i four[4];
  for (int i = 0; i < 4; ++i) four[i] = four_classes(_mm_loadu_si128(from + i));
  _mm_storeu_si128(
      reinterpret_cast<__m128i*>(classes),
      _mm_packus_epi16(_mm_packs_epi32(four[0], four[1]), _mm_packs_epi32(four[2], four[3])));
}
#endif

/// Classes of many residuals.
template <class Int>
void classes_of(std::span<const Int> residuals, std::uint8_t* classes) {
  std::size_t i = 0;
#if CLERS_SSE2
  if constexpr (sizeof(Int) == 4)
    for (; i + 16 <= residuals.size(); i += 16) sixteen_classes(&residuals[i], classes + i);
#endif
  for (; i < residuals.size(); ++i) classes[i] = static_cast<std::uint8_t>(class_of(residuals[i]));
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

// Logistic mixing in integers: the logit of a probability as a weighted sum of others' logits, the
// weights learned as the outcomes come (Mahoney's PAQ).
//
// The loops are written twice, with SSE2 and plainly, and give the same weights bit for bit.
#ifndef CLERS_CODEC_ENTROPY_MIXER_H
#define CLERS_CODEC_ENTROPY_MIXER_H

#include <cstdint>

#include "codec/base/portable.h"
#if CLERS_SSE2
#include <emmintrin.h>
#endif

namespace clers::internal::mixer {

/// Inputs are logits in 1/256, |x| <= 4096; weights are in units of 2^-28, and their top 16 bits
/// multiply. n is a multiple of 8, at most 64, so that no sum overflows.
inline constexpr int one = 1 << 28;

namespace portable {

CLERS_ALWAYS_INLINE std::int32_t dot(const std::int16_t* x, const std::int32_t* w, unsigned n) {
  std::uint32_t sum = 0;
  for (unsigned i = 0; i < n; ++i) sum += static_cast<std::uint32_t>(x[i] * (w[i] >> 16));
  return static_cast<std::int32_t>(sum);
}

/// w += x * e / 2^shift, rounded down, modulo 2^32.
template <int shift = 3>
CLERS_ALWAYS_INLINE void train(const std::int16_t* x, std::int32_t* w, unsigned n, std::int16_t e) {
  for (unsigned i = 0; i < n; ++i)
    w[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(w[i]) +
                                     static_cast<std::uint32_t>((x[i] * e) >> shift));
}

}  // namespace portable

#if CLERS_SSE2

CLERS_ALWAYS_INLINE std::int32_t dot(const std::int16_t* x, const std::int32_t* w, unsigned n) {
  __m128i sum = _mm_setzero_si128();
  for (unsigned i = 0; i < n; i += 8) {
    const __m128i low = _mm_load_si128(reinterpret_cast<const __m128i*>(w + i));
    const __m128i high = _mm_load_si128(reinterpret_cast<const __m128i*>(w + i + 4));
    const __m128i tops = _mm_packs_epi32(_mm_srai_epi32(low, 16), _mm_srai_epi32(high, 16));
    const __m128i in = _mm_load_si128(reinterpret_cast<const __m128i*>(x + i));
    sum = _mm_add_epi32(sum, _mm_madd_epi16(in, tops));
  }
  sum = _mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0x4e));
  sum = _mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0xb1));
  return _mm_cvtsi128_si32(sum);
}

template <int shift = 3>
CLERS_ALWAYS_INLINE void train(const std::int16_t* x, std::int32_t* w, unsigned n, std::int16_t e) {
  const __m128i error = _mm_set1_epi16(e);
  for (unsigned i = 0; i < n; i += 8) {
    __m128i* const at = reinterpret_cast<__m128i*>(w + i);
    const __m128i in = _mm_load_si128(reinterpret_cast<const __m128i*>(x + i));
    const __m128i low = _mm_mullo_epi16(in, error), high = _mm_mulhi_epi16(in, error);
    const __m128i first = _mm_srai_epi32(_mm_unpacklo_epi16(low, high), shift);
    const __m128i second = _mm_srai_epi32(_mm_unpackhi_epi16(low, high), shift);
    _mm_store_si128(at, _mm_add_epi32(_mm_load_si128(at), first));
    _mm_store_si128(at + 1, _mm_add_epi32(_mm_load_si128(at + 1), second));
  }
}

#else

using portable::dot;
using portable::train;

#endif

}  // namespace clers::internal::mixer

#endif

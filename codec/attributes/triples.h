// Positions as three numbers each, in the two widths that they are computed in: few bits, where
// vector instructions do it, and any. Knows no surface.
#ifndef CLERS_CODEC_ATTRIBUTES_TRIPLES_H
#define CLERS_CODEC_ATTRIBUTES_TRIPLES_H

#include <array>
#include <cstdint>

#include "codec/base/portable.h"

#if CLERS_SSE2
#include <emmintrin.h>
#endif

namespace clers::internal {

/// Three components and what is kept beside them, that fit a vector together.
template <class Int>
struct alignas(16) Quadruple {
  Int at[4] = {};
};

/// Three numbers, one after the other. None of the operations may overflow.
template <class Int>
struct Scalars {
  using Number = Int;
  Quadruple<Int> q;

  CLERS_ALWAYS_INLINE explicit Scalars(const Quadruple<Int>& x) : q(x) {}

  CLERS_ALWAYS_INLINE Quadruple<Int> stored() const { return q; }
  CLERS_ALWAYS_INLINE friend Scalars operator+(Scalars x, Scalars y) {
    for (unsigned c = 0; c < 3; ++c) x.q.at[c] += y.q.at[c];
    return x;
  }
  CLERS_ALWAYS_INLINE friend Scalars operator-(Scalars x, Scalars y) {
    for (unsigned c = 0; c < 3; ++c) x.q.at[c] -= y.q.at[c];
    return x;
  }
  /// Itself or zeros.
  CLERS_ALWAYS_INLINE Scalars when(bool yes) const {
    Scalars x = *this;
    for (unsigned c = 0; c < 3; ++c) x.q.at[c] &= -static_cast<Int>(yes);
    return x;
  }
  CLERS_ALWAYS_INLINE Scalars magnitude() const {
    Scalars x = *this;
    for (unsigned c = 0; c < 3; ++c) x.q.at[c] = x.q.at[c] < 0 ? -x.q.at[c] : x.q.at[c];
    return x;
  }
};

using Wide = Scalars<std::int64_t>;

#if CLERS_SSE2

/// The same, of 32 bits.
struct Narrow {
  using Number = std::int32_t;
  __m128i lanes;

  CLERS_ALWAYS_INLINE explicit Narrow(const Quadruple<std::int32_t>& q)
      : lanes(_mm_load_si128(reinterpret_cast<const __m128i*>(q.at))) {}
  CLERS_ALWAYS_INLINE explicit Narrow(__m128i l) : lanes(l) {}

  CLERS_ALWAYS_INLINE Quadruple<std::int32_t> stored() const {
    Quadruple<std::int32_t> q;
    _mm_store_si128(reinterpret_cast<__m128i*>(q.at), lanes);
    return q;
  }
  CLERS_ALWAYS_INLINE friend Narrow operator+(Narrow x, Narrow y) {
    return Narrow(_mm_add_epi32(x.lanes, y.lanes));
  }
  CLERS_ALWAYS_INLINE friend Narrow operator-(Narrow x, Narrow y) {
    return Narrow(_mm_sub_epi32(x.lanes, y.lanes));
  }
  /// Itself or zeros.
  CLERS_ALWAYS_INLINE Narrow when(bool yes) const {
    return Narrow(_mm_and_si128(lanes, _mm_set1_epi32(-static_cast<int>(yes))));
  }
  CLERS_ALWAYS_INLINE Narrow magnitude() const {
    const __m128i sign = _mm_srai_epi32(lanes, 31);
    return Narrow(_mm_sub_epi32(_mm_xor_si128(lanes, sign), sign));
  }
};

/// The cross product, of numbers of at most 15 bits with their sign.
CLERS_ALWAYS_INLINE Narrow cross_of_short(Narrow e, Narrow f) {
  // In each lane two products of 16 bits: e1 f2 and e2 (- f1).
  const __m128i low = _mm_set1_epi32(0xffff);
  const __m128i e1 = _mm_shuffle_epi32(e.lanes, _MM_SHUFFLE(3, 0, 2, 1)),
                e2 = _mm_shuffle_epi32(e.lanes, _MM_SHUFFLE(3, 1, 0, 2)),
                f2 = _mm_shuffle_epi32(f.lanes, _MM_SHUFFLE(3, 1, 0, 2)),
                f1 = _mm_sub_epi32(_mm_setzero_si128(),
                                   _mm_shuffle_epi32(f.lanes, _MM_SHUFFLE(3, 0, 2, 1)));
  const __m128i left = _mm_or_si128(_mm_and_si128(e1, low), _mm_slli_epi32(e2, 16)),
                right = _mm_or_si128(_mm_and_si128(f2, low), _mm_slli_epi32(f1, 16));
  return Narrow(_mm_madd_epi16(left, right));
}

#else

using Narrow = Scalars<std::int32_t>;

inline Narrow cross_of_short(Narrow e, Narrow f) {
  const auto& x = e.q.at;
  const auto& y = f.q.at;
  return Narrow(Quadruple<std::int32_t>{
      {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0], 0}});
}

#endif

}  // namespace clers::internal

#endif

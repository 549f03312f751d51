// Four 32-bit numbers at a time where there is SSE2, one at a time everywhere: the same words for
// both, so that what is computed is written once. Conditions are masks: all bits or none.
#ifndef CLERS_CODEC_BASE_LANES_H
#define CLERS_CODEC_BASE_LANES_H

#include <cstdint>

#include "codec/base/portable.h"

#if CLERS_SSE2
#include <emmintrin.h>
#endif

namespace clers::internal {

struct OneLane {
  std::uint32_t v;

  static OneLane all(std::uint32_t x) { return {x}; }
  friend OneLane operator&(OneLane x, OneLane y) { return {x.v & y.v}; }
  friend OneLane operator|(OneLane x, OneLane y) { return {x.v | y.v}; }
  friend OneLane operator^(OneLane x, OneLane y) { return {x.v ^ y.v}; }
  /// Borrows from above 32 bits if x and y are equal.
  friend OneLane equal(OneLane x, OneLane y) {
    return {static_cast<std::uint32_t>((std::uint64_t(x.v ^ y.v) - 1) >> 32)};
  }
  friend OneLane less(OneLane x, OneLane y) {
    return {static_cast<std::uint32_t>((std::uint64_t(x.v) - y.v) >> 32)};
  }
};

#if CLERS_SSE2
struct FourLanes {
  __m128i v;

  static FourLanes all(std::uint32_t x) { return {_mm_set1_epi32(static_cast<int>(x))}; }
  static FourLanes load(const std::uint32_t* p) {
    return {_mm_loadu_si128(reinterpret_cast<const __m128i*>(p))};
  }
  void store(std::uint32_t* p) const { _mm_storeu_si128(reinterpret_cast<__m128i*>(p), v); }
  /// A bit a lane, of a mask.
  unsigned bits() const { return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(v))); }
  friend FourLanes operator&(FourLanes x, FourLanes y) { return {_mm_and_si128(x.v, y.v)}; }
  friend FourLanes operator|(FourLanes x, FourLanes y) { return {_mm_or_si128(x.v, y.v)}; }
  friend FourLanes operator^(FourLanes x, FourLanes y) { return {_mm_xor_si128(x.v, y.v)}; }
  friend FourLanes operator+(FourLanes x, FourLanes y) { return {_mm_add_epi32(x.v, y.v)}; }
  friend FourLanes equal(FourLanes x, FourLanes y) { return {_mm_cmpeq_epi32(x.v, y.v)}; }
  friend FourLanes less(FourLanes x, FourLanes y) {
    const FourLanes top = all(0x80000000u);
    return {_mm_cmplt_epi32((x ^ top).v, (y ^ top).v)};
  }
};

/// Rows as columns.
CLERS_ALWAYS_INLINE void transpose(FourLanes (&x)[4]) {
  const __m128i a = _mm_unpacklo_epi32(x[0].v, x[1].v), b = _mm_unpacklo_epi32(x[2].v, x[3].v);
  const __m128i c = _mm_unpackhi_epi32(x[0].v, x[1].v), d = _mm_unpackhi_epi32(x[2].v, x[3].v);
  x[0] = {_mm_unpacklo_epi64(a, b)};
  x[1] = {_mm_unpackhi_epi64(a, b)};
  x[2] = {_mm_unpacklo_epi64(c, d)};
  x[3] = {_mm_unpackhi_epi64(c, d)};
}
#endif

/// x where the mask is, else y.
template <class Lanes>
CLERS_ALWAYS_INLINE Lanes select(Lanes mask, Lanes x, Lanes y) {
  return y ^ ((x ^ y) & mask);
}

}  // namespace clers::internal

#endif

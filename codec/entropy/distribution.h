// An adaptive distribution of sixteen symbols, found and learned by vector instructions. Knows no
// coder.
#ifndef CLERS_CODEC_ENTROPY_DISTRIBUTION_H
#define CLERS_CODEC_ENTROPY_DISTRIBUTION_H

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "codec/base/portable.h"

#if CLERS_SSE2
#include <emmintrin.h>
#endif

namespace clers::internal {

/// What symbols are given shares of.
inline constexpr unsigned share_bits = 14;
inline constexpr std::uint32_t shares = 1u << share_bits;

/// Where the share of each of sixteen symbols starts. It ends where the next one starts, the last
/// one's at `shares`.
struct alignas(16) Starts {
  std::uint16_t at[17] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, shares};

  /// The symbol in whose share a place is.
  CLERS_ALWAYS_INLINE unsigned find(std::uint32_t place) const {
#if CLERS_SSE2
    const __m128i p = _mm_set1_epi16(static_cast<short>(place));
    const auto* lanes = reinterpret_cast<const __m128i*>(at);
    const __m128i above = _mm_packs_epi16(_mm_cmpgt_epi16(_mm_load_si128(lanes), p),
                                          _mm_cmpgt_epi16(_mm_load_si128(lanes + 1), p));
    const auto mask = static_cast<unsigned>(_mm_movemask_epi8(above));
    return static_cast<unsigned>(std::countr_zero(mask | 0x10000u)) - 1;
#else
    unsigned s = 0;
    while (s < 15 && at[s + 1] <= place) ++s;
    return s;
#endif
  }
};

/// The shares that are between two others, of each symbol: those of a mix of both.
CLERS_ALWAYS_INLINE Starts mean_of(const Starts& a, const Starts& b) {
  Starts mean;
#if CLERS_SSE2
  for (int i = 0; i < 2; ++i)
    _mm_store_si128(reinterpret_cast<__m128i*>(mean.at) + i,
                    _mm_avg_epu16(_mm_load_si128(reinterpret_cast<const __m128i*>(a.at) + i),
                                  _mm_load_si128(reinterpret_cast<const __m128i*>(b.at) + i)));
#else
  for (unsigned s = 0; s < 16; ++s)
    mean.at[s] = static_cast<std::uint16_t>((a.at[s] + b.at[s] + 1) >> 1);
#endif
  return mean;
}

/// Cumulative shares that move towards what they see: mixing of cumulative distributions, after
/// Giesen, "Mixing discrete probability distributions".
class alignas(64) Distribution {
 public:
  /// The least share of a symbol.
  static constexpr unsigned least = 4;

  /// Begins as these shares, which sum up to `shares`.
  explicit constexpr Distribution(const std::array<std::uint16_t, 16>& share) {
    for (unsigned s = 1; s < 16; ++s)
      start_.at[s] = static_cast<std::uint16_t>(start_.at[s - 1] + share[s - 1]);
  }

  const Starts& starts() const { return start_; }

  /// The symbol was seen: its share grows, the others shrink, less the more were seen.
  CLERS_ALWAYS_INLINE void update(unsigned symbol) {
    const unsigned seen = seen_, rate = rates[seen];
    seen_ = static_cast<std::uint16_t>(seen + (seen < rates.size() - 1));
    const std::uint16_t* target = targets[rate - least_rate][symbol].data();
#if CLERS_SSE2
    auto* lanes = reinterpret_cast<__m128i*>(start_.at);
    const auto* t = reinterpret_cast<const __m128i*>(target);
    const __m128i shift = _mm_cvtsi32_si128(static_cast<int>(rate));
    for (int i = 0; i < 2; ++i) {
      const __m128i c = _mm_load_si128(lanes + i);
      const __m128i step = _mm_sra_epi16(_mm_sub_epi16(_mm_load_si128(t + i), c), shift);
      _mm_store_si128(lanes + i, _mm_add_epi16(c, step));
    }
#else
    for (unsigned s = 0; s < 16; ++s) {
      const int c = start_.at[s];
      start_.at[s] = static_cast<std::uint16_t>(c + ((int(target[s]) - c) >> rate));
    }
#endif
  }

 private:
  static constexpr unsigned least_rate = 3, most_rate = 7;

  /// Which power of two a step is one part of, by what was seen.
  static constexpr auto rates = [] {
    std::array<std::uint8_t, 160> r{};
    for (unsigned n = 0; n < r.size(); ++n)
      r[n] = static_cast<std::uint8_t>(n < 6              ? 3
                                       : n < 18           ? 4
                                       : n < 50           ? 5
                                       : n + 1 < r.size() ? 6
                                                          : 7);
    return r;
  }();

  /// What starts move towards when a symbol is seen. A shift rounds down: those that move up aim
  /// higher by what it loses, so that they get there.
  struct alignas(16) Target : std::array<std::uint16_t, 16> {};
  static constexpr auto targets = [] {
    std::array<std::array<Target, 16>, most_rate - least_rate + 1> all{};
    for (unsigned rate = least_rate; rate <= most_rate; ++rate)
      for (unsigned symbol = 0; symbol < 16; ++symbol)
        for (unsigned s = 0; s < 16; ++s)
          all[rate - least_rate][symbol][s] = static_cast<std::uint16_t>(
              s <= symbol ? s * least : shares - (16 - s) * least + (1u << rate) - 1);
    return all;
  }();

  Starts start_;
  std::uint16_t seen_ = 0;
};

}  // namespace clers::internal

#endif

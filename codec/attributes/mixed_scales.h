// How large residuals will be: logarithms of scales by linear regression, learned online.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_SCALES_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_SCALES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/attributes/fixed_point.h"
#include "codec/entropy/mixer.h"

namespace clers::internal::mixed {

/// Logarithms, in 1/256 octaves, that are known beforehand.
template <unsigned n>
struct Features {
  static constexpr int most = 2560;

  void set(unsigned i, int f) { at[i] = static_cast<std::int16_t>(std::clamp(f, -most, most)); }
  /// 2^40 / (1 + their power), in their units, about: what steps are normalised by.
  std::int64_t inverse_power() const {
    std::uint64_t power = 1 << 16;
    for (const std::int16_t f : at) power += static_cast<std::uint64_t>(std::int64_t(f) * f);
    return static_cast<std::int64_t>(fixed::inverse(40, power));
  }

  alignas(16) std::array<std::int16_t, n> at = {};
};

/// How often rates were used, and what they are: .02 + .5 / (1 + .05 t) in units of 2^-16.
class Rate {
 public:
  std::int64_t next() {
    const std::uint32_t rate = 1311 + 655360 / (20 + seen_);
    seen_ += seen_ < 100000;
    return rate;
  }

 private:
  std::uint32_t seen_ = 0;
};

/// By how much a residual of size 2^(size/256) exceeds its scale, relative to it: -1 .. 2, in
/// 1/256.
inline std::int64_t excess(int size, int scale) {
  const int d = std::clamp(size - scale, -2048, 512);
  return std::min<std::int64_t>(static_cast<std::int64_t>(fixed::exp2(d) >> 8) - 256, 512);
}

/// One scale.
template <unsigned n>
class Regression {
 public:
  int predict(const Features<n>& f) const { return mixer::dot(f.at.data(), w_.data(), n) >> 12; }
  void learn(const Features<n>& f, std::int64_t inverse_power, std::int64_t rate,
             std::int64_t excess) {
    const std::int64_t step = (rate * excess * inverse_power) >> 25;
    mixer::train(f.at.data(), w_.data(), n,
                 static_cast<std::int16_t>(std::clamp<std::int64_t>(step, -32767, 32767)));
  }

 private:
  alignas(16) std::array<std::int32_t, n> w_ = {};
};

}  // namespace clers::internal::mixed

#endif

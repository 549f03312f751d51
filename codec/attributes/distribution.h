// The distribution of what a prediction misses by, in units of its scale: a sum of two logistic
// ones, the second with long tails. As tables, made by integer arithmetic alone when first used.
#ifndef CLERS_CODEC_ATTRIBUTES_DISTRIBUTION_H
#define CLERS_CODEC_ATTRIBUTES_DISTRIBUTION_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace clers::internal {

/// Density .85 f(1.9 z) 1.9 + .15 f(.7 z) .7, where f is the logistic density. z is in 1/128.
class Distribution {
 public:
  static constexpr int unit = 128;        ///< of z
  static constexpr int most = 24 * unit;  ///< z is clamped to this
  static constexpr int max_logit = 2815;  ///< as in entropy/logistic.h

  /// The tables, made once.
  static const Distribution& tables();

  /// The logit, in 1/256, of: at least z.
  int at_least(int z) const {
    return std::clamp((survival(z) - survival(-z)) >> 4, -max_logit, max_logit);
  }
  /// The logit of: at least z, given at least `from`, from <= z.
  int further(int from, int z) const {
    const unsigned r = static_cast<unsigned>(survival(from) - survival(z));
    if (r < fine) return odds_[r];
    return odds_[std::min(fine + ((r - fine + 16) >> 5), odds_size - 1)];
  }
  /// ln of the density at z, in 1/256, plus any constant.
  int log_density(int z) const {
    return density_[static_cast<std::size_t>(std::min(z < 0 ? -z : z, most))];
  }

 private:
  Distribution();
  /// ln of the probability of: at least z, in 1/4096.
  int survival(int z) const {
    return survival_[static_cast<std::size_t>(std::clamp(z, -most, most) + most)];
  }

  static constexpr unsigned fine = 2048, odds_size = fine + 1536;
  std::array<std::int32_t, 2 * most + 1> survival_;
  std::array<std::int16_t, most + 1> density_;
  /// -ln(e^r - 1) in 1/256: r in 1/4096 below `fine`, then in 1/128.
  std::array<std::int16_t, odds_size> odds_;
};

}  // namespace clers::internal

#endif

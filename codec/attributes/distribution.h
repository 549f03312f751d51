// The distribution of what a prediction misses by, in units of its scale: a sum of two logistic
// ones, the second with long tails. As tables, made by integer arithmetic alone when first used.
#ifndef CLERS_CODEC_ATTRIBUTES_DISTRIBUTION_H
#define CLERS_CODEC_ATTRIBUTES_DISTRIBUTION_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace clers::internal {

/// Density .85 f(1.9 z) 1.9 + .15 f(.7 z) .7, where f is the logistic density. z is in 1/128,
/// within -most .. most.
class MissDistribution {
 public:
  static constexpr int unit = 128;  ///< of z
  static constexpr int most = 24 * unit;
  static constexpr int max_logit = 2815;  ///< as in entropy/logistic.h

  /// The tables, made once.
  static const MissDistribution& tables();

  /// ln of the probability of at least z, in 1/4096.
  int survival(int z) const { return survival_[static_cast<std::size_t>(z + most)]; }
  /// The logit, in 1/256, of a probability e^-r, r >= 0 in 1/4096: with r = survival(from) -
  /// survival(to), that of at least `to` given at least `from`.
  int odds(int r) const {
    const unsigned i = static_cast<unsigned>(r);
    return odds_[i < fine ? i : std::min(fine + ((i - fine + 16) >> 5), odds_size - 1)];
  }
  /// ln of the density at z, in 1/256, plus any constant.
  int log_density(int z) const { return density_[static_cast<std::size_t>(z < 0 ? -z : z)]; }

 private:
  MissDistribution();
  static constexpr unsigned fine = 2048, odds_size = fine + 1536;
  std::array<std::int32_t, 2 * most + 1> survival_;
  std::array<std::int16_t, most + 1> density_;
  /// -ln(e^r - 1) in 1/256: r in 1/4096 below `fine`, then in 1/128.
  std::array<std::int16_t, odds_size> odds_;
};

}  // namespace clers::internal

#endif

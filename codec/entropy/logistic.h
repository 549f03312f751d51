// Logits in integers: stretch(p) = ln(p / (1-p)) and squash, its inverse, for the mixing of
// probabilities.
#ifndef CLERS_CODEC_ENTROPY_LOGISTIC_H
#define CLERS_CODEC_ENTROPY_LOGISTIC_H

#include <algorithm>
#include <array>
#include <cstdint>

namespace clers::internal {

/// Logits are in units of 1/256 and at most this: e^(2815/256) is 59600.
inline constexpr int max_logit = 2815;

/// Tables, made by integer arithmetic alone.
class Logistic {
 public:
  constexpr Logistic();

  /// Probability in 1/65536, 1 .. 65535, of a logit, which may be out of range.
  constexpr int squash(int logit) const {
    return squash_[static_cast<std::size_t>(std::clamp(logit, -max_logit, max_logit) + max_logit)];
  }
  /// Logit of a probability in units of 2^-22, below 2^22.
  constexpr int stretch(std::uint32_t p) const { return stretch_[p >> 10]; }

 private:
  std::array<std::uint16_t, 2 * max_logit + 1> squash_ = {};
  std::array<std::int16_t, 4096> stretch_ = {};
};

extern const Logistic logistic;

}  // namespace clers::internal

#endif

// The tables, made at compile time from integers alone.
#include "codec/entropy/logistic.h"

namespace clers::internal {

constexpr Logistic::Logistic() {
  // e^(-d/256) in units of 2^-32, by repeated multiplication.
  constexpr std::uint64_t one = std::uint64_t(1) << 32, factor = 4278222805u;  // e^(-1/256)
  std::uint64_t power = one;
  for (int d = 0; d <= max_logit; ++d) {
    const std::uint64_t sum = one + power;
    const std::uint32_t p = static_cast<std::uint32_t>(((one << 16) + sum / 2) / sum);
    squash_[static_cast<std::size_t>(max_logit + d)] = static_cast<std::uint16_t>(p);
    squash_[static_cast<std::size_t>(max_logit - d)] = static_cast<std::uint16_t>(65536 - p);
    power = (power * factor + one / 2) >> 32;
  }
  // The first logit whose probability is not below the middle of a cell, and its mirror image.
  int logit = -max_logit;
  for (std::uint32_t i = 0; i < 2048; ++i) {
    while (std::uint32_t(squash(logit)) << 6 < (2 * i + 1) << 10 >> 1) ++logit;
    stretch_[i] = static_cast<std::int16_t>(logit);
    stretch_[4095 - i] = static_cast<std::int16_t>(-logit);
  }
}

constinit const Logistic logistic;

}  // namespace clers::internal

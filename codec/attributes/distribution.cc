#include "codec/attributes/distribution.h"

#include <bit>

#include "codec/attributes/fixed_point.h"

namespace clers::internal {
namespace {

using fixed::multiply_high;

/// Numbers below 1 are in units of 2^-64 here.
constexpr std::uint64_t almost_one = ~std::uint64_t(0);

/// ln(p), p > 0, in units of 2^-20.
std::int64_t log_of(std::uint64_t p) {
  const int shift = std::countl_zero(p);
  std::uint64_t mantissa = p << shift;  // in [1/2, 1)
  std::int64_t log2 = -shift - 1;       // of p / (2 mantissa)
  for (int bit = 0; bit < 24; ++bit) {
    // With m in [1, 2) in units of 2^-63: the next bit of log2(m) says whether m^2 is at least 2.
    mantissa = multiply_high(mantissa, mantissa);
    const bool above = mantissa >> 63 != 0;
    if (!above) mantissa <<= 1;
    log2 = 2 * log2 + above;
  }
  constexpr std::int64_t ln2 = 744261118;  // in units of 2^-30
  return (log2 * (ln2 >> 4) + (std::int64_t(1) << 29)) >> 30;
}

/// a / (1 + a).
std::uint64_t share(std::uint64_t a) {
  const std::uint64_t inverse = (std::uint64_t(1) << 63) / ((std::uint64_t(1) << 31) + (a >> 33));
  return inverse >> 32 != 0 ? a : multiply_high(a, inverse << 32);
}

std::int16_t rounded(std::int64_t log, int most) {
  return static_cast<std::int16_t>(std::clamp<std::int64_t>((log + (1 << 11)) >> 12, -most, most));
}

}  // namespace

const MissDistribution& MissDistribution::tables() {
  static const MissDistribution made;
  return made;
}

MissDistribution::MissDistribution() {
  constexpr std::uint64_t narrow_step = 18174947447501393395u, wide_step = 18346138785377041030u;
  constexpr std::uint64_t narrow_part = 15679732462653118874u;  // .85
  constexpr std::uint64_t wide_part = 2767011611056432742u;     // .15
  // 1.9 * .85 and .7 * .15 over 2
  constexpr std::uint64_t narrow_density = 14895745839520462930u,
                          wide_density = 968454063869751460u;
  std::uint64_t narrow = almost_one, wide = almost_one;  // e^-1.9z and e^-.7z
  for (int z = 0; z <= most; ++z) {
    const std::uint64_t a = share(narrow), b = share(wide);
    const std::uint64_t above = multiply_high(narrow_part, a) + multiply_high(wide_part, b);
    const std::size_t at = static_cast<std::size_t>(z), middle = static_cast<std::size_t>(most);
    survival_[middle + at] = static_cast<std::int32_t>((log_of(above) + (1 << 7)) >> 8);
    survival_[middle - at] = static_cast<std::int32_t>((log_of(~above) + (1 << 7)) >> 8);
    const std::uint64_t density = multiply_high(narrow_density, multiply_high(a, ~a)) +
                                  multiply_high(wide_density, multiply_high(b, ~b));
    density_[at] = rounded(log_of(density), 32767);
    narrow = multiply_high(narrow, narrow_step);
    wide = multiply_high(wide, wide_step);
  }
  constexpr std::uint64_t fine_step = 18442241023793258496u, coarse_step = 18303190372430456780u;
  std::uint64_t power = almost_one;  // e^-r
  for (unsigned i = 0; i < odds_size; ++i) {
    const std::int64_t r = i < fine ? std::int64_t(i) << 8
                                    : (std::int64_t(fine) << 8) + (std::int64_t(i - fine) << 13);
    odds_[i] = i == 0 ? std::int16_t(max_logit) : rounded(-r - log_of(~power), max_logit);
    power = multiply_high(power, i < fine ? fine_step : coarse_step);
  }
}

}  // namespace clers::internal

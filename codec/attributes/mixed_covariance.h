// A residual whose spread is one thing along a normal and another across it, seen along the axes of
// coordinates, one after the other.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_COVARIANCE_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_COVARIANCE_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/attributes/fixed_point.h"
#include "codec/attributes/vector.h"

namespace clers::internal::mixed {

/// Axes in the order of coding: that nearest the normal last.
using AxisOrder = std::array<std::size_t, 3>;

inline AxisOrder axis_order(const Vector& n) {
  if (size_of(n[0]) > size_of(n[1]) && size_of(n[0]) > size_of(n[2])) return {1, 2, 0};
  if (size_of(n[1]) > size_of(n[2])) return {0, 2, 1};
  return {0, 1, 2};
}

/// With variances n2 along the normal (x, y, z) and t2 across it, p = n2/t2 - 1, q = t2/n2 - 1, and
/// residuals rx, ry known:
///
///   first:   variance t2 (1 + p x^2)
///   second:  mean p x y rx / (1 + p x^2), variance t2 (1 + p y^2 / (1 + p x^2))
///   third:   mean -q z (x rx + y ry) / (1 + q z^2), variance t2 / (1 + q z^2)
class Covariance {
 public:
  /// The normal in units of 2^-14 or zero; logarithms of n2/t2 in 1/128 octaves.
  void set(const Vector& normal, const AxisOrder& order, int along, int across) {
    x_ = normal[order[0]], y_ = normal[order[1]];
    const std::int64_t z = normal[order[2]];
    const int ratio = std::clamp(2 * (along - across), -2048, 2048);
    const std::int64_t p = static_cast<std::int64_t>(fixed::exp2(ratio)) - one;
    const std::int64_t q = static_cast<std::int64_t>(fixed::exp2(-ratio)) - one;
    const std::int64_t first = std::max(one + (p * (x_ * x_ >> 12) >> 16), least);
    const std::int64_t mixed = p * (x_ * y_ >> 12) >> 16;
    second_ = mixed * one / first;
    const std::int64_t second =
        std::max(one + (p * (y_ * y_ >> 12) >> 16) - (mixed * second_ >> 16), least);
    const std::int64_t third = std::max(one + (q * (z * z >> 12) >> 16), least);
    third_ = (q * z >> 14) * one / third;
    for (std::size_t i = 0; i < 3; ++i)
      whole[i] = half_log(std::max(one + (p * (normal[i] * normal[i] >> 12) >> 16), least));
    scale[0] = half_log(first);
    scale[1] = half_log(second);
    scale[2] = -half_log(third);
  }

  /// What the second component is moved by, if the first one's residual was rx; clamped.
  std::int64_t second(std::int64_t rx) const { return second_ * rx >> 16; }
  std::int64_t third(std::int64_t rx, std::int64_t ry) const {
    return -(third_ * ((x_ * rx + y_ * ry) >> 14) >> 16);
  }

  /// log2 of each component's scale over that across, in 1/256: in the order of coding, given those
  /// before; and of each axis, given nothing.
  std::array<int, 3> scale, whole;

 private:
  static constexpr std::int64_t one = 1 << 16, least = 1 << 6;
  static int half_log(std::int64_t v) {
    return (fixed::log2(static_cast<std::uint64_t>(v)) - 16 * fixed::octave) / 2;
  }

  std::int64_t x_ = 0, y_ = 0, second_ = 0, third_ = 0;
};

}  // namespace clers::internal::mixed

#endif

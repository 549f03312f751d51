// Directions as two integers: points of a grid on an octahedron, unfolded into a square (Meyer et
// al., On floating-point normal vectors, 2010).
//
//      +-----+-----+        The upper half, z >= 0, is the diamond in the middle; the triangles of the
//      |   / | \   |        lower one are folded out around it. Points of the grid have
//      | /   |z  \ |        |x| + |y| + |z| = S, and the square 2 S + 1 of them along a side. A
//      +-----+-----+ x      point below on x = 0 or y = 0 is at two places of the square's border,
//      | \   |   / |        and has the one with the greater integers.
//      |   \ | /   |
//      +-----+-----+        With b bits S = 2^(b - 1) - 1: the codes of Draco.
#ifndef CLERS_CODEC_NUMBERS_OCTAHEDRAL_H
#define CLERS_CODEC_NUMBERS_OCTAHEDRAL_H

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "codec/base/direction.h"

namespace clers::internal {

/// A point of the grid: the sum of its magnitudes is the S of that grid.
struct OctahedralPoint {
  std::array<std::int32_t, 3> at = {};

  std::int32_t operator[](std::size_t i) const { return at[i]; }
  std::int32_t& operator[](std::size_t i) { return at[i]; }
  friend bool operator==(const OctahedralPoint&, const OctahedralPoint&) = default;
};

/// Its bits are so few that sums of squares are doubles, exactly, and that points are still apart
/// once they are rounded to floats.
class OctahedralGrid {
 public:
  /// Precondition: min_direction_bits <= bits <= max_direction_bits (precision.h).
  explicit OctahedralGrid(unsigned bits) : s_((std::int32_t(1) << (bits - 1)) - 1) {}

  std::int32_t size() const { return s_; }  ///< S
  /// Both integers are in 0 .. top().
  std::uint64_t top() const { return 2 * static_cast<std::uint64_t>(s_); }

  /// The point at a place of the square, of which each coordinate is in -S .. S.
  OctahedralPoint fold(std::int32_t x, std::int32_t y) const {
    const std::int32_t z = s_ - std::abs(x) - std::abs(y);
    if (z >= 0) return {{x, y, z}};
    const std::int32_t dx = s_ - std::abs(y), dy = s_ - std::abs(x);
    return {{x < 0 ? -dx : dx, y < 0 ? -dy : dy, z}};
  }
  /// Undoes fold: the place of a point.
  std::array<std::int32_t, 2> unfold(const OctahedralPoint& p) const {
    if (p[2] >= 0) return {p[0], p[1]};
    const std::int32_t x = s_ - std::abs(p[1]), y = s_ - std::abs(p[0]);
    return {p[0] < 0 ? -x : x, p[1] < 0 ? -y : y};
  }
  /// The point of two integers, and back.
  OctahedralPoint point(std::int64_t u, std::int64_t v) const {
    return fold(static_cast<std::int32_t>(u) - s_, static_cast<std::int32_t>(v) - s_);
  }
  std::array<std::int32_t, 2> integers(const OctahedralPoint& p) const {
    const auto [x, y] = unfold(p);
    return {x + s_, y + s_};
  }

  /// A vector scaled to the octahedron: the sum of its magnitudes is S. Precondition: that sum is a
  /// normal number, far from the largest.
  Vector3 project(const Vector3& v) const {
    const double scale = s_ / (std::fabs(v[0]) + std::fabs(v[1]) + std::fabs(v[2]));
    return {v[0] * scale, v[1] * scale, v[2] * scale};
  }

  /// The point with the least angle to a vector that project() gave, of those around it: the first
  /// of several that are as near, up to rounding, from the lesser magnitudes of x and y. Without a
  /// branch, which would go either way.
  OctahedralPoint nearest(const Vector3& on) const {
    const double x = std::fabs(on[0]), y = std::fabs(on[1]), z = std::fabs(on[2]);
    const auto i = static_cast<std::int32_t>(x), j = static_cast<std::int32_t>(y);
    // The square of the cosine, but for a factor: as an integer it is ordered as the number is,
    // and its last two bits say which point it is of.
    std::int64_t best = 0;
    for (std::int32_t k = 0; k < 4; ++k) {
      const OctahedralPoint p = {{i + k / 2, j + k % 2, s_ - i - j - k / 2 - k % 2}};
      const double along = x * p[0] + y * p[1] + z * p[2];
      const auto bits = std::bit_cast<std::int64_t>(along * along / square_of(p));
      best = std::max(best, p[2] < 0 ? 0 : (bits & ~std::int64_t(3)) | (3 - k));
    }
    const std::int32_t k = 3 - static_cast<std::int32_t>(best & 3);
    const OctahedralPoint p = {{i + k / 2, j + k % 2, s_ - i - j - k / 2 - k % 2}};
    const auto with_sign = [](std::int32_t n, double like) {
      const std::int32_t sign = -static_cast<std::int32_t>(like < 0);
      return (n ^ sign) - sign;
    };
    return {{with_sign(p[0], on[0]), with_sign(p[1], on[1]), with_sign(p[2], on[2])}};
  }

  /// The unit vector of a point: two rounded operations a component.
  static Vector3 direction(const OctahedralPoint& p) {
    const double l = std::sqrt(square_of(p));
    return {p[0] / l, p[1] / l, p[2] / l};
  }

 private:
  static double square_of(const OctahedralPoint& p) {
    const double x = p[0], y = p[1], z = p[2];
    return x * x + y * y + z * z;
  }

  std::int32_t s_;
};

}  // namespace clers::internal

#endif

// Angles, the same on every machine: by single operations on doubles, which are rounded correctly
// (DoublePrecision, portable.h), where the C library's functions are as good as it likes.
#ifndef CLERS_CODEC_BASE_DIRECTION_H
#define CLERS_CODEC_BASE_DIRECTION_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "codec/scalar.h"

namespace clers::internal {

/// A vector in space.
using Vector3 = std::array<double, 3>;

inline double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The angle, 0 .. pi, from the x axis to (x, y). Preconditions: finite, y >= 0, not both 0;
/// neither is so small or large that products or quotients leave the normal numbers.
///
/// Of the smaller over the larger, t in 0 .. 1, it takes away c = k / 8, the nearest of nine: the
/// tangent of the rest is r = (t - c) / (1 + t c), at most 1/16, so that six terms of Gregory's
/// series leave less than 2^-55.
inline double angle_of(double x, double y) {
  constexpr std::array<double, 9> arctangent_of_eighths = {0,
                                                           0x1.fd5ba9aac2f6ep-4,
                                                           0x1.f5b75f92c80ddp-3,
                                                           0x1.6f61941e4def1p-2,
                                                           0x1.dac670561bb4fp-2,
                                                           0x1.1e00babdefeb4p-1,
                                                           0x1.4978fa3269ee1p-1,
                                                           0x1.700a7c5784634p-1,
                                                           0x1.921fb54442d18p-1};
  constexpr double half_turn = 0x1.921fb54442d18p+1;
  const double beside = std::fabs(x);
  const bool steep = y > beside;
  const double t = std::min(beside, y) / std::max(beside, y);
  const auto k = static_cast<std::size_t>(t * 8 + 0.5);
  const double c = static_cast<double>(k) / 8;
  const double r = (t - c) / (1 + t * c), s = r * r;
  double sum = 1. / 13;
  for (const double odd : {11., 9., 7., 5., 3.}) sum = 1 / odd - s * sum;
  const double angle = arctangent_of_eighths[k] + (r - r * (s * sum));
  // Without branches, which would go either way.
  constexpr std::array<double, 2> from_quarter = {0, half_turn / 2}, from_half = {0, half_turn},
                                  sign = {1, -1};
  const double upward = from_quarter[steep] + sign[steep] * angle;
  return from_half[x < 0] + sign[x < 0] * upward;
}

/// The vector with its largest component made 1 .. 2 by a power of two; false if it has no
/// direction: it is zero or not finite.
inline bool to_unit_range(Vector3& v) {
  double most = 0;
  for (const double x : v) {
    if (!(std::fabs(x) <= std::numeric_limits<double>::max())) return false;
    if (std::fabs(x) > most) most = std::fabs(x);
  }
  if (most == 0) return false;
  const int e = std::ilogb(most);
  for (double& x : v) {
    x = std::scalbn(x, -e);
    if (std::fabs(x) < 0x1p-200) x = 0;  // so that no square is too small for a normal number
  }
  return true;
}

/// The angle between two vectors in degrees, 0 .. 180. Of vectors that have no direction it is 0 if
/// they are equal, or both have a NaN; else infinite.
inline double degrees_between(Vector3 a, Vector3 b) {
  constexpr double degrees = 0x1.ca5dc1a63c1f8p+5;  // 180 / pi
  if (a == b) return 0;
  const bool first = to_unit_range(a), second = to_unit_range(b);
  if (first && second) {
    const Vector3 normal = cross(a, b);
    const double along = dot(a, b), across = std::sqrt(dot(normal, normal));
    return across == 0 && along > 0 ? 0 : angle_of(along, across) * degrees;
  }
  const auto has_nan = [](const Vector3& v) {
    return std::isnan(v[0]) || std::isnan(v[1]) || std::isnan(v[2]);
  };
  if (!first && !second && has_nan(a) && has_nan(b)) return 0;
  return std::numeric_limits<double>::infinity();
}

/// A value of three packed numbers as a vector.
inline Vector3 vector_at(Scalar scalar, const std::byte* value) {
  Vector3 v;
  with_type(scalar, [&](auto type) {
    decltype(type) x[3];
    std::memcpy(x, value, sizeof x);
    for (std::size_t c = 0; c < 3; ++c) v[c] = static_cast<double>(x[c]);
  });
  return v;
}

/// The angle between two values of three numbers, in degrees: the one meaning of it for who states
/// an error, and for who looks whether it is true. 0 if they have the same bits, else more.
inline double angle_between(Scalar scalar, const std::byte* a, const std::byte* b) {
  if (std::memcmp(a, b, 3 * size_of(scalar)) == 0) return 0;
  return std::max(degrees_between(vector_at(scalar, a), vector_at(scalar, b)), 0x1p-50);
}

/// Stores a vector of floats as a value.
inline void put_vector(Scalar scalar, const Vector3& v, std::byte* value) {
  const auto put = [&](auto type) {
    using T = decltype(type);
    for (std::size_t c = 0; c < 3; ++c) {
      const T x = static_cast<T>(v[c]);
      std::memcpy(value + c * sizeof(T), &x, sizeof(T));
    }
  };
  scalar == Scalar::float32 ? put(float{}) : put(double{});
}

}  // namespace clers::internal

#endif

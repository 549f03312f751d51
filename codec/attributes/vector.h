// Vectors of three integers.
#ifndef CLERS_CODEC_ATTRIBUTES_VECTOR_H
#define CLERS_CODEC_ATTRIBUTES_VECTOR_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace clers::internal {

struct Vector {
  std::array<std::int64_t, 3> at = {};

  std::int64_t operator[](std::size_t i) const { return at[i]; }
  std::int64_t& operator[](std::size_t i) { return at[i]; }
  friend Vector operator+(const Vector& a, const Vector& b) {
    return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
  }
  friend Vector operator-(const Vector& a, const Vector& b) {
    return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
  }
  friend Vector operator*(const Vector& a, std::int64_t k) {
    return {{a[0] * k, a[1] * k, a[2] * k}};
  }
  /// Rounded down.
  friend Vector operator>>(const Vector& a, int n) { return {{a[0] >> n, a[1] >> n, a[2] >> n}}; }
  Vector& operator+=(const Vector& b) { return *this = *this + b; }
};

inline std::int64_t dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}
inline std::int64_t size_of(std::int64_t k) {
  return k < 0 ? -k : k;
}
inline std::int64_t largest(const Vector& a) {
  return std::max({size_of(a[0]), size_of(a[1]), size_of(a[2])});
}
inline Vector clamp(const Vector& a, std::int64_t most) {
  return {{std::clamp(a[0], -most, most), std::clamp(a[1], -most, most),
           std::clamp(a[2], -most, most)}};
}
/// Times 2^n, rounded down.
inline Vector shifted(const Vector& a, int n) {
  return n >= 0 ? a * (std::int64_t(1) << n) : a >> -n;
}
inline std::int64_t shifted(std::int64_t k, int n) {
  return n >= 0 ? k * (std::int64_t(1) << n) : k >> -n;
}

}  // namespace clers::internal

#endif

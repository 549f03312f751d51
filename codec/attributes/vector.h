// Vectors of three integers.
#ifndef CLERS_CODEC_ATTRIBUTES_VECTOR_H
#define CLERS_CODEC_ATTRIBUTES_VECTOR_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace clers::internal {

struct Vector {
  std::int64_t x = 0, y = 0, z = 0;

  std::int64_t operator[](unsigned i) const { return i == 0 ? x : i == 1 ? y : z; }
  std::int64_t& operator[](unsigned i) { return i == 0 ? x : i == 1 ? y : z; }
  friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator*(Vector a, std::int64_t k) { return {a.x * k, a.y * k, a.z * k}; }
  /// Rounded down.
  friend Vector operator>>(Vector a, int n) { return {a.x >> n, a.y >> n, a.z >> n}; }
  Vector& operator+=(Vector b) { return *this = *this + b; }
};

inline std::int64_t dot(Vector a, Vector b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline std::int64_t largest(Vector a) {
  const auto size = [](std::int64_t k) { return k < 0 ? -k : k; };
  return std::max({size(a.x), size(a.y), size(a.z)});
}
inline Vector clamp(Vector a, std::int64_t most) {
  return {std::clamp(a.x, -most, most), std::clamp(a.y, -most, most), std::clamp(a.z, -most, most)};
}

}  // namespace clers::internal

#endif

// Directions of an octahedral grid as Draco's decoder computes them, in floats: what it quantised
// is a point of the grid again, bit for bit.
#ifndef CLERS_CODEC_NUMBERS_FLOAT_DIRECTIONS_H
#define CLERS_CODEC_NUMBERS_FLOAT_DIRECTIONS_H

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <span>

#include "codec/base/direction.h"
#include "codec/base/portable.h"
#include "codec/numbers/octahedral.h"

namespace clers::internal {

class FloatDirections {
 public:
  explicit FloatDirections(unsigned bits) : center_(OctahedralGrid(bits).size()) {}

  /// Each operation is one of floats: of doubles, rounded, which is the same.
  Vector3 direction(const OctahedralPoint& p) const {
    const double scale = rounded(2. / (2. * center_));
    const auto [s, t] = place(p);
    double y = rounded(rounded(s * scale) - 1), z = rounded(rounded(t * scale) - 1);
    const double x = rounded(rounded(1 - std::fabs(y)) - std::fabs(z)), beyond = x < 0 ? -x : 0;
    y = rounded(y + (y < 0 ? beyond : -beyond));
    z = rounded(z + (z < 0 ? beyond : -beyond));
    const double square = rounded(rounded(rounded(x * x) + rounded(y * y)) + rounded(z * z));
    const double d = rounded(1 / rounded(std::sqrt(square)));
    return {rounded(x * d), rounded(y * d), rounded(z * d)};
  }

 private:
  static double rounded(double v) { return double(static_cast<float>(v)); }

  /// Draco unfolds the octahedron along x, not z, and has other places for some points of the
  /// border.
  std::array<std::int32_t, 2> place(const OctahedralPoint& p) const {
    const std::int32_t c = center_, y = std::abs(p[1]), z = std::abs(p[2]);
    if (p[0] >= 0) return canonical(p[1] + c, p[2] + c);
    return canonical(p[1] < 0 ? z : 2 * c - z, p[2] < 0 ? y : 2 * c - y);
  }
  std::array<std::int32_t, 2> canonical(std::int32_t s, std::int32_t t) const {
    const std::int32_t top = 2 * center_;
    if ((s == 0 && t == 0) || (s == 0 && t == top) || (s == top && t == 0)) return {top, top};
    if (s == 0 && t > center_) return {s, top - t};
    if (s == top && t < center_) return {s, top - t};
    if (t == top && s < center_) return {top - s, t};
    if (t == 0 && s > center_) return {top - s, t};
    return {s, t};
  }

  std::int32_t center_;
};

/// The bits of the grid, if all values are such directions. Precondition: three float32 a value.
/// Cost: linear if they are, else mostly a few values.
inline std::optional<unsigned> bits_of_float_directions(std::span<const std::byte> values) {
  const DoublePrecision doubles;
  constexpr unsigned least_bits = 4, most_bits = 16;  // fewer say nothing
  for (unsigned bits = least_bits; bits <= most_bits && !values.empty(); ++bits) {
    const OctahedralGrid grid(bits);
    const FloatDirections floats(bits);
    bool all = true;
    for (std::size_t at = 0; at < values.size() && all; at += 12) {
      const Vector3 v = vector_at(Scalar::float32, values.data() + at);
      const double sum = std::fabs(v[0]) + std::fabs(v[1]) + std::fabs(v[2]);
      if (!(sum > .5 && sum < 2)) return std::nullopt;
      std::array<std::byte, 12> made;
      put_vector(Scalar::float32, floats.direction(grid.nearest(grid.project(v))), made.data());
      all = std::memcmp(made.data(), values.data() + at, made.size()) == 0;
    }
    if (all) return bits;
  }
  return std::nullopt;
}

}  // namespace clers::internal

#endif

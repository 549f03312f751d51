// The shape of a vertex and the triangle it is across from, averaged over earlier ones whose four
// vertices have the same degrees: on a surface of five triangles around a vertex they are wider
// than on one of seven.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_SHAPES_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_SHAPES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/attributes/fixed_point.h"
#include "codec/attributes/vector.h"

namespace clers::internal::mixed {

/// A shape is v less the middle of a and b, in coordinates along a-b, across it in the surface, and
/// along the normal, over the length of a-b.
///
///          v
///         / \         .
///        a---b
///         \ /
///          c
class Shapes {
 public:
  Shapes() : shapes_(keys), of_degree_(degrees) {}
  static constexpr std::uint64_t memory() { return std::uint64_t(keys + degrees) * sizeof(Shape); }

  /// Degrees of v, a, b, c.
  static unsigned key(unsigned v, unsigned a, unsigned b, unsigned c) {
    const auto rank = [](unsigned d) { return std::clamp(d, 3u, 3 + degrees - 1) - 3; };
    return ((rank(v) * degrees + rank(a)) * degrees + rank(b)) * degrees + rank(c);
  }

  /// A side a-b in a frame, the normal (in units of 2^-14, or zero), and the key.
  struct Place {
    Vector middle, edge, across;
    std::int64_t length = 1, inverse = 0;  ///< of the edge; 2^40 over it
    unsigned key = 0;
  };
  static Place place(const Vector& a, const Vector& b, const Vector& normal, unsigned key) {
    const Vector edge = b - a;
    const auto square = static_cast<std::uint64_t>(dot(edge >> 4, edge >> 4));
    const auto length = static_cast<std::int64_t>(fixed::exp2(fixed::log2(square) / 2) >> 12);
    return {(a + b) >> 1, edge, cross(normal, edge) >> 14, length, (std::int64_t(1) << 40) / length,
            key};
  }

  /// Where v is by the average shape: that of all with v's degree, if none had all four.
  Vector predict(const Place& at, const Vector& normal) const {
    const Shape& s = shapes_[at.key].seen ? shapes_[at.key] : of_degree_[degree(at.key)];
    return at.middle + (at.edge * s.x >> 14) + (at.across * s.y >> 14) +
           (normal * (s.z * at.length >> 14) >> 14);
  }
  void learn(const Place& at, const Vector& v, const Vector& normal) {
    const Vector d = v - at.middle;
    // d.e over the length: in the direction of e. Then over the length again, in units of 2^-14.
    const auto along = [&](const Vector& e) { return ((dot(d, e) >> 20) * at.inverse) >> 20; };
    const auto part = [&](std::int64_t x) {
      return static_cast<std::int32_t>(
          std::clamp(x, -most * at.length, most * at.length) * at.inverse >> 26);
    };
    const std::array<std::int32_t, 3> found = {part(along(at.edge)), part(along(at.across)),
                                               part(dot(d, normal) >> 14)};
    Shape& s = shapes_[at.key];
    Shape& of_degree = of_degree_[degree(at.key)];
    if (s.seen == 0 && of_degree.seen != 0) {
      s = of_degree;
      s.seen = 1;
    }
    average(s, found);
    average(of_degree, found);
  }

 private:
  struct Shape {
    std::int32_t x = 0, y = 0, z = 0;  ///< in units of 2^-14
    std::int32_t seen = 0;
  };
  static constexpr unsigned degrees = 8;  ///< 3 or less, .., 10 or more
  static constexpr unsigned keys = degrees * degrees * degrees * degrees;
  static constexpr std::int32_t most_seen = 64;
  static constexpr std::int64_t most = 8;  ///< lengths

  static unsigned degree(unsigned key) { return key / (degrees * degrees * degrees); }
  static void average(Shape& s, const std::array<std::int32_t, 3>& found) {
    s.seen = std::min(s.seen + 1, most_seen);
    const int share = 65536 / s.seen;
    const auto toward = [&](std::int32_t& mean, std::int32_t x) {
      mean += static_cast<std::int32_t>(std::int64_t(x - mean) * share >> 16);
    };
    toward(s.x, found[0]);
    toward(s.y, found[1]);
    toward(s.z, found[2]);
  }

  std::vector<Shape> shapes_, of_degree_;
};

}  // namespace clers::internal::mixed

#endif

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
  Shapes() : shapes_(std::size_t(degrees) * degrees * degrees * degrees) {}
  static constexpr std::uint64_t memory() {
    return std::uint64_t(degrees) * degrees * degrees * degrees * sizeof(Shape);
  }

  /// Degrees of v, a, b, c.
  static unsigned key(unsigned v, unsigned a, unsigned b, unsigned c) {
    const auto rank = [](unsigned d) { return std::clamp(d, 3u, 3 + degrees - 1) - 3; };
    return ((rank(v) * degrees + rank(a)) * degrees + rank(b)) * degrees + rank(c);
  }

  /// A side a-b in a frame, the normal (in units of 2^-14, or zero), and the key.
  struct Place {
    Vector middle, edge, across;
    std::int64_t length = 1;
    unsigned key = 0;
  };
  static Place place(Vector a, Vector b, Vector normal, unsigned key) {
    const Vector edge = b - a;
    const std::uint64_t square = static_cast<std::uint64_t>(dot(edge >> 4, edge >> 4));
    return {(a + b) >> 1, edge, cross(normal, edge) >> 14,
            std::max<std::int64_t>(
                static_cast<std::int64_t>(fixed::exp2(fixed::log2(square) / 2) >> 12), 1),
            key};
  }

  bool knows(const Place& at) const { return shapes_[at.key].seen >= 2; }
  /// Where v is by the average shape.
  Vector predict(const Place& at, Vector normal) const {
    const Shape& s = shapes_[at.key];
    return at.middle + (at.edge * s.x >> 14) + (at.across * s.y >> 14) +
           (normal * (s.z * at.length >> 14) >> 14);
  }
  void learn(const Place& at, Vector v, Vector normal) {
    Shape& s = shapes_[at.key];
    const Vector d = v - at.middle;
    const std::int64_t n = s.seen < most_seen ? ++s.seen : most_seen;
    // Along the sides, lengths over at.length.
    const std::int64_t square = std::max<std::int64_t>(at.length * at.length >> 14, 1);
    const auto toward = [&](std::int32_t& mean, std::int64_t x) {
      mean += static_cast<std::int32_t>((std::clamp(x, -most, most) - mean) / n);
    };
    toward(s.x, dot(d, at.edge) / square);
    toward(s.y, dot(d, at.across) / square);
    toward(s.z, dot(d, normal) / at.length);
  }

 private:
  struct Shape {
    std::int32_t x = 0, y = 0, z = 0;  ///< in units of 2^-14
    std::int32_t seen = 0;
  };
  static constexpr unsigned degrees = 8;  ///< 3 or less, .., 10 or more
  static constexpr std::int32_t most_seen = 128;
  static constexpr std::int64_t most = 1 << 17;

  std::vector<Shape> shapes_;
};

}  // namespace clers::internal::mixed

#endif

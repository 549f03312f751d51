// Triangles laid flat: where a vertex is beside a side of its triangle, in space, and so where it
// is in a chart. Integers only; knows no surface and no coder.
//
//          v
//         / \        In space v is s along the side from a to b, in lengths of the side, and t
//        /   \       away from it; o, across the side, is s' along it and t' away. Laid flat:
//       a-----b
//        \   /             v = a + s (b - a) - (t / t') (o - a - s' (b - a))
//         \ /                = a + q (b - a) - r (o - a)     r = t / t', q = s + r s'
//          o
//
// That is the affine map from the plane of the triangle a b o to its chart, at v: it holds where a
// chart stretches the surface, as long as both triangles are stretched alike.
#ifndef CLERS_CODEC_ATTRIBUTES_UNFOLDING_H
#define CLERS_CODEC_ATTRIBUTES_UNFOLDING_H

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "codec/attributes/places.h"
#include "codec/base/portable.h"

namespace clers::internal {

/// The square root, rounded down. Precondition: 0 <= n <= 2^52.
CLERS_ALWAYS_INLINE std::int64_t square_root(std::int64_t n) {
  // n is a double, and so are the square roots of r^2 - 1 for all r: none is rounded up to r.
  return static_cast<std::int64_t>(std::sqrt(static_cast<double>(n)));
}

/// An edge, or a cross product of two: below 2^44 each.
struct Arrow {
  std::int64_t x, y, z;
};
CLERS_ALWAYS_INLINE Arrow arrow(const GridPlace& from, const GridPlace& to) {
  return {std::int64_t(to[0]) - from[0], std::int64_t(to[1]) - from[1],
          std::int64_t(to[2]) - from[2]};
}
CLERS_ALWAYS_INLINE std::int64_t dot(const Arrow& a, const Arrow& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The square of the length of a cross product is `square` 4^shift, about.
struct CrossSquare {
  std::int64_t square;  ///< at most 3 * 2^24
  int shift;

  CLERS_ALWAYS_INLINE CrossSquare(const Arrow& a, const Arrow& b) {
    const std::int64_t x = a.y * b.z - a.z * b.y, y = a.z * b.x - a.x * b.z,
                       z = a.x * b.y - a.y * b.x;
    const auto bits = [](std::int64_t k) { return static_cast<std::uint64_t>(k ^ (k >> 63)); };
    shift = std::max(static_cast<int>(std::bit_width(bits(x) | bits(y) | bits(z))) - 12, 0);
    const std::int64_t i = x >> shift, j = y >> shift, k = z >> shift;
    square = i * i + j * j + k * k;
  }
};

/// Weights of b - a and of o - a, in 1/2^16.
struct Unfolded {
  std::int64_t q, r;
};
inline constexpr int unfolded_bits = 16;

/// False where a triangle has no area, or the map takes v too far: nothing is in `to` then.
/// Otherwise both are below 2^25.
CLERS_ALWAYS_INLINE bool unfold(const GridPlace& a, const GridPlace& b, const GridPlace& o,
                                const GridPlace& v, Unfolded& to) {
  const Arrow e = arrow(a, b), toward_o = arrow(a, o), toward_v = arrow(a, v);
  const CrossSquare of_v(e, toward_v), of_o(e, toward_o);
  const int shift = of_v.shift - of_o.shift;
  if (of_o.square == 0 || shift > 8) return false;
  // t / t' = sqrt(t^2 t'^2) / t'^2, which is at most 2^8 2^16 2^8
  const std::int64_t root = square_root(of_v.square * of_o.square);
  const std::int64_t ratio = (root << unfolded_bits) / of_o.square;
  to.r = shift >= 0 ? ratio << shift : ratio >> std::min(-shift, 63);
  // So that products with r fit.
  std::int64_t length = dot(e, e);
  const int down =
      std::max(static_cast<int>(std::bit_width(static_cast<std::uint64_t>(length))) - 32, 0);
  const std::int64_t along_v = dot(e, toward_v) >> down, along_o = dot(e, toward_o) >> down;
  length >>= down;
  constexpr std::int64_t farthest = 16;  // in lengths of the side
  const std::int64_t far = farthest * length;
  if (to.r > farthest << unfolded_bits || std::abs(along_v) > far || std::abs(along_o) > far)
    return false;
  to.q = (along_v * (1 << unfolded_bits) + to.r * along_o) / length;
  return true;
}

/// How far along a side a vertex is, and how far away from it, in its lengths, in 1/2^16: of a
/// chart that keeps angles. False where the side has no length, or v is too far.
inline bool unfold_alike(const GridPlace& a, const GridPlace& b, const GridPlace& v, Unfolded& to) {
  const Arrow e = arrow(a, b), toward_v = arrow(a, v);
  const std::int64_t length = dot(e, e), along = dot(e, toward_v);
  constexpr std::int64_t farthest = 16;
  if (length == 0 || std::abs(along) > farthest * length) return false;
  const CrossSquare across(e, toward_v);
  to.q = along * (1 << unfolded_bits) / length;
  // At most 2^13 2^16 2^31.
  const std::int64_t away = square_root(across.square << 16) << 8 << across.shift;
  to.r = away / length;
  return to.r <= farthest << unfolded_bits;
}

}  // namespace clers::internal

#endif

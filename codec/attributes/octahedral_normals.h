// Normals that are points of an octahedral grid. What they are off is coded in the square as it
// unfolds around the axis that the prediction is nearest to, and with the signs that it has: so no
// residual crosses a border.
//
//      +-----------+        p: the point predicted, in the frame where 0 <= x <= y <= z
//      |  /  |  \  |        n: the normal. The residual is n - p along x, and along y.
//      |/    |p n\ |        A tip of the diamond is far from p: S / 2 and more.
//      +-----+-----+ x
//      | \   |   / |
//      +-----------+
#ifndef CLERS_CODEC_ATTRIBUTES_OCTAHEDRAL_NORMALS_H
#define CLERS_CODEC_ATTRIBUTES_OCTAHEDRAL_NORMALS_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "codec/attributes/known_values.h"
#include "codec/attributes/normal_expectation.h"
#include "codec/attributes/normal_formula.h"
#include "codec/numbers/octahedral.h"

namespace clers::internal {

/// Codes points of an octahedral grid, two integers each. Residuals codes what they are off.
template <class Int, class Coder, class Residuals>
class OctahedralNormals {
 public:
  OctahedralNormals(Coder& coder, unsigned bits, const FormulaNormals& formula, std::span<Int> rows)
      : coder_(coder),
        grid_(bits),
        expectation_(formula, rows.size() / 2),
        rows_(rows),
        sizes_(rows.size() / 2) {}

  /// False if what is decoded is no point.
  bool code(std::uint32_t v, const Nearby& nearby) {
    Vector3 normal;
    const unsigned kind = expectation_.expect(
        v, nearby, normal, [&](std::uint32_t u) { return OctahedralGrid::direction(point(u)); });
    const Vector3 on = grid_.project(normal);
    const OctahedralPoint p = grid_.nearest(on);
    const Frame frame(p, on);
    const OctahedralPoint expected = frame.from(p);
    std::array<std::int32_t, 2> given = {};
    if constexpr (Coder::encodes) given = grid_.unfold(frame.from(point(v)));
    NormalContexts context;
    context.expected = expected_size(nearby, sizes_, 20);
    for (std::size_t i = 0; i < 2; ++i)
      context.near[i] = nearby.count > i ? std::min<unsigned>(sizes_[nearby.around[i]], 18) : 19;
    context.shape = expectation_.shape();
    const std::array<unsigned, 2> parts = {part(frame, on, p, 0), part(frame, on, p, 1)};
    std::array<std::int32_t, 2> place;
    std::uint64_t off = 0;
    for (unsigned i = 0; i < 2; ++i) {
      context.component = i;
      context.part = parts[i];
      const std::int64_t r = residuals_.code(coder_, context, kind, given[i] - expected[i]);
      if (r < -grid_.size() - expected[i] || r > grid_.size() - expected[i]) return false;
      place[i] = static_cast<std::int32_t>(expected[i] + r);
      context.before = quarters_of(static_cast<std::uint64_t>(r < 0 ? -r : r));
      context.before_negative = r < 0;
      off += static_cast<std::uint64_t>(r < 0 ? -r : r);
    }
    const OctahedralPoint folded = grid_.fold(place[0], place[1]);
    if (grid_.unfold(folded) != place) return false;
    const OctahedralPoint actual = frame.to(folded);
    const auto integers = grid_.integers(actual);
    for (std::size_t i = 0; i < 2; ++i)
      rows_[2 * std::size_t(v) + i] = static_cast<Int>(integers[i]);
    sizes_[v] = static_cast<std::uint8_t>(quarters_of(off));
    expectation_.learn(v, normal, {double(actual[0]), double(actual[1]), double(actual[2])});
    return true;
  }

  static std::uint64_t memory(std::uint64_t values) {
    return values + NormalExpectation::memory(values) + Residuals::memory();
  }

 private:
  /// Axes in the order of a point's magnitudes, equal ones as they were, with its signs.
  class Frame {
   public:
    Frame(const OctahedralPoint& p, const Vector3& on) {
      const auto key = [&](unsigned i) { return static_cast<unsigned>(std::abs(p[i])) << 2 | i; };
      const unsigned x = key(0), y = key(1), z = key(2);
      const unsigned low = std::min(x, y), high = std::max(x, y), middle = std::min(high, z);
      axis_ = {std::min(low, z) & 3, std::max(low, middle) & 3, std::max(high, z) & 3};
      for (unsigned i = 0; i < 3; ++i)
        sign_[i] = 1 - 2 * static_cast<std::int32_t>(on[axis_[i]] < 0);
    }
    OctahedralPoint from(const OctahedralPoint& p) const {
      return {{sign_[0] * p[axis_[0]], sign_[1] * p[axis_[1]], sign_[2] * p[axis_[2]]}};
    }
    OctahedralPoint to(const OctahedralPoint& p) const {
      OctahedralPoint q;
      for (unsigned i = 0; i < 3; ++i) q[axis_[i]] = sign_[i] * p[i];
      return q;
    }
    double from(const Vector3& on, unsigned i) const { return sign_[i] * on[axis_[i]]; }

   private:
    std::array<unsigned, 3> axis_;
    std::array<std::int32_t, 3> sign_;
  };

  static unsigned part(const Frame& frame, const Vector3& on, const OctahedralPoint& p,
                       unsigned i) {
    return NormalContexts::part_of(frame.from(on, i) - frame.from(p)[i]);
  }
  OctahedralPoint point(std::size_t v) const {
    return grid_.point(static_cast<std::int64_t>(rows_[2 * v]),
                       static_cast<std::int64_t>(rows_[2 * v + 1]));
  }

  Coder& coder_;
  const OctahedralGrid grid_;
  NormalExpectation expectation_;
  const std::span<Int> rows_;
  std::vector<std::uint8_t> sizes_;  // of what was off, in quarter octaves
  Residuals residuals_;
};

}  // namespace clers::internal

#endif

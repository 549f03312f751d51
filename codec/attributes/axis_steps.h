// Steps along axes as lengths: how three components are computed with together, whatever their
// axes are. Two forms of one thing: few bits and equal axes, where it is fast; and any.
#ifndef CLERS_CODEC_ATTRIBUTES_AXIS_STEPS_H
#define CLERS_CODEC_ATTRIBUTES_AXIS_STEPS_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/attributes/residual_sizes.h"
#include "codec/attributes/triples.h"
#include "codec/base/portable.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// Slopes of z by x and y, and what x and y are off by.
using Pair = std::array<std::int64_t, 2>;

CLERS_ALWAYS_INLINE std::uint64_t magnitude(std::int64_t x) {
  const std::int64_t sign = x >> 63;
  return static_cast<std::uint64_t>((x ^ sign) - sign);
}

template <class Number>
CLERS_ALWAYS_INLINE std::array<std::int64_t, 3> cross(const Number* e, const Number* f) {
  return {std::int64_t(e[1]) * f[2] - std::int64_t(e[2]) * f[1],
          std::int64_t(e[2]) * f[0] - std::int64_t(e[0]) * f[2],
          std::int64_t(e[0]) * f[1] - std::int64_t(e[1]) * f[0]};
}

template <class Triple>
class AxisSteps;

/// All axes have one scale and no palette, and integers have 26 bits at most.
template <>
class AxisSteps<Narrow> {
 public:
  static bool fit(std::span<const Axis> axes) {
    return std::all_of(axes.begin(), axes.end(), [&](const Axis& axis) {
      return axis.palette.empty() && axis.scale == axes[0].scale && axis.top >> 26 == 0;
    });
  }
  explicit AxisSteps(std::span<const Axis> axes) {
    for (unsigned i = 0; i < 3; ++i) {
      top_[i] = axes[i].top;
      short_ = short_ && top_[i] >> 14 == 0;
    }
  }

  /// e x f
  CLERS_ALWAYS_INLINE std::array<std::int64_t, 3> normal(Narrow e, Narrow f) const {
    if (!short_) return cross(e.stored().at, f.stored().at);
    const auto n = cross_of_short(e, f).stored();
    return {n.at[0], n.at[1], n.at[2]};
  }

  /// What is between 0 and top, of what is predicted.
  Narrow inside(Narrow t) const { return t; }
  std::int64_t inside(unsigned, std::int64_t quarters) const { return quarters; }

  std::int64_t within(unsigned i, std::int64_t x) const {
    return std::clamp<std::int64_t>(x, 0, static_cast<std::int64_t>(top_[i]));
  }

  /// What is coded as no difference from x, which is within.
  std::int64_t nearest(unsigned, std::int64_t x) const { return x; }

  /// The mean of n, of which all but one add up to `off`, in quarters.
  CLERS_ALWAYS_INLINE std::int64_t quarters(std::int32_t off, unsigned n) const {
    static constexpr int parts[] = {0, 0, 256, 171};
    return std::int64_t(off) * parts[n] >> 7;
  }

  /// How large a number is, in a measure that is the same for all axes.
  int size(unsigned, std::uint64_t x) const { return static_cast<int>(size_of(x)); }
  /// What residuals of this size are coded in.
  CLERS_ALWAYS_INLINE ResidualContext context(unsigned, unsigned kind, int size) const {
    return ResidualContext(kind, static_cast<unsigned>(size));
  }
  CLERS_ALWAYS_INLINE std::int64_t lift(Pair slopes, Pair off, std::array<unsigned, 3>) const {
    return (slopes[0] * off[0] + slopes[1] * off[1]) >> 16;
  }

  CLERS_ALWAYS_INLINE std::int64_t difference(unsigned, std::int64_t value,
                                              std::int64_t from) const {
    return value - from;
  }
  /// Undoes that. False if there is no such value.
  CLERS_ALWAYS_INLINE bool apply(unsigned i, std::int64_t from, std::int64_t difference,
                                 std::int64_t& value) const {
    const std::int64_t sum = from + difference;
    const bool valid = static_cast<std::uint64_t>(sum) <= top_[i];
    value = valid ? sum : 0;
    return valid;
  }

 private:
  std::uint64_t top_[3];
  bool short_ = true;  ///< 14 bits at most
};

/// Any axes. Differences are scaled, and shifted down where they would be too large for products:
/// a length is (steps >> shift) factor.
template <>
class AxisSteps<Wide> {
 public:
  explicit AxisSteps(std::span<const Axis> axes) {
    int beyond = 0;  // bits of a length, but for 29
    for (const Axis& axis : axes)
      beyond = std::max(beyond, static_cast<int>(std::bit_width(axis.top)) +
                                    static_cast<int>(std::bit_width(axis.scale)) - 29);
    for (unsigned i = 0; i < 3; ++i) {
      const Axis& axis = axes[i];
      Steps& s = steps_[i];
      s.top = static_cast<std::int64_t>(axis.top);
      s.scale = axis.scale;
      s.palette = axis.palette;
      // As few bits of steps as possible are lost, but the factor has at least seven, or all.
      while (s.shift < beyond && s.scale >> (beyond - s.shift) < 64) ++s.shift;
      s.factor = s.scale >> (beyond - s.shift);
      s.unit = static_cast<int>(size_of(std::uint64_t(axis.scale) << 8));
      s.grain = s.unit;
      // Ranks are as far apart as they are in the mean.
      if (s.palette.size() > 1) {
        const std::uint64_t all = s.palette.back() - s.palette.front();
        s.grain += static_cast<int>(size_of((all << 3) / (s.palette.size() - 1))) -
                   static_cast<int>(size_of(8));
      }
    }
    const int least = std::min({steps_[0].unit, steps_[1].unit, steps_[2].unit});
    for (Steps& s : steps_) {
      s.unit -= least;
      s.grain -= least;
    }
  }

  std::array<std::int64_t, 3> normal(Wide e, Wide f) const {
    auto x = e.stored(), y = f.stored();
    for (unsigned i = 0; i < 3; ++i) {
      x.at[i] = (x.at[i] >> steps_[i].shift) * steps_[i].factor;
      y.at[i] = (y.at[i] >> steps_[i].shift) * steps_[i].factor;
    }
    return cross(x.at, y.at);
  }

  Wide inside(Wide t) const {
    for (unsigned i = 0; i < 3; ++i)
      t.q.at[i] = std::clamp<std::int64_t>(t.q.at[i], 0, steps_[i].top);
    return t;
  }
  std::int64_t inside(unsigned i, std::int64_t quarters) const {
    return std::clamp<std::int64_t>(quarters, 0, 4 * steps_[i].top);
  }

  std::int64_t within(unsigned i, std::int64_t x) const {
    return std::clamp<std::int64_t>(x, 0, steps_[i].top);
  }

  std::int64_t nearest(unsigned i, std::int64_t x) const {
    const auto& palette = steps_[i].palette;
    if (palette.empty()) return x;
    return static_cast<std::int64_t>(palette[static_cast<std::size_t>(nearest_rank(palette, x))]);
  }

  std::int64_t quarters(std::int64_t off, unsigned n) const {
    return n == 2 ? 2 * off : off + off / 3;
  }

  int size(unsigned i, std::uint64_t x) const {
    return static_cast<int>(size_of(x)) + steps_[i].unit;
  }
  ResidualContext context(unsigned i, unsigned kind, int size) const {
    return ResidualContext(kind, static_cast<unsigned>(std::max(size - steps_[i].grain, 0)));
  }

  std::int64_t lift(Pair slopes, Pair off, std::array<unsigned, 3> xyz) const {
    const int shift = std::max(
        static_cast<int>(std::bit_width(std::max(magnitude(off[0]), magnitude(off[1])))) - 28, 0);
    std::int64_t sum = 0;
    for (unsigned k = 0; k < 2; ++k) {
      const std::int64_t slope = slopes[k] * steps_[xyz[k]].scale / steps_[xyz[2]].scale;
      sum += slope * (off[k] >> shift);
    }
    const std::int64_t most = (std::int64_t(1) << 61) >> shift;
    return std::clamp(sum >> 16, -most, most) * (std::int64_t(1) << shift);
  }

  std::int64_t difference(unsigned i, std::int64_t value, std::int64_t from) const {
    const auto& palette = steps_[i].palette;
    if (palette.empty()) return value - from;
    const auto place =
        std::lower_bound(palette.begin(), palette.end(), static_cast<std::uint64_t>(value));
    return place - palette.begin() - nearest_rank(palette, from);
  }
  bool apply(unsigned i, std::int64_t from, std::int64_t difference, std::int64_t& value) const {
    const auto& palette = steps_[i].palette;
    const std::int64_t sum = difference + (palette.empty() ? from : nearest_rank(palette, from));
    const bool valid =
        sum >= 0 &&
        sum <= (palette.empty() ? steps_[i].top : static_cast<std::int64_t>(palette.size()) - 1);
    value = !valid            ? 0
            : palette.empty() ? sum
                              : static_cast<std::int64_t>(palette[static_cast<std::size_t>(sum)]);
    return valid;
  }

 private:
  /// Of the entry next to x; of two, the greater.
  static std::int64_t nearest_rank(std::span<const std::uint64_t> palette, std::int64_t x) {
    std::size_t first = 0, left = palette.size() - 1;
    while (left > 0) {
      const std::size_t half = left / 2, i = first + half;
      if (palette[i] + palette[i + 1] <= 2 * static_cast<std::uint64_t>(x)) {
        first = i + 1;
        left -= half + 1;
      } else {
        left = half;
      }
    }
    return static_cast<std::int64_t>(first);
  }

  struct Steps {
    std::int64_t top = 0, scale = 1, factor = 1;
    int shift = 0;
    int unit = 0;   ///< size of a step, beside that of the shortest
    int grain = 0;  ///< size of what is coded: of a step, or between ranks
    std::span<const std::uint64_t> palette;
  };
  std::array<Steps, 3> steps_;
};

}  // namespace clers::internal

#endif

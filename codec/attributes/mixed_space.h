// Space in which positions on a lattice are predicted: axes in true proportion, a frame about each
// vertex whose unit fits the lengths there, and the places of integers along an axis in it.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_SPACE_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_SPACE_H

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/attributes/fixed_point.h"
#include "codec/attributes/lattice.h"
#include "codec/attributes/vector.h"

namespace clers::internal::mixed {

/// Coordinates are integers times the scale of their axis, below 2^46: where they could be greater
/// the integers' lowest bits are left out.
class Space {
 public:
  explicit Space(std::span<const Axis> axes) {
    unsigned bits = 0;
    for (const Axis& axis : axes)
      bits = std::max(bits, static_cast<unsigned>(std::bit_width(axis.top)) +
                                static_cast<unsigned>(std::bit_width(axis.scale)));
    bits_ = std::max(bits, 1u);
    if (bits_ > 46) {
      drop_ = bits_ - 46;
      bits_ = 46;
    }
    for (unsigned i = 0; i < 3; ++i) {
      scale_[i] = axes[i].scale;
      step_[i] = fixed::log2(axes[i].scale) - static_cast<int>(drop_) * fixed::octave;
    }
  }

  template <class Int>
  Vector point(const Int* row) const {
    return {(std::int64_t(row[0]) >> drop_) * scale_[0],
            (std::int64_t(row[1]) >> drop_) * scale_[1],
            (std::int64_t(row[2]) >> drop_) * scale_[2]};
  }
  std::int64_t scale(unsigned axis) const { return scale_[axis]; }
  unsigned drop() const { return drop_; }
  /// All coordinates are below 2^bits.
  unsigned bits() const { return bits_; }
  /// log2, in 1/256, of an axis' step.
  int step(unsigned axis) const { return step_[axis]; }

 private:
  std::int64_t scale_[3];
  int step_[3];
  unsigned bits_ = 0, drop_ = 0;
};

/// Units of 2^-finer, from an origin.
struct Frame {
  static constexpr std::int64_t most = std::int64_t(1) << 28;

  Vector origin;
  int finer = 0;

  /// A difference in units of 2^-(finer + more), clamped.
  static std::int64_t scaled(std::int64_t d, int finer) {
    if (finer <= 0) return std::clamp(d >> -finer, -most, most);
    const std::int64_t limit = most >> finer;
    return std::clamp(d, -limit, limit) * (std::int64_t(1) << finer);
  }
  Vector local(Vector d) const {
    return {scaled(d.x, finer), scaled(d.y, finer), scaled(d.z, finer)};
  }
};

/// The integers that one axis allows, by index, and the places between them in a frame.
class Ruler {
 public:
  Ruler(const Space& space, const Axis& axis, unsigned component, const Frame& frame)
      : palette_(axis.palette),
        count_(palette_.empty() ? static_cast<std::int64_t>(axis.top) + 1
                                : static_cast<std::int64_t>(palette_.size())),
        top_(static_cast<std::int64_t>(axis.top)),
        scale_(space.scale(component)),
        origin_(frame.origin[component]),
        drop_(static_cast<int>(space.drop())),
        finer_(frame.finer),
        step_(space.step(component) + frame.finer * fixed::octave) {}

  std::int64_t count() const { return count_; }
  /// Whether indices are ranks in a palette.
  bool ranks() const { return !palette_.empty(); }
  /// log2 of a step in the frame, in 1/256.
  int step() const { return step_; }

  std::uint64_t value(std::int64_t index) const {
    return palette_.empty() ? static_cast<std::uint64_t>(index)
                            : palette_[static_cast<std::size_t>(index)];
  }
  std::int64_t index(std::uint64_t value) const {
    if (palette_.empty()) return static_cast<std::int64_t>(value);
    return std::lower_bound(palette_.begin(), palette_.end(), value) - palette_.begin();
  }

  /// The place half way between an index and the one before; 0 <= index <= count().
  std::int64_t edge(std::int64_t index) const {
    std::int64_t twice = 2 * index - 1;
    if (!palette_.empty()) {
      const std::size_t i = static_cast<std::size_t>(index);
      twice = index == 0        ? 2 * static_cast<std::int64_t>(palette_[0]) - 1
              : index == count_ ? 2 * static_cast<std::int64_t>(palette_[i - 1]) + 1
                                : static_cast<std::int64_t>(palette_[i - 1] + palette_[i]);
    }
    return Frame::scaled((twice >> drop_) * scale_ - 2 * origin_, finer_ - 1);
  }

  /// The first index that is not before a place, at most count() - 1.
  std::int64_t first_at_least(std::int64_t place) const {
    // Rounded up, in coordinates, then in integers.
    const std::int64_t coordinate =
        origin_ + (finer_ >= 0 ? (place + ((std::int64_t(1) << finer_) - 1)) >> finer_
                               : place * (std::int64_t(1) << -finer_));
    std::int64_t integer = coordinate <= 0 ? 0
                           : scale_ == 1   ? coordinate
                                           : (coordinate + scale_ - 1) / scale_;
    integer = std::min(integer, top_ >> drop_) << drop_;
    if (palette_.empty()) return std::min(integer, count_ - 1);
    return std::min<std::int64_t>(index(static_cast<std::uint64_t>(integer)), count_ - 1);
  }

  /// The cell that is about `step` steps further than cell `low`, at least one.
  std::int64_t step_from(bool up, std::int64_t middle, std::int64_t low, std::int64_t step) const {
    if (palette_.empty()) return low + step;
    const std::int64_t at = up ? middle + low : middle - 1 - low;
    if (at < 0 || at >= count_) return low + 1;
    const std::int64_t here = static_cast<std::int64_t>(palette_[static_cast<std::size_t>(at)]);
    const std::int64_t to = up ? here + step : here - step;
    const std::int64_t there = to < 0 ? -1 : index(static_cast<std::uint64_t>(to));
    return std::max(low + 1, up ? there - middle : middle - 1 - there);
  }

 private:
  std::span<const std::uint64_t> palette_;
  std::int64_t count_, top_, scale_, origin_;
  int drop_, finer_, step_;
};

}  // namespace clers::internal::mixed

#endif

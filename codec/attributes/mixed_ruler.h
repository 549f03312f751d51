// The integers that one axis allows, by index, and the places between them in a frame.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_RULER_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_RULER_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/attributes/mixed_space.h"
#include "codec/numbers/lattice.h"

namespace clers::internal::mixed {

/// Indices are the integers, or the ranks of those in a palette:
///
///     index      0     1           2   3          in the middle between two integers is an edge:
///     integer    2     3           9   10         edge(2) is where 6 would be
///             |     |        |       |     |
class Ruler {
 public:
  Ruler(const Space& space, const Axis& axis, std::size_t component, const Frame& frame)
      : space_(&space),
        palette_(axis.palette),
        component_(component),
        count_(palette_.empty() ? static_cast<std::int64_t>(axis.top) + 1
                                : static_cast<std::int64_t>(palette_.size())),
        scale_(space.scale(component)),
        origin_(frame.origin[component]),
        finer_(frame.finer) {}

  std::int64_t count() const { return count_; }
  /// Whether indices are ranks in a palette.
  bool ranks() const { return !palette_.empty(); }
  /// log2 of a step in the frame, in 1/256.
  int step() const { return space_->step(component_) + finer_ * fixed::octave; }

  std::uint64_t value(std::int64_t index) const {
    return ranks() ? palette_[static_cast<std::size_t>(index)] : static_cast<std::uint64_t>(index);
  }
  /// The first that is not below the value.
  std::int64_t index(std::uint64_t value) const {
    if (!ranks()) return static_cast<std::int64_t>(value);
    return std::lower_bound(palette_.begin(), palette_.end(), value) - palette_.begin();
  }

  /// The place half way between an index and the one before; beyond the ends, half a step off.
  std::int64_t edge(std::int64_t index) const {
    const std::int64_t twice = ranks() ? twice_between(index) : 2 * index - 1;
    return Frame::scaled((twice >> space_->drop()) * scale_ - 2 * origin_, finer_ - 1);
  }

  /// The first index that is not before a place, at most count() - 1.
  std::int64_t first_at_least(std::int64_t place) const {
    // Rounded up, in coordinates, then in integers.
    const std::int64_t up = finer_ > 0 ? (std::int64_t(1) << finer_) - 1 : 0;
    const std::int64_t coordinate = origin_ + shifted(place + up, -finer_);
    const std::int64_t integer = space_->integer(component_, coordinate + scale_ - 1);
    return std::min(index(static_cast<std::uint64_t>(integer)), count_ - 1);
  }

  /// The cell that is about `step` integers further than cell `low`, at least one: cell i, counted
  /// away from `middle`, is of one index if there is a palette, else of any number.
  std::int64_t step_from(bool up, std::int64_t middle, std::int64_t low, std::int64_t step) const {
    if (!ranks()) return low + step;
    const std::int64_t at = up ? middle + low : middle - 1 - low;
    if (at < 0 || at >= count_) return low + 1;
    const auto here = static_cast<std::int64_t>(palette_[static_cast<std::size_t>(at)]);
    const std::int64_t to = up ? here + step : here - step;
    const std::int64_t there = to < 0 ? -1 : index(static_cast<std::uint64_t>(to));
    return std::max(low + 1, up ? there - middle : middle - 1 - there);
  }

 private:
  std::int64_t twice_between(std::int64_t index) const {
    const auto at = [&](std::int64_t i) {
      return static_cast<std::int64_t>(palette_[static_cast<std::size_t>(i)]);
    };
    if (index == 0) return 2 * at(0) - 1;
    if (index == count_) return 2 * at(count_ - 1) + 1;
    return at(index - 1) + at(index);
  }

  const Space* space_;
  std::span<const std::uint64_t> palette_;
  std::size_t component_;
  std::int64_t count_, scale_, origin_;
  int finer_;
};

}  // namespace clers::internal::mixed

#endif

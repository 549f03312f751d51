// Space in which positions on a lattice are predicted: axes in true proportion, and a frame about
// each vertex whose unit fits the lengths there.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_SPACE_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_SPACE_H

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/attributes/fixed_point.h"
#include "codec/attributes/vector.h"
#include "codec/numbers/lattice.h"

namespace clers::internal::mixed {

/// Coordinates are integers times the scale of their axis, below 2^46: where they could be greater
/// the integers' lowest bits are left out.
class Space {
 public:
  explicit Space(std::span<const Axis> axes) {
    for (const Axis& axis : axes)
      bits_ = std::max(bits_, static_cast<int>(std::bit_width(axis.top)) +
                                  static_cast<int>(std::bit_width(axis.scale)));
    drop_ = std::max(bits_ - most_bits, 0);
    bits_ -= drop_;
    for (std::size_t i = 0; i < 3; ++i) {
      scale_[i] = axes[i].scale;
      top_[i] = static_cast<std::int64_t>(axes[i].top);
      step_[i] = fixed::log2(axes[i].scale) - drop_ * fixed::octave;
    }
  }

  template <class Int>
  Vector point(const Int* row) const {
    return {{coordinate(0, row[0]), coordinate(1, row[1]), coordinate(2, row[2])}};
  }
  std::int64_t coordinate(std::size_t axis, std::int64_t integer) const {
    return (integer >> drop_) * scale_[axis];
  }
  /// The greatest integer of an axis whose coordinate is not above this; 0 .. top.
  std::int64_t integer(std::size_t axis, std::int64_t coordinate) const {
    if (coordinate <= 0) return 0;
    const std::int64_t k = scale_[axis] == 1 ? coordinate : coordinate / scale_[axis];
    return std::min(k, top_[axis] >> drop_) << drop_;
  }
  std::int64_t scale(std::size_t axis) const { return scale_[axis]; }
  int drop() const { return drop_; }
  /// All coordinates are below 2^bits.
  int bits() const { return bits_; }
  /// log2, in 1/256, of an axis' step.
  int step(std::size_t axis) const { return step_[axis]; }
  /// log2 of a quarter of the least step: less is not told from nothing.
  int least_size() const {
    return drop_ > 0 ? -2 * fixed::octave
                     : std::min({step_[0], step_[1], step_[2]}) - 2 * fixed::octave;
  }
  /// The middle of all.
  Vector middle() const {
    return Vector{{coordinate(0, top_[0]), coordinate(1, top_[1]), coordinate(2, top_[2])}} >> 1;
  }

 private:
  static constexpr int most_bits = 46;

  std::int64_t scale_[3], top_[3];
  int step_[3];
  int bits_ = 1, drop_ = 0;
};

/// Units of 2^-finer, from an origin. Lengths along edges are below 2^20 or so in it; what is
/// further off than `most` is put there.
struct Frame {
  static constexpr int edge_bits = 20;
  static constexpr std::int64_t most = std::int64_t(1) << 28;

  Vector origin;
  int finer = 0;

  static std::int64_t scaled(std::int64_t d, int finer) {
    if (finer <= 0) return std::clamp(d >> -finer, -most, most);
    const std::int64_t limit = most >> finer;
    return std::clamp(d, -limit, limit) * (std::int64_t(1) << finer);
  }
  Vector scaled(const Vector& d) const {
    return {{scaled(d[0], finer), scaled(d[1], finer), scaled(d[2], finer)}};
  }
  /// The place of a point.
  Vector place(const Vector& point) const { return scaled(point - origin); }

  /// log2, in 1/256, of an octave in it.
  int octaves() const { return finer * fixed::octave; }
};

}  // namespace clers::internal::mixed

#endif

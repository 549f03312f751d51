// One integer as a sequence of decisions: is it at least where the leading expert expects it? Then
// away from there, in steps of about a scale; then halving; then what is below the scale, raw.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_DECISIONS_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_DECISIONS_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "codec/attributes/distribution.h"
#include "codec/attributes/fixed_point.h"
#include "codec/attributes/mixed_mixing.h"
#include "codec/attributes/mixed_ruler.h"
#include "codec/entropy/coder.h"

namespace clers::internal::mixed {

/// What an expert says of one component: about where it is, in units of the frame.
struct Opinion {
  std::int64_t mean = 0;
  int scale = 0;  ///< log2 in 1/256
};

/// Says how far a place is from the means of all experts, in units of their scales.
class Gauge {
 public:
  using Distances = std::array<std::int32_t, experts>;

  Gauge(const std::array<Opinion, experts>& opinions, unsigned present) : present_(present) {
    for (unsigned i = 0; i < present; ++i) {
      const int power = -opinions[i].scale;
      mean_[i] = opinions[i].mean;
      mantissa_[i] = fixed::tables::powers[static_cast<std::size_t>(power & 255)];
      shift_[i] = 9 - (power >> 8);
    }
  }
  /// In 1/128.
  Distances operator()(std::int64_t place) const {
    Distances z;
    for (unsigned i = 0; i < present_; ++i)
      z[i] = static_cast<std::int32_t>(
          std::clamp<std::int64_t>((place - mean_[i]) * mantissa_[i] >> shift_[i],
                                   -MissDistribution::most, MissDistribution::most));
    return z;
  }

 private:
  unsigned present_;
  std::int64_t mean_[experts];
  std::int64_t mantissa_[experts];
  int shift_[experts];
};

/// How far a place is from what an expert says, in 1/128 of its scale; at most 10000.
inline int distance(const Opinion& opinion, std::int64_t place) {
  const std::int64_t off = size_of(place - opinion.mean);
  const int power = -opinion.scale;
  const std::int64_t mantissa = fixed::tables::powers[static_cast<std::size_t>(power & 255)];
  return static_cast<int>(std::min<std::int64_t>(off * mantissa >> (9 - (power >> 8)), 10000));
}

/// Codes one component. Experts from `present` on say nothing.
template <class Coder>
class ComponentCoder {
 public:
  ComponentCoder(Coder& coder, Mixing& mixing, const Ruler& ruler,
                 const std::array<Opinion, experts>& opinions, unsigned present)
      : coder_(coder),
        mixing_(mixing),
        ruler_(ruler),
        gauge_(opinions, present),
        present_(present) {
    mixing.said.fill(0);
  }

  /// False: what was decoded is not in 0 .. top.
  bool code(const Opinion& lead, std::uint64_t& value) {
    const std::int64_t count = ruler_.count();
    if (count == 1) {
      value = ruler_.value(0);
      return true;
    }
    const std::int64_t index = Coder::encodes ? ruler_.index(value) : 0;
    const int scale = lead.scale - ruler_.step();  // of an integer
    const int most_bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(count))) - 4;
    low_bits_ = ruler_.ranks() ? 0 : std::max(std::min((scale >> 8) - 1, most_bits), 0);
    middle_ = ruler_.first_at_least(lead.mean);
    low_edge_ = ruler_.edge(middle_);
    up_ = first(index);
    const std::int64_t room = up_ ? count - middle_ : middle_;
    if (room == 0) return false;
    const std::int64_t cells = (room + (std::int64_t(1) << low_bits_) - 1) >> low_bits_;
    const std::int64_t offset = up_ ? index - middle_ : middle_ - 1 - index;
    go_away(offset >> low_bits_, cells, scale);
    halve(offset >> low_bits_);
    const std::int64_t away = (low_ << low_bits_) + code_raw(offset);
    if (away >= room) return false;
    value = ruler_.value(up_ ? middle_ + away : middle_ - 1 - away);
    return true;
  }

 private:
  /// Kinds of decisions: the first, then away, then halving.
  static constexpr unsigned first_away = 1, last_away = 7, halving = Mixing::first_halving,
                            last_halving = Mixing::decisions - 1;
  static constexpr unsigned constant_steps = 3;  ///< then they double

  /// Is the index at least the middle?
  bool first(std::int64_t index) {
    const Gauge::Distances z = gauge_(low_edge_);
    for (unsigned i = 0; i < present_; ++i) {
      above_[i] = tables_.survival(z[i]);
      below_[i] = tables_.survival(-z[i]);
      mixing_.said[i] = static_cast<std::int16_t>(
          std::clamp((above_[i] - below_[i]) >> 4, -max_logit, max_logit));
    }
    return mixing_.code(coder_, 0, index >= middle_);
  }

  /// The edge before a cell of 2^low_bits indices, counted away from the middle.
  std::int64_t edge(std::int64_t cell) const {
    const std::int64_t d = cell << low_bits_;
    return ruler_.edge(up_ ? middle_ + d : middle_ - d);
  }

  /// Is it further away than that? Leaves it between two cells.
  void go_away(std::int64_t target, std::int64_t cells, int scale) {
    // .9 of the scale
    const int log = std::clamp(scale - low_bits_ * fixed::octave - 39, -256, 44 * fixed::octave);
    std::int64_t step =
        std::max(static_cast<std::int64_t>(fixed::exp2(log) + 32768) >> 16, std::int64_t(1));
    std::array<int, experts>& from = up_ ? above_ : below_;
    low_ = 0;
    for (unsigned decision = first_away;; decision = std::min(decision + 1, last_away)) {
      high_ = std::min(ruler_.step_from(up_, middle_, low_, step), cells);
      high_edge_ = edge(high_);
      if (high_ == cells) return;
      const Gauge::Distances z = gauge_(high_edge_);
      std::array<int, experts> to;
      for (unsigned i = 0; i < present_; ++i) {
        to[i] = tables_.survival(up_ ? z[i] : -z[i]);
        mixing_.said[i] = static_cast<std::int16_t>(tables_.odds(from[i] - to[i]));
      }
      if (!mixing_.code(coder_, decision, target >= high_)) return;
      low_ = high_;
      low_edge_ = high_edge_;
      std::copy_n(to.begin(), present_, from.begin());
      if (decision >= constant_steps) step *= 2;
    }
  }

  /// Is it in the further half?
  void halve(std::int64_t target) {
    for (unsigned decision = halving; high_ - low_ > 1;
         decision = std::min(decision + 1, last_halving)) {
      const std::int64_t half = low_ + (high_ - low_) / 2;
      const std::int64_t half_edge = edge(half);
      const Gauge::Distances near = gauge_((low_edge_ + half_edge) >> 1);
      const Gauge::Distances far = gauge_((half_edge + high_edge_) >> 1);
      const auto width = [](std::int64_t d) {
        return fixed::log2(static_cast<std::uint64_t>(size_of(d)));
      };
      constexpr int ln2 = 177;  // in 1/256
      const int widths = (width(high_edge_ - half_edge) - width(half_edge - low_edge_)) * ln2 >> 8;
      for (unsigned i = 0; i < present_; ++i) {
        const int densities = tables_.log_density(far[i]) - tables_.log_density(near[i]);
        mixing_.said[i] =
            static_cast<std::int16_t>(std::clamp(widths + densities, -max_logit, max_logit));
      }
      const bool further = mixing_.code(coder_, decision, target >= half);
      (further ? low_ : high_) = half;
      (further ? low_edge_ : high_edge_) = half_edge;
    }
  }

  /// Where in its cell it is, all places alike.
  std::int64_t code_raw(std::int64_t offset) {
    std::int64_t rest = 0;
    for (int bits = low_bits_; bits > 0;) {
      const int part = std::min(bits, 14);
      bits -= part;
      const std::int64_t mask = (std::int64_t(1) << part) - 1;
      const auto given = static_cast<std::uint32_t>(offset >> bits & mask);
      rest |= std::int64_t(coder_.raw(static_cast<unsigned>(part), given)) << bits;
    }
    return rest;
  }

  Coder& coder_;
  Mixing& mixing_;
  const Ruler& ruler_;
  Gauge gauge_;
  unsigned present_;
  const MissDistribution& tables_ = MissDistribution::tables();
  std::array<int, experts> above_, below_;  ///< ln of the probability to be on that side of low_
  std::int64_t middle_ = 0, low_ = 0, high_ = 0, low_edge_ = 0, high_edge_ = 0;
  int low_bits_ = 0;
  bool up_ = false;
};

}  // namespace clers::internal::mixed

#endif

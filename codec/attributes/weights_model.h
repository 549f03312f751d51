// How weights are predicted: what encoder and decoder share. It knows the surface and a coder, but
// no bytes of a file.
#ifndef CLERS_CODEC_ATTRIBUTES_WEIGHTS_MODEL_H
#define CLERS_CODEC_ATTRIBUTES_WEIGHTS_MODEL_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "codec/attributes/axis_steps.h"
#include "codec/attributes/charts_apart.h"
#include "codec/attributes/known_values.h"
#include "codec/attributes/residual_sizes.h"
#include "codec/attributes/value_surface.h"
#include "codec/entropy/coder.h"
#include "codec/entropy/lanes.h"
#include "codec/numbers/number_line.h"
#include "codec/numbers/number_system.h"

namespace clers::internal {

/// The weights of one component, by integers or, with a palette, ranks.
class WeightLine {
 public:
  WeightLine(const NumberSystem& system, const Axis& axis, Scalar scalar)
      : axis_(axis), line_(number_line(system, axis, scalar)) {
    const std::uint64_t near = nearest(0);
    if (weight(near) == 0) zero_ = near;
  }
  std::uint64_t top() const { return axis_.palette.empty() ? axis_.top : axis_.palette.size() - 1; }
  double weight(std::uint64_t k) const {
    return line_->value(axis_.palette.empty() ? k : axis_.palette[static_cast<std::size_t>(k)]);
  }
  std::uint64_t nearest(double weight) const {
    const std::uint64_t k = line_->nearest(weight);
    const auto& p = axis_.palette;
    if (p.empty()) return k;
    const auto at = std::lower_bound(p.begin(), p.end(), k) - p.begin();
    return std::min(static_cast<std::uint64_t>(at), top());
  }
  /// What stands for the weight 0, if there is one.
  std::optional<std::uint64_t> zero() const { return zero_; }

 private:
  const Axis& axis_;
  std::unique_ptr<NumberLine> line_;
  std::optional<std::uint64_t> zero_;
};
using WeightLines = std::vector<WeightLine>;

inline WeightLines weight_lines(const Numbers& numbers) {
  WeightLines lines;
  for (std::size_t c = 0; c < numbers.axes.size(); ++c)
    lines.emplace_back(numbers.systems[c], numbers.axes[c], numbers.scalar);
  return lines;
}

/// Codes values with Coder, one that encodes what is in the rows or one that fills them.
///
/// First which components are 0. The last one that is not is what the others leave of 1, mostly,
/// but for how they were rounded. The others are predicted by the mean of those around that are not
/// 0 either. Precondition: a DoublePrecision is there.
template <class Int, class Coder>
class WeightsModel {
 public:
  WeightsModel(Coder& coder, const Numbers& numbers, std::span<Int> rows)
      : coder_(coder),
        lines_(weight_lines(numbers)),
        rows_(rows),
        width_(lines_.size()),
        sizes_(rows.size()),
        components_(width_) {}

  static std::uint64_t memory(std::uint64_t values, std::uint64_t components) {
    return values * components + components * (sizeof(Component) + sizeof(WeightLine) + 512) +
           (1 << 16);
  }

  /// False if an integer that is decoded is none of its component.
  bool code(std::uint32_t v, const Nearby& nearby) {
    if (nearby.same != Nearby::none && code_same(v, nearby.same)) return true;
    std::size_t last = width_;
    bool before = false;
    for (std::size_t c = 0; c < width_; ++c) {
      before = code_zero(v, c, before, nearby);
      if (!before) last = c;
    }
    double rest = 1;
    for (std::size_t c = 0; c < width_; ++c) {
      if (is_zero(v, c)) continue;
      const std::uint64_t whole = lines_[c].nearest(rest);
      const bool is_whole = c == last && code_whole(v, c, whole);
      if (!valid_ || (!is_whole && !code_weight(v, c, nearby))) return false;
      rest -= lines_[c].weight(static_cast<std::uint64_t>(at(v, c)));
    }
    return true;
  }

 private:
  /// How far what is left of 1 may be off: by a digit that others do not have, and a few steps.
  static constexpr std::int64_t nearly = 15;
  /// So that sums of differences of all neighbours fit.
  static constexpr int coarse = sizeof(Int) == 4 ? 0 : 4;
  static constexpr std::uint8_t zero_size = 0;  ///< in sizes_: weights are 0; others are 1 more

  struct Component {
    BitModel zero[2][3];  ///< by the component before, and whether all, some or none around are
    UsualSize usual, usual_whole;
    std::int64_t last = 0;
  };

  Int& at(std::size_t v, std::size_t c) { return rows_[v * width_ + c]; }
  std::uint8_t& size(std::size_t v, std::size_t c) { return sizes_[v * width_ + c]; }
  bool is_zero(std::size_t v, std::size_t c) { return size(v, c) == zero_size; }

  bool code_same(std::uint32_t v, std::uint32_t u) {
    bool same = false;
    if constexpr (Coder::encodes) same = std::equal(&at(v, 0), &at(v, 0) + width_, &at(u, 0));
    same = coder_.flag(2, same_[last_same_], same);
    last_same_ = (2 * last_same_ + same) % 4;
    if (!same) return false;
    std::copy_n(&at(u, 0), width_, &at(v, 0));
    std::copy_n(&size(u, 0), width_, &size(v, 0));
    return true;
  }

  /// Whether component c is 0.
  bool code_zero(std::uint32_t v, std::size_t c, bool before, const Nearby& nearby) {
    const std::optional<std::uint64_t> zero = lines_[c].zero();
    bool is = false;
    if (zero) {
      std::size_t zeros = 0;
      for (std::size_t i = 0; i < nearby.count; ++i) zeros += is_zero(nearby.around[i], c);
      const std::size_t around = nearby.count == 0      ? 1
                                 : zeros == 0           ? 0
                                 : zeros < nearby.count ? 1
                                                        : 2;
      if constexpr (Coder::encodes) is = at(v, c) == static_cast<Int>(*zero);
      is = coder_.flag(2, components_[c].zero[before][around], is);
      if (is) at(v, c) = static_cast<Int>(*zero);
    }
    size(v, c) = is ? zero_size : 1;
    return is;
  }

  /// Whether component c is what is left of 1, and what it is; false if it is not.
  bool code_whole(std::uint32_t v, std::size_t c, std::uint64_t whole) {
    const auto from = static_cast<std::int64_t>(whole);
    std::int64_t r = 0;
    if constexpr (Coder::encodes) r = at(v, c) - from;
    const bool is = coder_.flag(2, whole_[last_whole_], magnitude(r) <= nearly);
    last_whole_ = (2 * last_whole_ + is) % 4;
    if (!is) return false;
    Component& component = components_[c];
    if (!code_residual(v, c, from, {3, component.usual_whole.size()}, r)) return valid_ = false;
    component.usual_whole.learn(4 * magnitude(r));
    size(v, c) = 1;
    return true;
  }

  /// Component c, which is not 0.
  bool code_weight(std::uint32_t v, std::size_t c, const Nearby& nearby) {
    Component& component = components_[c];
    std::int64_t first = 0, off = 0, sizes = 0, count = 0;
    for (std::size_t i = 0; i < nearby.count; ++i) {
      const std::uint32_t u = nearby.around[i];
      if (is_zero(u, c)) continue;
      if (count == 0) first = at(u, c);
      off += (at(u, c) - first) >> coarse;
      sizes += size(u, c) - 1;
      ++count;
    }
    const std::int64_t from =
        count == 0 ? component.last : first + off / count * (std::int64_t(1) << coarse);
    const unsigned usual = component.usual.size(),
                   expected =
                       count == 0 ? usual : (static_cast<unsigned>(sizes / count) + usual) / 2;
    std::int64_t r = 0;
    if constexpr (Coder::encodes) r = at(v, c) - from;
    if (!code_residual(v, c, from, {0, expected}, r)) return false;
    const std::uint64_t quarters = 4 * magnitude(r);
    component.usual.learn(quarters);
    component.last = at(v, c);
    size(v, c) = static_cast<std::uint8_t>(size_of(quarters) + 1);
    return true;
  }

  bool code_residual(std::uint32_t v, std::size_t c, std::int64_t from, ResidualContext context,
                     std::int64_t& r) {
    const unsigned kind = static_cast<unsigned>(std::min<std::size_t>(c, 2));
    std::uint64_t low = 0;
    if constexpr (Coder::encodes) {
      low = place_in_bin(r, context.width);
      coder_.bits(context.width, low);
    } else {
      low = coder_.bits(context.width, 0, 0)[0];
    }
    if (!residuals_.code(coder_, kind % 2, context, kind, low, r)) return false;
    const std::int64_t x = from + r;
    if (static_cast<std::uint64_t>(x) > lines_[c].top()) return false;
    at(v, c) = static_cast<Int>(x);
    return true;
  }

  Coder& coder_;
  const WeightLines lines_;
  const std::span<Int> rows_;
  const std::size_t width_;
  std::vector<std::uint8_t> sizes_;
  std::vector<Component> components_;
  ResidualModel residuals_;
  BitModel same_[4], whole_[4];
  unsigned last_same_ = 3, last_whole_ = 3;
  bool valid_ = true;
};

}  // namespace clers::internal

#endif

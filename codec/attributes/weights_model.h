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
#include "codec/attributes/weight_lines.h"
#include "codec/entropy/coder.h"
#include "codec/entropy/lanes.h"
#include "codec/numbers/number_system.h"

namespace clers::internal {

/// Codes values with Coder, one that encodes what is in the rows or one that fills them.
///
/// First which components are 0. The last one that is not is what the others leave of 1, mostly,
/// but for how they were rounded. The others are predicted by those around: between the gate's
/// parallelogram and the mean, nearer to the first. Where joints are known, what is around is the
/// weight of the same joint, else that of the same component. Precondition: a DoublePrecision is
/// there.
template <class Int, class Coder>
class WeightsModel {
 public:
  /// `joints` fit, or are nullptr.
  WeightsModel(Coder& coder, const Numbers& numbers, const Attribute* joints, std::span<Int> rows)
      : coder_(coder),
        lines_(weight_lines(numbers)),
        owners_(joints),
        rows_(rows),
        width_(lines_.size()),
        weights_(rows.size()),
        sizes_(rows.size()),
        components_(width_) {
    unsigned least = ~0u;
    for (const WeightLine& line : lines_) least = std::min(least, line.step_size());
    for (std::size_t c = 0; c < width_; ++c)
      components_[c].step_size = lines_[c].step_size() - least;
  }

  static std::uint64_t memory(std::uint64_t values, std::uint64_t components) {
    return 9 * values * components + components * (sizeof(Component) + sizeof(WeightLine) + 512) +
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
      const Guess guess = guess_of(v, c, nearby);
      const std::uint64_t whole = lines_[c].nearest(rest);
      const bool is_whole = c == last && code_whole(v, c, whole);
      if (!valid_ || (!is_whole && !code_weight(v, c, guess))) return false;
      learn(v, c, guess);
      rest -= weight(v, c);
    }
    return true;
  }

 private:
  /// How far what is left of 1 may be off: by a digit that others do not have, and a few steps.
  static constexpr std::int64_t nearly = 15;
  static constexpr std::uint8_t zero_size = 0;  ///< in sizes_: weights are 0; others are 1 more

  struct Component {
    BitModel zero[2][4];  ///< by the component before, and whether all, some or none around are
    UsualSize usual, usual_whole;
    double last = 0;
    unsigned step_size = 0;  ///< of a step, beside the shortest
  };
  /// What is expected of a component by those around.
  struct Guess {
    std::uint64_t k = 0;
    unsigned size = 0;
  };

  Int& at(std::size_t v, std::size_t c) { return rows_[v * width_ + c]; }
  double& weight(std::size_t v, std::size_t c) { return weights_[v * width_ + c]; }
  std::uint8_t& size(std::size_t v, std::size_t c) { return sizes_[v * width_ + c]; }
  bool is_zero(std::size_t v, std::size_t c) { return size(v, c) == zero_size; }

  /// The component of u that is not 0 and has the owner of v's component c; width_ if there is
  /// none.
  std::size_t component_of(std::size_t u, std::size_t v, std::size_t c) {
    std::size_t d = 0;
    while (d < width_ && (is_zero(u, d) || !owners_.equal(v, c, u, d))) ++d;
    return d;
  }

  bool code_same(std::uint32_t v, std::uint32_t u) {
    bool same = false;
    if constexpr (Coder::encodes) same = std::equal(&at(v, 0), &at(v, 0) + width_, &at(u, 0));
    same = coder_.flag(2, same_[last_same_], same);
    last_same_ = (2 * last_same_ + same) % 4;
    if (!same) return false;
    std::copy_n(&at(u, 0), width_, &at(v, 0));
    std::copy_n(&weight(u, 0), width_, &weight(v, 0));
    std::copy_n(&size(u, 0), width_, &size(v, 0));
    return true;
  }

  /// Whether component c is 0.
  bool code_zero(std::uint32_t v, std::size_t c, bool before, const Nearby& nearby) {
    const std::optional<std::uint64_t> zero = lines_[c].zero();
    bool is = false;
    if (zero) {
      std::size_t zeros = 0;
      for (std::size_t i = 0; i < nearby.count; ++i)
        zeros += component_of(nearby.around[i], v, c) == width_;
      const std::size_t around = c > 0 && has_earlier(v, c) ? 3
                                 : nearby.count == 0        ? 1
                                 : zeros == 0               ? 0
                                 : zeros < nearby.count     ? 1
                                                            : 2;
      if constexpr (Coder::encodes) is = at(v, c) == static_cast<Int>(*zero);
      is = coder_.flag(2, components_[c].zero[before][around], is);
      if (is) {
        at(v, c) = static_cast<Int>(*zero);
        weight(v, c) = 0;
      }
    }
    size(v, c) = is ? zero_size : 1;
    return is;
  }
  /// Whether an earlier component that is not 0 has the same owner.
  bool has_earlier(std::size_t v, std::size_t c) {
    for (std::size_t d = 0; d < c; ++d)
      if (!is_zero(v, d) && owners_.equal(v, c, v, d)) return true;
    return false;
  }

  Guess guess_of(std::uint32_t v, std::size_t c, const Nearby& nearby) {
    const Component& component = components_[c];
    double sum = 0;
    unsigned sizes = 0, count = 0;
    for (std::size_t i = 0; i < nearby.count; ++i) {
      const std::uint32_t u = nearby.around[i];
      const std::size_t d = component_of(u, v, c);
      if (d == width_) continue;
      sum += weight(u, d);
      const unsigned s = size(u, d) - 1u;
      sizes += s > component.step_size ? s - component.step_size : 0;
      ++count;
    }
    const unsigned usual = component.usual.size();
    if (count == 0) return {lines_[c].nearest(component.last), usual};
    const double mean = sum / static_cast<double>(nearby.count);
    if (nearby.c == Nearby::none) return {lines_[c].nearest(mean), (sizes / count + usual) / 2};
    const auto of = [&](std::uint32_t u) {
      const std::size_t d = component_of(u, v, c);
      return d < width_ ? weight(u, d) : 0;
    };
    const double along = std::clamp(of(nearby.a) + of(nearby.b) - of(nearby.c), 0., 1.);
    const auto spread =
        static_cast<std::int64_t>(lines_[c].nearest(along) - lines_[c].nearest(mean));
    return {lines_[c].nearest((3 * along + mean) / 4),
            (sizes / count + usual + size_of(4 * magnitude(spread))) / 3};
  }

  /// Whether component c is what is left of 1, and what it is; false if it is not.
  bool code_whole(std::uint32_t v, std::size_t c, std::uint64_t whole) {
    const auto from = static_cast<std::int64_t>(whole);
    std::int64_t r = 0;
    if constexpr (Coder::encodes) r = at(v, c) - from;
    const bool is = coder_.flag(2, whole_[last_whole_], magnitude(r) <= nearly);
    last_whole_ = (2 * last_whole_ + is) % 4;
    if (!is) return false;
    UsualSize& usual = components_[c].usual_whole;
    if (!code_residual(v, c, from, {3, usual.size()}, r)) return valid_ = false;
    usual.learn(4 * magnitude(r));
    return true;
  }

  /// Component c, which is not 0.
  bool code_weight(std::uint32_t v, std::size_t c, const Guess& guess) {
    const auto from = static_cast<std::int64_t>(guess.k);
    std::int64_t r = 0;
    if constexpr (Coder::encodes) r = at(v, c) - from;
    if (!code_residual(v, c, from, {0, guess.size}, r)) return false;
    components_[c].usual.learn(4 * magnitude(r));
    return true;
  }

  /// Component c is known.
  void learn(std::uint32_t v, std::size_t c, const Guess& guess) {
    const std::uint64_t k = static_cast<std::uint64_t>(at(v, c)),
                        off = k < guess.k ? guess.k - k : k - guess.k;
    const unsigned steps = off == 0 ? 0 : size_of(4 * off) + components_[c].step_size;
    size(v, c) = static_cast<std::uint8_t>(std::min(steps, 254u) + 1);
    weight(v, c) = lines_[c].weight(k);
    components_[c].last = weight(v, c);
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
  const WeightOwners owners_;
  const std::span<Int> rows_;
  const std::size_t width_;
  std::vector<double> weights_;
  std::vector<std::uint8_t> sizes_;  // of what was off
  std::vector<Component> components_;
  ResidualModel residuals_;
  BitModel same_[4], whole_[4];
  unsigned last_same_ = 3, last_whole_ = 3;
  bool valid_ = true;
};

}  // namespace clers::internal

#endif

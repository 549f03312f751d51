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

  void set(const std::array<Opinion, experts>& opinions) {
    for (unsigned i = 0; i < experts; ++i) {
      const int power = -opinions[i].scale;
      mean_[i] = opinions[i].mean;
      mantissa_[i] = fixed::tables::powers[static_cast<std::size_t>(power & 255)];
      shift_[i] = 9 - (power >> 8);
    }
  }
  /// In 1/128.
  Distances operator()(std::int64_t place) const {
    Distances z;
    for (unsigned i = 0; i < experts; ++i) {
      const std::int64_t d = (place - mean_[i]) * mantissa_[i] >> shift_[i];
      z[i] = static_cast<std::int32_t>(
          std::clamp<std::int64_t>(d, -Distribution::most, Distribution::most));
    }
    return z;
  }

 private:
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

/// Codes one component. `present` has a bit for each expert that says something, `lead` is one of
/// them. False: what was decoded is not in 0 .. top.
template <class Coder>
bool code_component(Coder& coder, Mixing& mixing, const Ruler& ruler,
                    const std::array<Opinion, experts>& opinions, unsigned present, unsigned lead,
                    std::uint64_t& value) {
  const Distribution& distribution = Distribution::tables();
  Gauge gauge;
  gauge.set(opinions);
  const std::int64_t count = ruler.count();
  const std::int64_t middle = ruler.first_at_least(opinions[lead].mean);
  const int scale = opinions[lead].scale - ruler.step();  // of a step
  const int most_bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(count))) - 4;
  const int low_bits = ruler.ranks() ? 0 : std::max(std::min((scale >> 8) - 3, most_bits), 0);
  const std::int64_t index = Coder::encodes ? ruler.index(value) : 0;

  Gauge::Distances from = gauge(ruler.edge(middle));
  for (unsigned i = 0; i < experts; ++i)
    mixing.said[i] =
        static_cast<std::int16_t>(present >> i & 1 ? distribution.at_least(from[i]) : 0);
  const bool up = mixing.code(coder, 0, index >= middle);

  // Cells of 2^low_bits indices, counted away from the middle.
  const std::int64_t room = up ? count - middle : middle;
  const std::int64_t cells = (room + (std::int64_t(1) << low_bits) - 1) >> low_bits;
  const auto edge = [&](std::int64_t cell) {
    const std::int64_t d = cell << low_bits;
    return ruler.edge(up ? middle + d : middle - d);
  };
  const std::int64_t offset = up ? index - middle : middle - 1 - index;
  const std::int64_t target = offset >> low_bits;
  const int sign = up ? 1 : -1;
  for (std::int32_t& z : from) z *= sign;

  std::int64_t low = 0, high = cells;
  std::int64_t low_edge = edge(0), high_edge = 0;
  if (cells == 0) return false;
  std::int64_t step = std::max<std::int64_t>(
      static_cast<std::int64_t>(
          fixed::exp2(std::clamp(scale - 256 * low_bits - 39, -256, 256 * 44)) + 32768) >>
          16,
      1);
  unsigned decision = 1;
  for (;; decision = std::min(decision + 1, 7u)) {
    high = ruler.step_from(up, middle, low, step);
    if (high >= cells) {
      high = cells;
      high_edge = edge(high);
      break;
    }
    high_edge = edge(high);
    Gauge::Distances to = gauge(high_edge);
    for (unsigned i = 0; i < experts; ++i) {
      to[i] *= sign;
      mixing.said[i] =
          static_cast<std::int16_t>(present >> i & 1 ? distribution.further(from[i], to[i]) : 0);
    }
    if (!mixing.code(coder, decision, target >= high)) break;
    low = high;
    low_edge = high_edge;
    from = to;
    if (decision >= 3) step *= 2;
  }
  for (unsigned depth = 8; high - low > 1; depth = std::min(depth + 1, 15u)) {
    const std::int64_t half = low + (high - low) / 2;
    const std::int64_t half_edge = edge(half);
    const Gauge::Distances near = gauge((low_edge + half_edge) >> 1);
    const Gauge::Distances far = gauge((half_edge + high_edge) >> 1);
    const auto width = [](std::int64_t d) {
      return fixed::log2(static_cast<std::uint64_t>(d < 0 ? -d : d));
    };
    const int widths = (width(high_edge - half_edge) - width(half_edge - low_edge)) * 177 >> 8;
    for (unsigned i = 0; i < experts; ++i)
      mixing.said[i] = static_cast<std::int16_t>(
          present >> i & 1 ? std::clamp(widths + distribution.log_density(far[i]) -
                                            distribution.log_density(near[i]),
                                        -max_logit, max_logit)
                           : 0);
    if (mixing.code(coder, depth, target >= half)) {
      low = half;
      low_edge = half_edge;
    } else {
      high = half;
      high_edge = half_edge;
    }
  }
  std::int64_t rest = 0;
  for (int bits = low_bits; bits > 0;) {
    const int part = std::min(bits, 14);
    bits -= part;
    const std::int64_t mask = (std::int64_t(1) << part) - 1;
    rest |= std::int64_t(coder.raw(static_cast<unsigned>(part),
                                   static_cast<std::uint32_t>(offset >> bits & mask)))
            << bits;
  }
  const std::int64_t away = (low << low_bits) + rest;
  if (away >= room) return false;
  value = ruler.value(up ? middle + away : middle - 1 - away);
  return true;
}

}  // namespace clers::internal::mixed

#endif

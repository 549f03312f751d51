// About how many bits numbers take in a system: to choose among systems.
#ifndef CLERS_CODEC_NUMBERS_SYSTEM_COST_H
#define CLERS_CODEC_NUMBERS_SYSTEM_COST_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/numbers/number_sample.h"
#include "codec/numbers/place_numbers.h"

namespace clers::internal {

/// Of 1/256 bit each.
using Cost = std::uint64_t;

/// log2(n), with a linear mantissa: the same on every machine, and near enough. n >= 1.
inline Cost log2_about(std::uint64_t n) {
  const auto exponent = static_cast<unsigned>(std::bit_width(n)) - 1;
  const std::uint64_t mantissa = exponent >= 8 ? n >> (exponent - 8) : n << (8 - exponent);
  return Cost(exponent) * 256 + (mantissa - 256);
}

/// What symbols cost that occur so often, and to learn that they do.
inline Cost entropy_of(std::span<const std::uint64_t> counts) {
  std::uint64_t total = 0;
  for (const std::uint64_t n : counts) total += n;
  Cost cost = 0;
  for (const std::uint64_t n : counts)
    if (n > 0) cost += n * (log2_about(total) - log2_about(n)) + 1024;
  return cost;
}

/// What a sample costs, or something more than `most` if it costs more than that: K by its
/// difference to that of the number before, and what else there is.
template <class T>
Cost cost_of(const NumberSystem& s, const NumberSample<WordOf<T>>& sample, Cost most) {
  constexpr Cost of_stray = 256 * (8 * sizeof(T) + 12);
  return with_map<T>(s, Scalar::float64, [&](const auto& map) {
    using Map = std::decay_t<decltype(map)>;
    const Placing<T, Map> placing(s, map);
    std::array<std::uint64_t, 66> lengths = {};
    std::array<std::uint64_t, 16> choices = {};
    struct Seen {
      bool any;
      std::uint64_t k, choice;
    };
    std::vector<Seen> seen(has_refinements(s) ? 4096 : 1);
    Cost cost = 0;
    std::uint64_t before = 0;
    std::uint64_t least = ~std::uint64_t(0), greatest = 0;
    for (std::size_t i = 0; i < sample.words.size(); ++i) {
      const PlacedNumber p = placing.place(sample.words[i]);
      if (!p.exact) {
        cost += of_stray;
        if (cost > most) return cost;
        continue;
      }
      const std::uint64_t k = p.k - Placing<T, Map>::k_of_first;
      least = std::min(least, p.k);
      greatest = std::max(greatest, p.k);
      if (i % sample.run == 0) {
        before = k;
        if (cost > most) return cost;
      }
      const auto length = static_cast<unsigned>(std::bit_width(zigzag(k - before)));
      before = k;
      ++lengths[length];
      cost += length > 1 ? 256 * Cost(length - 1) : 0;
      if (!has_refinements(s)) continue;
      // The same integer with the same choice again says little.
      Seen& last = seen[(k * 0x9e3779b97f4a7c15u >> 32) % seen.size()];
      const bool again = last.any && last.k == k && last.choice == p.choice;
      last = {true, k, p.choice};
      if (again) {
        cost += 64;
        continue;
      }
      if constexpr (Map::has_choices) {
        const Choices all = map.choices(integer_of(s, k, 0));
        if (all.wide) ++choices[p.choice == 0];
        if (!all.wide || p.choice != 0) cost += log2_about(all.count);
      } else if (choices_of(s, map, integer_of(s, k, 0)).count > 1) {
        const auto bits = static_cast<unsigned>(std::bit_width(p.choice + 1) - 1) % 16;
        ++choices[bits];
        cost += bits > 1 ? 256 * Cost(bits - 1) : 0;
      }
    }
    // Some come from nowhere.
    const std::uint64_t range = greatest - std::min(least, greatest);
    cost += 256 * Cost(std::bit_width(range)) * (1 + sample.words.size() / 64);
    return cost + entropy_of(lengths) + entropy_of(choices);
  });
}

}  // namespace clers::internal

#endif

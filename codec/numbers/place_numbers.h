// Numbers -> their places in a system: integers, refinements, strays. For encoders.
#ifndef CLERS_CODEC_NUMBERS_PLACE_NUMBERS_H
#define CLERS_CODEC_NUMBERS_PLACE_NUMBERS_H

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "codec/numbers/number_format.h"
#include "codec/numbers/refinements.h"

namespace clers::internal {

/// Where one number is in a system.
struct PlacedNumber {
  std::uint64_t k;  ///< K, and a constant that makes it more than 0
  std::uint64_t choice;
  bool exact;  ///< else k is near, and the number a stray
};

/// Which K has the N that is nearest to n.
inline std::int64_t nearest_step(const NumberSystem& s, std::int64_t n) {
  const auto step = static_cast<std::int64_t>(s.step);
  if (step == 1) return n - s.first;
  const std::int64_t d = n - s.first + step / 2;
  return d / step - (d % step < 0);
}

/// Places numbers of type T, one by one.
template <class T, class Map>
class Placing {
 public:
  using U = WordOf<T>;
  static constexpr bool words = std::is_same_v<Map, WordMap<T>>;
  /// The k of N = first. Words are counted from the least one, which is `first`.
  static constexpr std::uint64_t k_of_first = words ? 0 : std::uint64_t(1) << 62;

  Placing(const NumberSystem& system, const Map& map)
      : s_(system), map_(map), most_(most_integer<T>(system)) {}

  PlacedNumber place(U bits) const {
    NumberPlace at = map_.locate(bits);
    if constexpr (words) {
      const std::uint64_t d = std::uint64_t(at.n) - std::uint64_t(s_.first);
      return {d / s_.step, 0, d % s_.step == 0};
    } else {
      const auto step = static_cast<std::int64_t>(s_.step);
      std::int64_t k = nearest_step(s_, std::clamp(at.n, -most_, most_));
      std::int64_t n = s_.first + k * step;
      if (n > most_) n -= step, --k;
      if (n < -most_) n += step, ++k;
      if (n > most_ || n < -most_) return {k_of_first, 0, false};
      return check(bits, k_of_first + static_cast<std::uint64_t>(k), n, n == at.n ? at.choice : 0);
    }
  }

 private:
  PlacedNumber check(U bits, std::uint64_t k, std::int64_t n, std::uint64_t choice) const {
    const U word = map_.word(n, choice);
    if constexpr (Map::has_choices) {
      return {k, choice, word == bits && choice < map_.choices(n).count};
    } else {
      if (word == bits) return {k, 0, true};
      if (s_.ulps > 0) {
        const U d = zigzag(static_cast<U>(key_of<T>(bits) - key_of<T>(word)));
        return {k, d, d <= 2u * s_.ulps};
      }
      return {k, 1, s_.signed_zero && magnitude(bits) == 0 && magnitude(word) == 0};
    }
  }

  const NumberSystem& s_;
  const Map& map_;
  std::int64_t most_;
};

/// Numbers that are no values of their system.
struct Stray {
  std::size_t index;
  std::uint64_t word;
};

/// The numbers of a component in its system.
struct PlacedColumn {
  NumberSystem system;                 ///< whose first is that of the least integer
  std::uint64_t top = 0;               ///< the greatest, its low bits included
  std::vector<std::uint64_t> ks;       ///< 0 .. top
  std::vector<std::uint64_t> choices;  ///< one for each k, or none at all
  std::vector<Stray> strays;
};

struct KRange {
  std::uint64_t least, greatest;
};

/// The range that integers have but for the few that are far out, if it is much smaller than all.
inline KRange usual_range(const std::vector<std::uint64_t>& ks, KRange all) {
  constexpr std::size_t most = 4096;
  std::vector<std::uint64_t> sample;
  for (std::size_t i = 0; i < ks.size(); i += 1 + ks.size() / most)
    sample.push_back(std::clamp(ks[i], all.least, all.greatest));
  std::sort(sample.begin(), sample.end());
  const std::size_t out = sample.size() / 1024;
  const std::uint64_t low = sample[out], high = sample[sample.size() - 1 - out];
  const std::uint64_t margin = (high - low) / 2;
  if (2 * margin + margin > most_narrow || margin > (all.greatest - all.least) / 64) return all;
  return {low - std::min(margin, low - all.least), high + std::min(margin, all.greatest - high)};
}

template <class T>
bool is_finite(WordOf<T> word) {
  if constexpr (std::is_floating_point_v<T>)
    return std::isfinite(std::bit_cast<T>(word));
  else
    return true;
}

/// Places all numbers of a component. Those that the system does not have are strays, and those far
/// out, where they alone would make integers wide. Cost: linear.
template <class T, class Map>
PlacedColumn place_column(std::span<const WordOf<T>> numbers, NumberSystem system, const Map& map) {
  using Place = Placing<T, Map>;
  PlacedColumn column;
  if (Place::words) {
    std::uint64_t least = numbers.empty() ? 0 : ~std::uint64_t(0);
    for (const auto word : numbers) least = std::min(least, std::uint64_t(key_of<T>(word)));
    system.first = static_cast<std::int64_t>(least);
  }
  const Place placing(system, map);
  const std::size_t count = numbers.size();
  column.ks.resize(count);
  if (has_refinements(system)) column.choices.resize(count);
  std::vector<std::uint8_t> exact(count);
  KRange range = {~std::uint64_t(0), 0};
  for (std::size_t i = 0; i < count; ++i) {
    const PlacedNumber p = placing.place(numbers[i]);
    column.ks[i] = p.k;
    exact[i] = p.exact;
    if (!p.exact) continue;
    range = {std::min(range.least, p.k), std::max(range.greatest, p.k)};
    if (!column.choices.empty()) column.choices[i] = p.choice;
  }
  if (range.least > range.greatest) range = {Place::k_of_first, Place::k_of_first};
  if (range.greatest - range.least > most_narrow) range = usual_range(column.ks, range);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t& k = column.ks[i];
    if (!exact[i] || k < range.least || k > range.greatest) {
      column.strays.push_back({i, numbers[i]});
      if (!column.choices.empty()) column.choices[i] = 0;
      // What lies near, so that others are predicted well
      k = is_finite<T>(numbers[i]) || i == 0 ? std::clamp(k, range.least, range.greatest)
                                             : column.ks[i - 1] + range.least;
    }
    k -= range.least;
  }
  column.top = range.greatest - range.least;
  system.first = static_cast<std::int64_t>(std::uint64_t(system.first) +
                                           (range.least - Place::k_of_first) * system.step);
  column.system = system;
  return column;
}

}  // namespace clers::internal

#endif

// Numbers -> their places in a system: integers, refinements, strays. For encoders.
#ifndef CLERS_CODEC_ATTRIBUTES_PLACE_NUMBERS_H
#define CLERS_CODEC_ATTRIBUTES_PLACE_NUMBERS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "codec/attributes/number_format.h"
#include "codec/attributes/refinements.h"

namespace clers::internal {

/// Where one number is in a system: K before `first` is the least, and the choice.
struct PlacedNumber {
  std::int64_t k;
  std::uint64_t choice;
  bool exact;  ///< else k is near, and the number a stray
};

/// Places numbers of type T, one by one.
template <class T, class Map>
class Placing {
 public:
  using U = WordOf<T>;
  Placing(const NumberSystem& system, const Map& map)
      : s_(system), map_(map), most_(internal::most_integer<T>(system)) {}

  PlacedNumber place(U bits) const {
    NumberPlace at = map_.locate(bits);
    if constexpr (std::is_same_v<Map, WordMap<T>>) {
      const std::uint64_t d = std::uint64_t(at.n) - std::uint64_t(s_.first);
      return {static_cast<std::int64_t>(d / s_.step), 0, d % s_.step == 0};
    } else {
      const std::int64_t n = std::clamp(at.n, -most_, most_),
                         step = static_cast<std::int64_t>(s_.step);
      std::int64_t k = floor_divide(n - s_.first + step / 2, step);
      std::int64_t on_step = s_.first + k * step;
      if (on_step > most_) on_step -= step, --k;
      if (on_step < -most_) on_step += step, ++k;
      if (on_step > most_ || on_step < -most_) return {0, 0, false};
      return check(bits, k, on_step, on_step == at.n ? at.choice : 0);
    }
  }

 private:
  static std::int64_t floor_divide(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0); }
  PlacedNumber check(U bits, std::int64_t k, std::int64_t n, std::uint64_t choice) const {
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

}  // namespace clers::internal

#endif

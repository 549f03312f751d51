// Numbers -> the nearest points of a grid, as numbers or as the integers of a number system that
// has these points.
#ifndef CLERS_CODEC_NUMBERS_MOVE_TO_GRID_H
#define CLERS_CODEC_NUMBERS_MOVE_TO_GRID_H

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "codec/base/difference.h"
#include "codec/base/portable.h"
#include "codec/numbers/floating_maps.h"
#include "codec/numbers/near_grid.h"
#include "codec/numbers/number_format.h"
#include "codec/numbers/number_maps.h"
#include "codec/numbers/outliers.h"
#include "codec/numbers/place_numbers.h"

namespace clers::internal {

/// So far from its origin a number may be: there doubles still tell all points of a grid apart.
inline constexpr double most_steps = double(std::int64_t(1) << 50);

/// What a number is to maps: a float, or a whole number of any type.
template <class T>
using NumberType = std::conditional_t<std::is_floating_point_v<T>, T, Whole>;

template <class T>
WordOf<NumberType<T>> word_of(T x) {
  if constexpr (std::is_floating_point_v<T>)
    return std::bit_cast<WordOf<T>>(x);
  else
    return static_cast<std::make_unsigned_t<T>>(x) ^ key_mask(scalar_of<T>());
}
template <class T>
T number_of(WordOf<NumberType<T>> word) {
  if constexpr (std::is_floating_point_v<T>)
    return std::bit_cast<T>(word);
  else
    return static_cast<T>(static_cast<std::make_unsigned_t<T>>(word ^ key_mask(scalar_of<T>())));
}

/// Calls use with a function that gives point k of a grid.
template <class T, class Use>
auto with_points(const NumberSystem& system, Use use) {
  const auto step = static_cast<std::int64_t>(system.step);
  return with_map<NumberType<T>>(system, scalar_of<T>(), [&](const auto& map) {
    return use([step, &map](std::int64_t k) { return number_of<T>(map.word(k * step, 0)); });
  });
}

/// The point of a grid that is nearest to a number, the lower of two. `k` is near it, and
/// `error` how far off.
template <class T, class Points>
std::int64_t nearest_point(T x, std::int64_t k, const Points& point, double& error) {
  for (const std::int64_t way : {-1, 1})
    for (;;) {
      const double other = difference(x, point(k + way));
      if (!(other < error || (way < 0 && other == error && point(k + way) < point(k)))) break;
      k += way;
      error = other;
    }
  return k;
}

/// No other point is as near as one that is nearer than this.
inline double surely_nearest(const Grid& grid) {
  return 0.49 * grid.step;
}

struct Moved {
  double error = 0;                         ///< the largest difference
  std::optional<std::size_t> too_far = {};  ///< the first number that is too far away
};

/// Where the numbers of a component go: rows of numbers, or of integers.
template <class T>
struct Column {
  std::byte* first;
  std::size_t stride;

  void set(std::size_t i, T x) const { std::memcpy(first + i * stride, &x, sizeof(T)); }
};

/// Moves the numbers of a component to a grid.
template <class T>
Moved move_to(const std::vector<T>& numbers, const Grid& grid, bool keep_zeros,
              const NumberSystem& system, const Column<T>& to) {
  Moved moved;
  const double sure = surely_nearest(grid);
  with_points<T>(system, [&](const auto& point) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const T x = numbers[i];
      const double k = (static_cast<double>(x) - grid.origin) / grid.step;
      if (!(std::fabs(k) < most_steps)) {
        moved.too_far = i;
        return;
      }
      const std::int64_t near = nearest_integer(k);
      T y = point(near);
      double error = difference(x, y);
      if (!(error <= sure)) y = point(nearest_point(x, near, point, error));
      to.set(i, keep_zeros && x == y ? x : y);
      moved.error = std::max(moved.error, error);
    }
  });
  return moved;
}

/// Whether all numbers are on a grid.
template <class T>
bool all_on(const std::vector<T>& numbers, const Grid& grid, const NumberSystem& system) {
  return with_points<T>(system, [&](const auto& point) {
    return std::all_of(numbers.begin(), numbers.end(), [&](T x) {
      const double k = (static_cast<double>(x) - grid.origin) / grid.step;
      return std::fabs(k) < most_steps && point(nearest_integer(k)) == x;
    });
  });
}

// As integers, numbers are moved without a look at the bits that come out: what they are decoded to
// is what the map makes of the integers. But the map must give different numbers for different
// integers, so that the same values are never coded in two ways.

/// Integers may be as large, so that differences are narrow.
inline constexpr std::int32_t most_handed_on = most_narrow / 2;

/// Whether integers say all of numbers on a grid: points are further apart than what their type
/// rounds, and no -0 stays.
template <class T>
bool is_plain(const std::vector<T>& numbers, const Bounds<T>& bounds, const Grid& grid,
              bool keep_zeros) {
  if (!(grid.step > 8 * double(std::numeric_limits<T>::epsilon()) * bounds.largest())) return false;
  for (const T bound : {bounds.least, bounds.greatest})
    if (!(std::fabs((static_cast<double>(bound) - grid.origin) / grid.step) < most_handed_on - 1))
      return false;
  return !keep_zeros || std::none_of(numbers.begin(), numbers.end(),
                                     [](T x) { return x == 0 && std::signbit(x); });
}

/// Moves numbers to a grid, as integers of its system. Returns the largest difference.
/// Precondition: is_plain(..), and the system is a quotient or affine.
template <class T>
double move_to_integers(const std::vector<T>& numbers, const Grid& grid, const NumberSystem& system,
                        const Column<std::int32_t>& to) {
  const double sure = surely_nearest(grid), origin = grid.origin, length = grid.step,
               step = static_cast<double>(static_cast<std::int64_t>(system.step));
  double largest = 0;
  // Few at a time, so that the first loop has no branches, and becomes one of vectors.
  constexpr std::size_t most = 128;
  std::array<std::int32_t, most> ks;
  std::array<double, most> errors;
  const auto move_with = [&](const auto& map) {
    const auto point = [&](std::int64_t k) {
      return std::bit_cast<T>(map.at(static_cast<double>(k) * step));
    };
    for (std::size_t begin = 0; begin < numbers.size(); begin += most) {
      const std::size_t count = std::min(most, numbers.size() - begin);
      const T* const x = numbers.data() + begin;
      for (std::size_t i = 0; i < count; ++i) {
        const double k = (static_cast<double>(x[i]) - origin) / length;
        ks[i] = static_cast<std::int32_t>(k + std::copysign(.5, k));
        errors[i] = std::fabs(static_cast<double>(x[i]) - static_cast<double>(point(ks[i])));
      }
      double all = 0;
      for (std::size_t i = 0; i < count; ++i) all = errors[i] > all ? errors[i] : all;
      for (std::size_t i = 0; all > sure && i < count; ++i)
        if (errors[i] > sure)
          ks[i] = static_cast<std::int32_t>(nearest_point(x[i], ks[i], point, errors[i]));
      for (std::size_t i = 0; i < count; ++i) to.set(begin + i, ks[i]);
      for (std::size_t i = 0; all > largest && i < count; ++i)
        largest = std::max(largest, errors[i]);
    }
  };
  if (system.map == NumberMap::quotient)
    move_with(QuotientMap<T>(system, scalar_of<T>()));
  else
    move_with(AffineMap<T>(system, scalar_of<T>()));
  return largest;
}

/// The integers of numbers in a system that they are all in. None if these do not say all of them,
/// or are too large.
template <class T>
bool place_all(const std::vector<T>& numbers, const NumberSystem& system,
               const Column<std::int32_t>& to) {
  if (has_refinements(system)) return false;
  return with_map<T>(system, scalar_of<T>(), [&](const auto& map) {
    using Place = Placing<T, std::decay_t<decltype(map)>>;
    const Place placing(system, map);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const PlacedNumber p = placing.place(word_of(numbers[i]));
      const auto k = static_cast<std::int64_t>(p.k - Place::k_of_first);
      if (!p.exact || std::abs(k) > most_handed_on) return false;
      to.set(i, static_cast<std::int32_t>(k));
    }
    return true;
  });
}

}  // namespace clers::internal

#endif

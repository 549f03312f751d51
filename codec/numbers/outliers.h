// Values far from all others, for which the grid of a bounding box is coarse. Knows numbers alone.
#ifndef CLERS_CODEC_NUMBERS_OUTLIERS_H
#define CLERS_CODEC_NUMBERS_OUTLIERS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "codec/base/difference.h"

namespace clers::internal {

/// A few values that make the grid of all others coarse.
struct Outliers {
  std::uint64_t farthest = 0;  ///< which value
  int bits = 0;                ///< that are as good without them
};

template <class T>
struct Bounds {
  T least = 0, greatest = 0;

  double range() const { return difference(least, greatest); }
  double largest() const {
    return std::max(std::fabs(static_cast<double>(least)),
                    std::fabs(static_cast<double>(greatest)));
  }
};

/// Precondition: there are numbers, and all are finite.
template <class T>
Bounds<T> bounds_of(const std::vector<T>& numbers) {
  // Several at a time, which do not wait for each other.
  constexpr std::size_t lanes = 8;
  std::array<T, lanes> least, greatest;
  least.fill(numbers.front());
  greatest.fill(numbers.front());
  std::size_t i = 0;
  for (; i + lanes <= numbers.size(); i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) {
      const T x = numbers[i + k];
      least[k] = x < least[k] ? x : least[k];
      greatest[k] = x > greatest[k] ? x : greatest[k];
    }
  for (; i < numbers.size(); ++i) {
    least[0] = std::min(least[0], numbers[i]);
    greatest[0] = std::max(greatest[0], numbers[i]);
  }
  return {*std::min_element(least.begin(), least.end()),
          *std::max_element(greatest.begin(), greatest.end())};
}

/// What is left of the range without the `few` least and the `few` greatest numbers.
template <class T>
Bounds<T> bounds_without(std::vector<T> numbers, std::size_t few) {
  const auto low = numbers.begin() + static_cast<std::ptrdiff_t>(few),
             high = numbers.end() - 1 - static_cast<std::ptrdiff_t>(few);
  std::nth_element(numbers.begin(), low, numbers.end());
  const T least = *low;
  std::nth_element(low, high, numbers.end());
  return {least, *high};
}

/// Whether more than a few numbers are below the third eighth of their range, and above the fifth:
/// then the range is not four times as long as that without the few least and greatest.
template <class T>
bool is_spread(const std::vector<T>& numbers, const Bounds<T>& bounds, std::size_t few) {
  const double low = static_cast<double>(bounds.least) + 0.37 * bounds.range(),
               high = static_cast<double>(bounds.greatest) - 0.37 * bounds.range();
  std::size_t below = 0, above = 0;
  for (const T x : numbers) {
    below += static_cast<double>(x) <= low;
    above += static_cast<double>(x) >= high;
  }
  return below > few && above > few;
}

/// A thousandth of the values, or one, that make the longest side four times as long, or more.
template <class T>
std::optional<Outliers> outliers_of(const std::vector<std::vector<T>>& numbers,
                                    const std::vector<Bounds<T>>& bounds, double longest,
                                    int bits) {
  const std::size_t count = numbers[0].size(), few = std::max<std::size_t>(1, count / 1000);
  if (count < 16 || longest == 0) return std::nullopt;
  for (std::size_t c = 0; c < numbers.size(); ++c)
    if (bounds[c].range() == longest && is_spread(numbers[c], bounds[c], few)) return std::nullopt;
  std::vector<Bounds<T>> without;
  double side = 0;
  for (const std::vector<T>& component : numbers) {
    without.push_back(bounds_without(component, few));
    side = std::max(side, without.back().range());
  }
  if (longest < 4 * side) return std::nullopt;
  Outliers found;
  double farthest = 0;
  for (std::size_t c = 0; c < numbers.size(); ++c)
    for (std::size_t i = 0; i < count; ++i) {
      const T x = numbers[c][i];
      const double beyond = x < without[c].least      ? difference(x, without[c].least)
                            : x > without[c].greatest ? difference(x, without[c].greatest)
                                                      : 0;
      if (beyond <= farthest) continue;
      farthest = beyond;
      found.farthest = i;
    }
  found.bits = bits;
  for (double saved = longest; found.bits > 0 && saved >= 2 * side; saved /= 2) --found.bits;
  return found;
}

}  // namespace clers::internal

#endif

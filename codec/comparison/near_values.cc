// Both meshes' numbers, sorted, and gone through together.
//
//     first      x     x        x               x
//     second       x     x          x         x
//                \_____________/    |         \__/      linked: a gap that no link spans parts them
//
// Links that span a gap exist if the nearest two of different meshes on its two sides are linked,
// since a difference never falls where two numbers move apart.
#include "codec/comparison/near_values.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "codec/base/difference.h"

namespace clers::internal {
namespace {

template <class T>
bool is_nan(T x) {
  if constexpr (std::is_floating_point_v<T>) return std::isnan(x);
  return false;
}

/// NaNs come last.
template <class T>
bool less(T x, T y) {
  return is_nan(x) != is_nan(y) ? is_nan(y) : x < y;
}

/// Numbers and whose they are, ascending.
template <class T>
using Sorted = std::vector<std::pair<T, std::uint32_t>>;

template <class T>
Sorted<T> sorted_numbers(const Attribute& a, std::size_t component) {
  Sorted<T> sorted(a.data.size() / a.stride());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    std::memcpy(&sorted[i].first, a.data.data() + i * a.stride() + component * sizeof(T),
                sizeof(T));
    sorted[i].second = static_cast<std::uint32_t>(i);
  }
  std::sort(sorted.begin(), sorted.end(),
            [](const auto& x, const auto& y) { return less(x.first, y.first); });
  return sorted;
}

template <class T>
void add_linked(const Sorted<T>& a, const Sorted<T>& b, double tolerance,
                std::vector<Colour>& colours_a, std::vector<Colour>& colours_b) {
  const auto linked = [&](const Sorted<T>& x, std::size_t i, const Sorted<T>& y, std::size_t j) {
    return i > 0 && j < y.size() && difference(x[i - 1].first, y[j].first) <= tolerance;
  };
  Colour group = 0;
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    group += !linked(a, i, b, j) && !linked(b, j, a, i);
    const bool first = j == b.size() || (i < a.size() && !less(b[j].first, a[i].first));
    Colour& colour = first ? colours_a[a[i++].second] : colours_b[b[j++].second];
    colour = combine(colour, group);
  }
}

template <class T>
void add_nearest(const Sorted<T>& a, const Sorted<T>& b, bool greater,
                 std::vector<Colour>& colours_a, std::vector<Colour>& colours_b) {
  std::vector<std::pair<T, Colour>> distinct;
  for (const auto& [number, i] : b) {
    if (distinct.empty() || less(distinct.back().first, number))
      distinct.push_back({number, distinct.size()});
    colours_b[i] = combine(colours_b[i], distinct.back().second);
  }
  std::size_t j = 0;
  for (const auto& element : a) {
    const auto closer = [&](std::size_t next) {
      if (next >= distinct.size()) return false;
      const double here = difference(element.first, distinct[j].first),
                   there = difference(element.first, distinct[next].first);
      return there < here || (greater && there == here);
    };
    while (closer(j + 1)) ++j;
    Colour& colour = colours_a[element.second];
    colour = combine(colour, j);
  }
}

}  // namespace

void add_near_values(const Attribute& a, const Attribute& b, std::size_t component,
                     double tolerance, Nearness nearness, std::vector<Colour>& colours_a,
                     std::vector<Colour>& colours_b) {
  with_type(a.scalar, [&](auto type) {
    using T = decltype(type);
    const Sorted<T> first = sorted_numbers<T>(a, component),
                    second = sorted_numbers<T>(b, component);
    if (nearness == Nearness::linked)
      add_linked(first, second, tolerance, colours_a, colours_b);
    else
      add_nearest(first, second, nearness == Nearness::nearest_or_greater, colours_a, colours_b);
  });
}

}  // namespace clers::internal

// What a component of a value of any name is predicted to be, by what is known nearby.
#ifndef CLERS_CODEC_ATTRIBUTES_NAMED_PREDICTION_H
#define CLERS_CODEC_ATTRIBUTES_NAMED_PREDICTION_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/attributes/known_values.h"
#include "codec/attributes/named_model.h"

namespace clers::internal {

/// n / d rounded down. Precondition: d > 0.
inline std::int64_t floor_of(std::int64_t n, std::int64_t d) {
  return n / d - (n % d < 0);
}

/// The mean of the neighbours in one component, rounded, halves up; where that might overflow, near
/// it. Every width-th integer is one of that component, in 0 .. top. Precondition: there are some.
template <class Int>
std::int64_t mean_around(std::span<const Int> component, std::size_t width, std::uint64_t top,
                         const Nearby& nearby) {
  const auto get = [&](std::size_t i) -> std::int64_t {
    return component[nearby.around[i] * width];
  };
  const std::int64_t first = get(0);
  const auto count = static_cast<std::int64_t>(nearby.count);
  std::int64_t sum = 0;
  if (sizeof(Int) == 4 || top < std::uint64_t(1) << 56) {
    for (std::size_t i = 1; i < nearby.count; ++i) sum += get(i) - first;
    return first + floor_of(2 * sum + count, 2 * count);
  }
  for (std::size_t i = 1; i < nearby.count; ++i) sum += (get(i) - first) / count;
  return first + sum;
}

/// What a component is predicted to be: within -top .. 2 top. As mean_around.
template <class Int>
std::int64_t predict_named(NamedPredictor predictor, std::span<const Int> component,
                           std::size_t width, std::uint64_t top, const Nearby& nearby) {
  const auto get = [&](std::uint32_t v) -> std::int64_t { return component[v * width]; };
  if (nearby.count == 0 || predictor <= NamedPredictor::before)
    return nearby.before == Nearby::none ? 0 : get(nearby.before);
  if (nearby.c == Nearby::none || predictor == NamedPredictor::mean)
    return mean_around(component, width, top, nearby);
  const std::int64_t a = get(nearby.a), b = get(nearby.b), corner = a + b - get(nearby.c);
  if (predictor == NamedPredictor::parallelogram) return corner;
  return std::clamp(corner, std::min(a, b), std::max(a, b));
}

}  // namespace clers::internal

#endif

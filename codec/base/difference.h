// How far two numbers of one type are apart: one meaning of it for who states an error, and for who
// looks whether it is true.
#ifndef CLERS_CODEC_BASE_DIFFERENCE_H
#define CLERS_CODEC_BASE_DIFFERENCE_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "codec/scalar.h"

namespace clers::internal {

/// |a - b|, rounded to the nearest double (DoublePrecision, portable.h): so it never falls where
/// they move apart. NaNs are 0 apart, and infinitely far from all else, as infinities are from what
/// is not the same one.
template <class T>
double difference(T a, T b) {
  if (a == b) return 0;
  if constexpr (std::is_floating_point_v<T>) {
    if (std::isnan(a) && std::isnan(b)) return 0;
    const double d = std::fabs(static_cast<double>(a) - static_cast<double>(b));
    return std::isnan(d) ? std::numeric_limits<double>::infinity() : d;
  } else {
    const auto x = static_cast<std::uint64_t>(a), y = static_cast<std::uint64_t>(b);
    return static_cast<double>(a > b ? x - y : y - x);
  }
}

/// The largest difference of so many numbers of a type, packed.
inline double difference(Scalar scalar, const std::byte* a, const std::byte* b,
                         std::size_t components) {
  return with_type(scalar, [&](auto type) {
    using T = decltype(type);
    double largest = 0;
    for (std::size_t c = 0; c < components; ++c) {
      T x, y;
      std::memcpy(&x, a + c * sizeof(T), sizeof(T));
      std::memcpy(&y, b + c * sizeof(T), sizeof(T));
      largest = std::max(largest, difference(x, y));
    }
    return largest;
  });
}

}  // namespace clers::internal

#endif

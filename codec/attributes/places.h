// Where values are, in small integers: the position of each vertex on a grid of 2^20 steps along
// the longest side. Geometry that only guides a prediction is computed from these, so that it is
// the same on every machine, whatever type positions have. Knows no surface.
#ifndef CLERS_CODEC_ATTRIBUTES_PLACES_H
#define CLERS_CODEC_ATTRIBUTES_PLACES_H

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "codec/mesh.h"
#include "codec/scalar.h"

namespace clers::internal {

inline constexpr unsigned place_bits = 20;

/// Three coordinates below 2^place_bits.
using GridPlace = std::array<std::int32_t, 3>;

/// Coordinates as integers of 60 bits and a sign, to one scale: floats by the powers of two that
/// hold the largest, toward zero; what is not finite is 0.
template <class T>
class PlaceUnits {
 public:
  explicit PlaceUnits(const std::vector<std::byte>& data) {
    if constexpr (std::is_floating_point_v<T>) {
      double most = 0;
      T x;
      for (std::size_t i = 0; i + sizeof(T) <= data.size(); i += sizeof(T)) {
        std::memcpy(&x, data.data() + i, sizeof(T));
        const double size = std::abs(static_cast<double>(x));
        if (size <= std::numeric_limits<double>::max()) most = std::max(most, size);
      }
      // The exponent is between those of doubles whose inverses are normal ones too.
      const auto exponent =
          static_cast<int>(std::bit_cast<std::uint64_t>(most) >> 52) - 1022;  // most < 2^exponent
      shift_ = 60 - std::max(exponent, -900);
      factor_ = std::ldexp(1.0, std::clamp(shift_, -1000, 1000));
    }
  }
  std::int64_t operator()(const std::byte* at) const {
    T x;
    std::memcpy(&x, at, sizeof(T));
    if constexpr (std::is_floating_point_v<T>) {
      const double scaled = static_cast<double>(x) * factor_;
      const bool finite = std::abs(scaled) <= 0x1p60;
      return finite ? static_cast<std::int64_t>(scaled) : 0;
    } else if constexpr (sizeof(T) == 8) {
      return static_cast<std::int64_t>(x >> 3);
    } else {
      return static_cast<std::int64_t>(x);
    }
  }

 private:
  int shift_ = 0;
  double factor_ = 1;
};

/// The places of all vertices that have positions. Cost: linear.
inline std::vector<GridPlace> places_of(const Attribute* position) {
  if (position == nullptr) return {};
  const std::size_t used = std::min<std::size_t>(position->components, 3);
  const std::size_t stride = position->stride(), size = size_of(position->scalar);
  const std::size_t count = position->value_count();
  std::vector<GridPlace> places(count);
  with_type(position->scalar, [&](auto type) {
    const PlaceUnits<decltype(type)> units(position->data);
    std::array<std::int64_t, 3> low, high;
    low.fill(std::numeric_limits<std::int64_t>::max());
    high.fill(std::numeric_limits<std::int64_t>::min());
    for (std::size_t v = 0; v < count; ++v)
      for (std::size_t c = 0; c < used; ++c) {
        const std::int64_t x = units(position->data.data() + v * stride + c * size);
        low[c] = std::min(low[c], x);
        high[c] = std::max(high[c], x);
      }
    std::int64_t longest = 0;
    for (std::size_t c = 0; c < used && count > 0; ++c)
      longest = std::max(longest, high[c] - low[c]);
    const int down = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(longest))) -
                     static_cast<int>(place_bits);
    for (std::size_t v = 0; v < count; ++v)
      for (std::size_t c = 0; c < used; ++c) {
        const std::int64_t x = units(position->data.data() + v * stride + c * size) - low[c];
        places[v][c] = static_cast<std::int32_t>(down >= 0 ? x >> down : x << -down);
      }
  });
  return places;
}

inline std::uint64_t places_memory(std::uint64_t vertices) {
  return vertices * sizeof(GridPlace);
}

}  // namespace clers::internal

#endif

// The maps of number systems: integers <-> the bits of numbers.
//
// Each has both directions. word(n, choice) is the definition, the same on every machine. locate()
// is a guess of its inverse, which the encoder checks by word(): it may be wrong, not unsafe.
#ifndef CLERS_CODEC_ATTRIBUTES_NUMBER_MAPS_H
#define CLERS_CODEC_ATTRIBUTES_NUMBER_MAPS_H

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "codec/attributes/number_system.h"
#include "codec/attributes/transform.h"

namespace clers::internal {

/// Integers up to it are doubles.
inline constexpr std::int64_t most_exact = std::int64_t(1) << 53;

/// Powers of ten that are doubles.
inline constexpr unsigned most_tens = 22;
inline constexpr std::array<double, most_tens + 1> tens = {
    1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
/// Those that are std::uint64_t.
inline constexpr unsigned most_integer_tens = 19;
inline constexpr auto integer_tens = [] {
  std::array<std::uint64_t, most_integer_tens + 1> powers = {1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 10 * powers[i - 1];
  return powers;
}();

/// The number m * 10^e, if |e| <= most_tens and m <= most_exact: one correctly rounded operation.
inline double times_ten_to(std::uint64_t m, int e) {
  const double v = static_cast<double>(static_cast<std::int64_t>(m));
  return e < 0 ? v / tens[static_cast<unsigned>(-e)] : v * tens[static_cast<unsigned>(e)];
}

/// The unsigned integer that has the size of T.
template <class T>
using WordOf = std::conditional_t<
    sizeof(T) == 1, std::uint8_t,
    std::conditional_t<sizeof(T) == 2, std::uint16_t,
                       std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;

/// An unsigned integer that sorts like the number with these bits.
template <class T>
WordOf<T> key_of(WordOf<T> bits) {
  using U = WordOf<T>;
  if constexpr (std::is_floating_point_v<T>)
    return to_ordered(bits);
  else if constexpr (std::is_signed_v<T>)
    return static_cast<U>(bits ^ U(1) << (std::numeric_limits<U>::digits - 1));
  else
    return bits;
}
/// Undoes key_of.
template <class T>
WordOf<T> of_key(WordOf<T> key) {
  if constexpr (std::is_floating_point_v<T>)
    return from_ordered(key);
  else
    return key_of<T>(key);
}

/// The bits of a number without its sign.
template <class U>
U magnitude(U bits) {
  return static_cast<U>(bits << 1) >> 1;
}

inline std::uint64_t absolute(std::int64_t n) {
  return n < 0 ? -static_cast<std::uint64_t>(n) : static_cast<std::uint64_t>(n);
}

/// The integer nearest to a number, or to the bound of the exact ones.
inline std::int64_t nearest_integer(double v) {
  if (!(v < double(most_exact))) return most_exact;
  if (v <= -double(most_exact)) return -most_exact;
  return static_cast<std::int64_t>(v < 0 ? v - .5 : v + .5);
}

/// Where a number is: an integer, and which of those that it stands for.
struct NumberPlace {
  std::int64_t n;
  std::uint64_t choice;
};

/// Maps without choices.
struct PlainMap {
  static constexpr bool has_choices = false;
};
/// Maps with choices have choices(n): how many numbers n stands for. If `wide`, 0 of them is
/// likely.
struct Choices {
  std::uint64_t count;
  bool wide;
};

template <class T>
struct WordMap : PlainMap {
  using U = WordOf<T>;
  explicit WordMap(const NumberSystem&) {}
  U word(std::int64_t n, std::uint64_t) const { return of_key<T>(static_cast<U>(n)); }
  NumberPlace locate(U bits) const {
    return {static_cast<std::int64_t>(std::uint64_t(key_of<T>(bits))), 0};
  }
};

template <class T>
struct QuotientMap : PlainMap {
  using U = WordOf<T>;
  explicit QuotientMap(const NumberSystem& s) : divisor(double(s.divisor)) {}
  U word(std::int64_t n, std::uint64_t) const {
    return std::bit_cast<U>(static_cast<T>(double(n) / divisor));
  }
  NumberPlace locate(U bits) const {
    return {nearest_integer(double(std::bit_cast<T>(bits)) * divisor), 0};
  }
  double divisor;
};

/// The number of type T that is nearest to v. Integers: halves up, and none beyond the last.
template <class T>
T nearest_number(double v) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(v);
  } else {
    using Limits = std::numeric_limits<T>;
    v = std::floor(v + .5);
    if (v >= 2. * double(std::uint64_t(1) << (Limits::digits - 1))) return Limits::max();
    if (!(v > double(Limits::min()))) return Limits::min();
    return static_cast<T>(v);
  }
}

template <class T>
struct AffineMap : PlainMap {
  using U = WordOf<T>;
  explicit AffineMap(const NumberSystem& s) : origin(s.origin), length(s.length) {}
  double value(std::int64_t n) const { return origin + double(n) * length; }
  U word(std::int64_t n, std::uint64_t) const {
    return std::bit_cast<U>(nearest_number<T>(value(n)));
  }
  NumberPlace locate(U bits) const {
    return {nearest_integer((double(std::bit_cast<T>(bits)) - origin) / length), 0};
  }
  double origin, length;
};

}  // namespace clers::internal

#endif

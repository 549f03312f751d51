// The maps of number systems: integers <-> the bits of numbers.
//
// Each has both directions. word(n, choice) is the definition, the same on every machine. locate()
// is a guess of its inverse, which the encoder checks by word(): it may be wrong, not unsafe.
#ifndef CLERS_CODEC_NUMBERS_NUMBER_MAPS_H
#define CLERS_CODEC_NUMBERS_NUMBER_MAPS_H

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "codec/numbers/number_system.h"
#include "codec/numbers/transform.h"

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

/// Stands for all types of integers, as float and double do for themselves.
struct Whole {};

/// What the bits of a number are kept in. Integers have 64 of them, which sort like the numbers,
/// from 0 on: see key_mask.
template <class T>
using WordOf = std::conditional_t<std::is_same_v<T, float>, std::uint32_t, std::uint64_t>;

/// Returns use(T()) with float, double or Whole.
template <class Use>
auto with_number_type(Scalar scalar, Use&& use) {
  if (scalar == Scalar::float32) return use(float{});
  if (scalar == Scalar::float64) return use(double{});
  return use(Whole{});
}

/// What makes an integer that sorts of the bits of a signed one, and the other way round.
inline std::uint64_t key_mask(Scalar scalar) {
  const bool is_signed = !is_float(scalar) && static_cast<unsigned>(scalar) % 2 == 0;
  return is_signed ? std::uint64_t(1) << (8 * size_of(scalar) - 1) : 0;
}

/// An unsigned integer that sorts like the number with these bits.
template <class T>
WordOf<T> key_of(WordOf<T> bits) {
  if constexpr (std::is_floating_point_v<T>)
    return to_ordered(bits);
  else
    return bits;
}
/// Undoes key_of.
template <class T>
WordOf<T> of_key(WordOf<T> key) {
  if constexpr (std::is_floating_point_v<T>)
    return from_ordered(key);
  else
    return key;
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
  WordMap(const NumberSystem&, Scalar) {}
  U word(std::int64_t n, std::uint64_t) const { return of_key<T>(static_cast<U>(n)); }
  NumberPlace locate(U bits) const {
    return {static_cast<std::int64_t>(std::uint64_t(key_of<T>(bits))), 0};
  }
};

template <class T>
struct QuotientMap : PlainMap {
  using U = WordOf<T>;
  QuotientMap(const NumberSystem& s, Scalar) : divisor(double(s.divisor)) {}
  U at(double n) const { return std::bit_cast<U>(static_cast<T>(n / divisor)); }
  U word(std::int64_t n, std::uint64_t) const { return at(double(n)); }
  NumberPlace locate(U bits) const {
    return {nearest_integer(double(std::bit_cast<T>(bits)) * divisor), 0};
  }
  double divisor;
};

template <class T>
struct AffineMap : PlainMap {
  using U = WordOf<T>;
  AffineMap(const NumberSystem& s, Scalar) : origin(s.origin), length(s.length), single(s.single) {}
  U at(double n) const {
    const double product = n * length;
    return std::bit_cast<U>(
        static_cast<T>(origin + (single ? double(static_cast<float>(product)) : product)));
  }
  U word(std::int64_t n, std::uint64_t) const { return at(double(n)); }
  NumberPlace locate(U bits) const {
    return {nearest_integer((double(std::bit_cast<T>(bits)) - origin) / length), 0};
  }
  double origin, length;
  bool single;
};

/// To integers: halves up, and none beyond the first or last of the type.
template <>
struct AffineMap<Whole> : PlainMap {
  using U = std::uint64_t;
  AffineMap(const NumberSystem& s, Scalar scalar)
      : origin(s.origin),
        length(s.length),
        zero(key_mask(scalar)),
        last(~std::uint64_t(0) >> (64 - 8 * size_of(scalar))),
        beyond(double(last - zero) + 1) {}
  U word(std::int64_t n, std::uint64_t) const {
    const double v = std::floor(origin + double(n) * length + .5);
    if (v >= beyond) return last;
    if (v >= 0) return zero + static_cast<U>(v);
    return -v >= double(zero) ? 0 : zero - static_cast<U>(-v);
  }
  NumberPlace locate(U bits) const {
    const double v = bits < zero ? -double(zero - bits) : double(bits - zero);
    return {nearest_integer((v - origin) / length), 0};
  }
  double origin, length;
  U zero, last;  ///< what 0 and the last are
  double beyond;
};

}  // namespace clers::internal

#endif

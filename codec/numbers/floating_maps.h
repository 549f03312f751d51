// Maps of numbers with significant digits: decimal ones, binary ones, and printed ones.
//
// With P significant digits, the numbers of the top decade are multiples of one unit. Smaller ones
// have more digits below the unit: N is the number cut to units, and a choice those digits.
//
//     P = 4, unit 0.01:    12.34  ->  N = 1234
//                          1.234  ->  N = 123, choice 4 of 10
//                         0.1234  ->  N = 12, choice 34 of 100
//
// How many digits N has says how many there are below. N = 0 says neither sign nor decade: there
// the choice is the number itself, of all those below the unit.
#ifndef CLERS_CODEC_NUMBERS_FLOATING_MAPS_H
#define CLERS_CODEC_NUMBERS_FLOATING_MAPS_H

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "codec/numbers/number_maps.h"

namespace clers::internal {

/// How many decimal digits m has, none if it is 0.
inline unsigned decimal_digits(std::uint64_t m) {
  const unsigned least = static_cast<unsigned>(std::bit_width(m)) * 1233 >> 12;  // bits * log10(2)
  return least + (m >= integer_tens[least]);
}

/// Choices of N = 0: numbers with a magnitude below that of the unit, first 0, then -0.
template <class U>
struct BelowUnit {
  U limit = 0;  ///< the magnitude of the unit

  Choices choices() const { return {2 * std::uint64_t(limit), true}; }
  U word(std::uint64_t choice) const {
    constexpr unsigned to_sign = std::numeric_limits<U>::digits - 1;
    return static_cast<U>(static_cast<U>(choice >> 1) | static_cast<U>(choice & 1) << to_sign);
  }
  std::uint64_t choice(U bits) const {
    constexpr unsigned to_sign = std::numeric_limits<U>::digits - 1;
    return 2 * std::uint64_t(magnitude(bits)) | bits >> to_sign;
  }
};

/// Decimal digits.
template <class T>
struct DigitsMap {
  using U = WordOf<T>;
  static constexpr bool has_choices = true;
  static constexpr unsigned most_digits = 15;

  DigitsMap(const NumberSystem& s, Scalar) : precision(s.precision), exponent(s.exponent) {
    below.limit = std::bit_cast<U>(static_cast<T>(times_ten_to(1, exponent)));
  }
  unsigned more_digits(std::uint64_t m) const {
    const unsigned digits = decimal_digits(m);
    if (digits >= precision) return 0;
    return std::min(precision - digits, static_cast<unsigned>(exponent + int(most_tens)));
  }
  Choices choices(std::int64_t n) const {
    if (n == 0) return below.choices();
    return {integer_tens[more_digits(absolute(n))], false};
  }
  U word(std::int64_t n, std::uint64_t choice) const {
    if (n == 0) return below.word(choice);
    const std::uint64_t m = absolute(n);
    const unsigned more = more_digits(m);
    const double v = times_ten_to(m * integer_tens[more] + choice, exponent - int(more));
    return std::bit_cast<U>(static_cast<T>(n < 0 ? -v : v));
  }
  NumberPlace locate(U bits) const {
    const double v = std::fabs(double(std::bit_cast<T>(bits)));
    if (magnitude(bits) < below.limit) return {0, below.choice(bits)};
    if (!(v < tens[22])) return {nearest_integer(v), 0};
    // The cut at the unit may be one too low, where rounding makes the last digit 10.
    std::uint64_t m = static_cast<std::uint64_t>(
        std::min<std::int64_t>(nearest_integer(v / times_ten_to(1, exponent) - .5), most_exact));
    NumberPlace place = {0, 0};
    for (m = std::max<std::uint64_t>(m, 1);; ++m) {
      const unsigned more = more_digits(m);
      const int e = exponent - int(more);
      const double scaled =
          e < 0 ? v * tens[static_cast<unsigned>(-e)] : v / tens[static_cast<unsigned>(e)];
      const auto all = static_cast<std::uint64_t>(nearest_integer(scaled));
      place = {static_cast<std::int64_t>(all / integer_tens[more]), all % integer_tens[more]};
      if (more_digits(static_cast<std::uint64_t>(place.n)) >= more) break;
    }
    if (bits != magnitude(bits)) place.n = -place.n;
    return place;
  }

  unsigned precision;
  int exponent;
  BelowUnit<U> below;
};

/// Binary digits: floats as they are.
template <class T>
struct BinaryMap {
  using U = WordOf<T>;
  static constexpr bool has_choices = true;
  using Limits = std::numeric_limits<T>;
  static constexpr int least_exponent = Limits::min_exponent - Limits::digits;  ///< 2^it > 0
  static constexpr unsigned stored = Limits::digits - 1;  ///< bits of a mantissa that are stored

  BinaryMap(const NumberSystem& s, Scalar) : precision(s.precision), exponent(s.exponent) {
    below.limit = assemble(1, exponent);
  }
  /// The bits of m * 2^e. Preconditions: m has at most Limits::digits bits; the number is finite;
  /// e >= least_exponent.
  static U assemble(std::uint64_t m, int e) {
    const int to_top = static_cast<int>(stored) + 1 - static_cast<int>(std::bit_width(m));
    const int normal = e - to_top - least_exponent;  // of the number with all bits, less one
    if (normal < 0) return static_cast<U>(m << (e - least_exponent));
    return static_cast<U>((static_cast<U>(normal) << stored) + static_cast<U>(m << to_top));
  }
  unsigned more_bits(std::uint64_t m) const {
    const unsigned bits = static_cast<unsigned>(std::bit_width(m));
    if (bits >= precision) return 0;
    return std::min(precision - bits, static_cast<unsigned>(exponent - least_exponent));
  }
  Choices choices(std::int64_t n) const {
    if (n == 0) return below.choices();
    return {std::uint64_t(1) << more_bits(absolute(n)), false};
  }
  U word(std::int64_t n, std::uint64_t choice) const {
    if (n == 0) return below.word(choice);
    const std::uint64_t m = absolute(n);
    const unsigned more = more_bits(m);
    const U sign = static_cast<U>(U(n < 0) << (std::numeric_limits<U>::digits - 1));
    return static_cast<U>(assemble(m << more | choice, exponent - static_cast<int>(more)) | sign);
  }
  NumberPlace locate(U bits) const {
    const U absolute_bits = magnitude(bits);
    if (absolute_bits < below.limit) return {0, below.choice(bits)};
    const U field = absolute_bits >> stored;
    std::uint64_t m = absolute_bits & ((U(1) << stored) - 1);
    if (field > 0) m |= U(1) << stored;
    const int e = least_exponent + std::max(static_cast<int>(field) - 1, 0);
    // m * 2^e = m * 2^(e - exponent) units: a shift to the right, as it is at least one unit.
    NumberPlace place = {0, 0};
    if (const int down = exponent - e; down <= 0) {
      place.n = down > -11 ? static_cast<std::int64_t>(m << -down) : most_exact;
    } else if (down < 64) {
      place.n = static_cast<std::int64_t>(m >> down);
      const int more = static_cast<int>(more_bits(static_cast<std::uint64_t>(place.n)));
      place.choice = (m & ((std::uint64_t(1) << down) - 1)) >> std::max(down - more, 0)
                                                                   << std::max(more - down, 0);
    }
    if (bits != absolute_bits) place.n = -place.n;
    return place;
  }

  unsigned precision;
  int exponent;
  BelowUnit<U> below;
};

/// N / divisor in decimal digits, rounded to nearest and ties away from zero, read as a number. A
/// number of less than one unit of the last digit is 0.
template <class T>
struct PrintedMap : PlainMap {
  using U = WordOf<T>;
  static constexpr unsigned most_decimals = 18;
  static constexpr unsigned most_digits = 15;

  PrintedMap(const NumberSystem& s, Scalar) : divisor(s.divisor) {
    if (s.decimals) {
      last = s.precision;
      bounds.fill(~std::uint64_t(0));
    } else {  // as many behind the point as bring the first digit to its place
      last = most_decimals;
      const std::uint64_t one = divisor * integer_tens[s.precision - 1u];
      for (unsigned e = 0; e < last; ++e) bounds[e] = (one + integer_tens[e] - 1) / integer_tens[e];
    }
  }
  U word(std::int64_t n, std::uint64_t) const {
    const std::uint64_t m = absolute(n);
    unsigned e = 0;
    while (e < last && m < bounds[e]) ++e;
    const std::uint64_t digits = (2 * m * integer_tens[e] + divisor) / (2 * divisor);
    const double v = times_ten_to(digits, -static_cast<int>(e));
    return std::bit_cast<U>(static_cast<T>(n < 0 && digits > 0 ? -v : v));
  }
  NumberPlace locate(U bits) const {
    return {nearest_integer(double(std::bit_cast<T>(bits)) * double(divisor)), 0};
  }
  /// All that word() computes of an |N| up to it is below 2^63, and the digits below 2^53.
  static std::int64_t most_integer(const NumberSystem& s) {
    const std::uint64_t unit = integer_tens[s.precision];
    if (s.decimals) return most_exact / 2 / static_cast<std::int64_t>(unit);
    return s.divisor > (std::uint64_t(1) << 61) / unit
               ? 0
               : static_cast<std::int64_t>(std::min(s.divisor * unit, std::uint64_t(most_exact)));
  }

  std::uint64_t divisor;
  unsigned last;                                    ///< the most decimals
  std::array<std::uint64_t, most_decimals> bounds;  ///< from which on so many decimals are enough
};

/// Calls use(map) with the map of a system of numbers of type T. Only floats have all maps.
template <class T, class Use>
auto with_map(const NumberSystem& system, Scalar scalar, Use&& use) {
  if (system.map == NumberMap::affine) return use(AffineMap<T>(system, scalar));
  if constexpr (std::is_floating_point_v<T>) {
    if (system.map == NumberMap::quotient) return use(QuotientMap<T>(system, scalar));
    if (system.map == NumberMap::digits) return use(DigitsMap<T>(system, scalar));
    if (system.map == NumberMap::binary) return use(BinaryMap<T>(system, scalar));
    if (system.map == NumberMap::printed) return use(PrintedMap<T>(system, scalar));
  }
  return use(WordMap<T>(system, scalar));
}

}  // namespace clers::internal

#endif

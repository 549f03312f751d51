// What stands before the integers of values: the system of each component <-> bytes.
#ifndef CLERS_CODEC_NUMBERS_NUMBER_FORMAT_H
#define CLERS_CODEC_NUMBERS_NUMBER_FORMAT_H

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/numbers/floating_maps.h"
#include "codec/numbers/number_system.h"
#include "codec/numbers/octahedral.h"

namespace clers::internal {

/// How the refinements of a component are coded.
enum class RefinementCoding : std::uint8_t {
  bits = 0,       ///< as plain bits
  adaptive = 1,   ///< few choices by adaptive models
  repeating = 2,  ///< and first of all, whether it is that of the last value with this integer
};

/// What there is of a component besides its system.
struct NumberColumn {
  NumberSystem system;
  Axis axis;
  std::uint64_t entries = 0;  ///< of the palette, where that is not read yet
  RefinementCoding coding = RefinementCoding::bits;
  /// Refinements are those of the palette's entries, not of each value.
  bool refined_palette = false;
  bool has_strays = false;
};

/// Whether integers of a system leave anything open.
inline bool has_refinements(const NumberSystem& s) {
  return s.low_bits > 0 || s.ulps > 0 || s.signed_zero || s.map == NumberMap::digits ||
         s.map == NumberMap::binary;
}

/// N of an integer and its low bits.
inline std::int64_t integer_of(const NumberSystem& s, std::uint64_t k, std::uint64_t low) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(s.first) +
                                   s.step * (k << s.low_bits | low));
}

/// The greatest |N| that a map takes. Precondition: the other fields are checked.
template <class T>
std::int64_t most_integer(const NumberSystem& s) {
  if constexpr (std::is_floating_point_v<T>) {
    using Limits = std::numeric_limits<T>;
    if (s.map == NumberMap::affine) {
      const double room = double(Limits::max()) / 2 - std::fabs(s.origin);
      return room > 0 ? std::max<std::int64_t>(nearest_integer(room / s.length) - 1, 0) : 0;
    }
    if (s.map == NumberMap::binary) {
      const int bits = std::min(Limits::digits, Limits::max_exponent - s.exponent);
      return (std::int64_t(1) << bits) - 1;
    }
    if (s.map == NumberMap::printed) return PrintedMap<T>::most_integer(s);
  }
  return most_exact;
}

/// What is wrong with the two numbers of an affine map, "" if nothing is: no intermediate result is
/// so small that it is rounded in another place than others are.
inline std::string fault_of_affine(const NumberSystem& s) {
  const double least = 0x1p-900, most = 0x1p900;
  if (!(s.length >= least && s.length <= most)) return "steps of no length";
  if (!(std::fabs(s.origin) <= most) || (s.origin != 0 && std::fabs(s.origin) < least))
    return "an origin out of range";
  return "";
}

/// What is wrong with the map of floats of type T; "" if nothing is.
template <class T>
std::string fault_of_map(const NumberSystem& s) {
  using Limits = std::numeric_limits<T>;
  switch (s.map) {
    case NumberMap::word:
    case NumberMap::octahedral: break;
    case NumberMap::affine:
      if (std::string fault = fault_of_affine(s); !fault.empty()) return fault;
      if (s.single && !std::is_same_v<T, float>) return "steps of floats";
      break;
    case NumberMap::printed:
      if (s.precision > (s.decimals ? PrintedMap<T>::most_decimals : PrintedMap<T>::most_digits) ||
          (s.precision == 0 && !s.decimals))
        return std::to_string(s.precision) + " printed digits";
      [[fallthrough]];
    case NumberMap::quotient:
      if (s.divisor == 0 || s.divisor > std::uint64_t(most_exact))
        return "a divisor of " + std::to_string(s.divisor);
      break;
    case NumberMap::digits:
      if (s.precision == 0 || s.precision > DigitsMap<T>::most_digits)
        return std::to_string(s.precision) + " digits";
      if (std::abs(int(s.exponent)) > int(most_tens))
        return "a decimal exponent of " + std::to_string(s.exponent);
      break;
    case NumberMap::binary:
      if (s.precision == 0 || s.precision > Limits::digits)
        return std::to_string(s.precision) + " bits";
      if (s.exponent < BinaryMap<T>::least_exponent || s.exponent >= Limits::max_exponent)
        return "an exponent of " + std::to_string(s.exponent);
      break;
  }
  const bool own =
      s.map == NumberMap::word || s.map == NumberMap::digits || s.map == NumberMap::binary;
  if ((own || s.ulps > 0) && (s.signed_zero || (own && s.ulps > 0)))
    return "refinements that its numbers do not have";
  return "";
}

/// What is wrong with a column, "" if nothing is: then no integer in 0 .. top and no choice of its
/// refinement leads out of what its map takes.
template <class T>
std::string fault_of(const NumberColumn& column) {
  const NumberSystem& s = column.system;
  const std::uint64_t top = column.axis.top;
  if (top > most_wide) return "a greatest integer of " + std::to_string(top);
  if (column.axis.scale == 0 || column.axis.scale > 65535)
    return "a scale of " + std::to_string(column.axis.scale);
  if (s.step == 0) return "steps of 0";
  if (s.low_bits > 63 || static_cast<unsigned>(std::bit_width(top)) + s.low_bits > 64)
    return std::to_string(s.low_bits) + " low bits";
  if constexpr (std::is_floating_point_v<T>) {
    if (std::string fault = fault_of_map<T>(s); !fault.empty()) return fault;
  } else if (s.signed_zero || s.ulps > 0 || s.single ||
             (s.map != NumberMap::word && s.map != NumberMap::affine)) {
    return "a number system that is not for integers";
  } else if (s.map == NumberMap::affine) {
    if (std::string fault = fault_of_affine(s); !fault.empty()) return fault;
  }
  if (s.map == NumberMap::word) return "";
  const std::uint64_t last = top << s.low_bits | ((std::uint64_t(1) << s.low_bits) - 1);
  const std::int64_t most = most_integer<T>(s);
  if (last > 2 * std::uint64_t(most) / s.step || s.first < -most ||
      s.first > most - static_cast<std::int64_t>(last * s.step))
    return "integers beyond what numbers of this type have";
  return "";
}

inline void put_double(Bytes& out, double v) {
  const auto bits = std::bit_cast<std::uint64_t>(v);
  put_u32(out, static_cast<std::uint32_t>(bits));
  put_u32(out, static_cast<std::uint32_t>(bits >> 32));
}
inline double read_double(ByteReader& in) {
  const std::uint64_t low = in.u32();
  return std::bit_cast<double>(low | std::uint64_t(in.u32()) << 32);
}

/// Whether a system differs from another, if any, in nothing but where it begins.
inline bool like(const NumberSystem& system, const NumberSystem* before) {
  if (before == nullptr) return false;
  NumberSystem same = *before;
  same.first = system.first;
  return system == same;
}

/// In the first byte: the map in bits 0 .. 2, the coding of refinements in bits 4 and 5.
namespace column_kind {
inline constexpr std::uint32_t map = 7, like_before = 8, coding = 48, scaled = 64, all = 127;
}
/// In the second byte.
namespace column_flags {
/// `variant`: decimals of printed numbers, single of affine ones.
inline constexpr std::uint32_t signed_zero = 1, variant = 2, low_bits = 4, ulps = 8, strays = 16,
                               palette = 32, refined_palette = 64, all = 127;
}  // namespace column_flags

/// Appends all of a column but the entries of the palette, how many they are included. `before` is
/// the system of the component before it, if there is one.
inline void put_column(Bytes& out, const NumberColumn& column, const NumberSystem* before) {
  const NumberSystem& s = column.system;
  const bool known = like(s, before);
  put_u8(out, static_cast<std::uint32_t>(s.map) | (known ? column_kind::like_before : 0) |
                  static_cast<std::uint32_t>(column.coding) << 4 |
                  (column.axis.scale != 1 ? column_kind::scaled : 0));
  using namespace column_flags;
  put_u8(out, (s.signed_zero ? signed_zero : 0) | (s.decimals || s.single ? variant : 0) |
                  (s.low_bits > 0 ? low_bits : 0) | (s.ulps > 0 ? ulps : 0) |
                  (column.has_strays ? strays : 0) | (column.axis.palette.empty() ? 0 : palette) |
                  (column.refined_palette ? refined_palette : 0));
  put_varint(out, column.axis.top);
  if (column.axis.scale != 1) put_varint(out, column.axis.scale);
  if (!column.axis.palette.empty()) put_varint(out, column.axis.palette.size());
  put_signed_varint(out, s.first);
  if (known) return;
  put_varint(out, s.step);
  if (s.low_bits > 0) put_u8(out, s.low_bits);
  if (s.ulps > 0) put_u8(out, s.ulps);
  if (s.map == NumberMap::quotient || s.map == NumberMap::printed) put_varint(out, s.divisor);
  if (s.map == NumberMap::affine) {
    put_double(out, s.origin);
    put_double(out, s.length);
  }
  if (s.map >= NumberMap::digits) put_u8(out, s.precision);
  if (s.map == NumberMap::digits || s.map == NumberMap::binary) put_signed_varint(out, s.exponent);
}

/// Reads what put_column wrote. The palette is empty. Errors: truncated, invalid.
inline Expected<NumberColumn> read_column(ByteReader& in, Scalar scalar, std::uint64_t count,
                                          const NumberSystem* before) {
  const std::uint64_t at = in.offset();
  const auto invalid = [&](const std::string& what) {
    return fail(ErrorCode::invalid, Place::byte, at, "a component with " + what);
  };
  NumberColumn column;
  NumberSystem& s = column.system;
  const std::uint32_t kind = in.u8(), flags = in.u8();
  using namespace column_flags;
  const bool known = (kind & column_kind::like_before) != 0;
  column.coding = static_cast<RefinementCoding>((kind & column_kind::coding) >> 4);
  column.has_strays = (flags & strays) != 0;
  column.refined_palette = (flags & refined_palette) != 0;
  column.axis.top = in.varint();
  const std::uint64_t scale = (kind & column_kind::scaled) != 0 ? in.varint() : 1;
  const std::uint64_t entries = (flags & palette) != 0 ? in.varint() : 0;
  column.entries = entries;
  if (known && before != nullptr) s = *before;
  s.map = static_cast<NumberMap>(kind & column_kind::map);
  s.signed_zero = (flags & signed_zero) != 0;
  s.decimals = (flags & variant) != 0 && s.map == NumberMap::printed;
  s.single = (flags & variant) != 0 && s.map == NumberMap::affine;
  s.first = in.signed_varint();
  std::int64_t exponent = s.exponent;
  if (!known) {
    s.step = in.varint();
    if ((flags & low_bits) != 0) s.low_bits = static_cast<std::uint8_t>(in.u8());
    if ((flags & ulps) != 0) s.ulps = static_cast<std::uint8_t>(in.u8());
    if (s.map == NumberMap::quotient || s.map == NumberMap::printed) s.divisor = in.varint();
    if (s.map == NumberMap::affine) {
      s.origin = read_double(in);
      s.length = read_double(in);
    }
    if (s.map >= NumberMap::digits) s.precision = static_cast<std::uint8_t>(in.u8());
    if (s.map == NumberMap::digits || s.map == NumberMap::binary) exponent = in.signed_varint();
  }
  if (!in.ok()) return Failure{in.error()};
  if ((kind & column_kind::map) >= number_map_count || kind > column_kind::all ||
      static_cast<unsigned>(column.coding) > 2 || scale > 65535 ||
      ((kind & column_kind::scaled) != 0 && scale == 1))
    return invalid("kind " + std::to_string(kind));
  if (exponent < -2000 || exponent > 2000) return invalid("an exponent out of range");
  s.exponent = static_cast<std::int16_t>(exponent);
  if (known != like(s, before)) return invalid("a system that is not the one before it");
  if (flags > all || ((flags & variant) != 0) != (s.decimals || s.single) ||
      ((flags & low_bits) != 0) != (s.low_bits > 0) || ((flags & ulps) != 0) != (s.ulps > 0) ||
      (column.refined_palette && entries == 0) ||
      (!has_refinements(s) && (column.refined_palette || column.coding != RefinementCoding::bits)))
    return invalid("flags " + std::to_string(flags));
  column.axis.scale = static_cast<std::uint32_t>(scale);
  if (std::string fault =
          with_number_type(scalar, [&](auto t) { return fault_of<decltype(t)>(column); });
      !fault.empty())
    return invalid(fault);
  if ((flags & palette) != 0 && (entries == 0 || entries > count / 2 || entries > column.axis.top))
    return invalid("a palette of " + std::to_string(entries));
  return column;
}

/// What stands for all three components of points of an octahedral grid: their map, and bits, with
/// a flag above them for those that are computed in floats.
inline constexpr std::uint32_t octahedral_single = 32;
inline void put_octahedral(Bytes& out, const NumberSystem& s) {
  put_u8(out, static_cast<std::uint32_t>(NumberMap::octahedral));
  put_u8(out, s.precision | (s.single ? octahedral_single : 0));
}
/// Whether that is what follows.
inline bool is_octahedral(ByteReader in) {
  return in.left() > 0 && in.u8() == static_cast<std::uint32_t>(NumberMap::octahedral);
}
/// Their systems: one for all components.
inline std::vector<NumberSystem> octahedral_systems(unsigned bits, bool single = false) {
  NumberSystem system;
  system.map = NumberMap::octahedral;
  system.precision = static_cast<std::uint8_t>(bits);
  system.single = single;
  return {system};
}
/// Directions of so many bits.
inline Numbers octahedral_numbers(Scalar scalar, unsigned bits, bool single = false) {
  Numbers numbers;
  numbers.scalar = scalar;
  numbers.systems = octahedral_systems(bits, single);
  const Axis axis{OctahedralGrid(bits).top()};
  numbers.axes = {axis, axis};
  return numbers;
}
/// Reads what put_octahedral wrote. Errors: truncated, invalid.
inline Expected<Numbers> read_octahedral(ByteReader& in, Scalar scalar, std::size_t components) {
  const std::uint64_t at = in.offset();
  in.u8();
  const std::uint32_t byte = in.u8(), bits = byte & ~octahedral_single;
  const bool single = bits != byte;
  if (!in.ok()) return Failure{in.error()};
  if (bits < min_direction_bits || bits > max_direction_bits || !is_float(scalar) ||
      components != 3 || (single && scalar != Scalar::float32))
    return fail(ErrorCode::invalid, Place::byte, at,
                "directions of " + std::to_string(bits) + " bits, of " +
                    std::to_string(components) + " " + name(scalar));
  return octahedral_numbers(scalar, bits, single);
}

}  // namespace clers::internal

#endif

// The types of the components of values: their sizes, names and C++ types.
#ifndef CLERS_CODEC_SCALAR_H
#define CLERS_CODEC_SCALAR_H

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// How one component of a value is stored. The numbers are the file format's.
enum class Scalar : std::uint8_t {
  int8 = 0,
  uint8 = 1,
  int16 = 2,
  uint16 = 3,
  int32 = 4,
  uint32 = 5,
  int64 = 6,
  uint64 = 7,
  float32 = 8,
  float64 = 9,
};
inline constexpr unsigned scalar_count = 10;

/// Size in bytes of a scalar.
constexpr std::size_t size_of(Scalar s) {
  constexpr std::uint8_t bytes[scalar_count] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return bytes[static_cast<unsigned>(s)];
}

/// "int8" .. "float64".
constexpr const char* name(Scalar s) {
  constexpr const char* names[scalar_count] = {"int8",   "uint8", "int16",  "uint16",  "int32",
                                               "uint32", "int64", "uint64", "float32", "float64"};
  return names[static_cast<unsigned>(s)];
}

constexpr bool is_float(Scalar s) {
  return s == Scalar::float32 || s == Scalar::float64;
}

/// The scalar that a C++ type is.
template <class T>
requires std::is_arithmetic_v<T>
constexpr Scalar scalar_of() {
  if constexpr (std::is_floating_point_v<T>) {
    static_assert(sizeof(T) == 4 || sizeof(T) == 8, "float or double");
    return sizeof(T) == 4 ? Scalar::float32 : Scalar::float64;
  } else {
    constexpr unsigned log2 = sizeof(T) == 1 ? 0 : sizeof(T) == 2 ? 1 : sizeof(T) == 4 ? 2 : 3;
    return static_cast<Scalar>(2 * log2 + std::is_unsigned_v<T>);
  }
}

/// Returns use(T()) with the C++ type of a scalar.
template <class Use>
constexpr auto with_type(Scalar s, Use&& use) {
  switch (s) {
    case Scalar::int8: return use(std::int8_t{});
    case Scalar::uint8: return use(std::uint8_t{});
    case Scalar::int16: return use(std::int16_t{});
    case Scalar::uint16: return use(std::uint16_t{});
    case Scalar::int32: return use(std::int32_t{});
    case Scalar::uint32: return use(std::uint32_t{});
    case Scalar::int64: return use(std::int64_t{});
    case Scalar::uint64: return use(std::uint64_t{});
    case Scalar::float32: return use(float{});
    case Scalar::float64: break;
  }
  return use(double{});
}

/// Returns use(U()) with the unsigned integer that has the size of a scalar.
template <class Use>
constexpr auto with_word(Scalar s, Use&& use) {
  switch (size_of(s)) {
    case 1: return use(std::uint8_t{});
    case 2: return use(std::uint16_t{});
    case 4: return use(std::uint32_t{});
    default: return use(std::uint64_t{});
  }
}

}  // namespace clers

#endif

// Number systems: what the numbers of a component have in common, so that they are few integers.
//
// Files hold floats, but what was put into them mostly is something simpler: decimals, steps of a
// grid, halves. Such a system gives each value an integer k in 0 .. top, and gives it back from k:
//
//     k  ->  K = k << low_bits | low bits  ->  N = first + step K  ->  map(N)  ->  +- ulps  ->  value
//
// What k leaves open (low bits, digits or bits that only small values have, ulps, the sign of
// zero) are refinements; values that the system does not have are strays. Both are stored apart.
// The maps are a few operations on integers, or correctly rounded ones on doubles, so that they
// give the same on every machine (codec/format-values.md).
#ifndef CLERS_CODEC_NUMBERS_NUMBER_SYSTEM_H
#define CLERS_CODEC_NUMBERS_NUMBER_SYSTEM_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "codec/numbers/lattice.h"
#include "codec/precision.h"
#include "codec/scalar.h"

namespace clers::internal {

/// How a number is made of an integer N. The numbers are the file format's.
enum class NumberMap : std::uint8_t {
  word = 0,      ///< the integer itself; the float whose bits, as an integer that sorts, are N
  quotient = 1,  ///< N / divisor
  affine = 2,    ///< origin + N * length: two operations
  digits = 3,    ///< significant decimal digits: N * 10^exponent, and more digits the smaller it is
  binary = 4,    ///< the same in base 2: N * 2^exponent, and more bits the smaller it is
  printed = 5,   ///< N / divisor, printed with some decimal digits and read again
  octahedral = 6,  ///< three components at once: a point of a grid of directions (octahedral.h)
};
inline constexpr unsigned number_map_count = 6;  ///< of one component

/// The numbers of one component.
struct NumberSystem {
  NumberMap map = NumberMap::word;
  std::uint8_t low_bits = 0;   ///< of K, that are refinements
  bool signed_zero = false;    ///< a refinement says which zeros are -0.0
  std::uint8_t ulps = 0;       ///< values may be so many ulps beside what the map gives
  std::int64_t first = 0;      ///< N where k = 0
  std::uint64_t step = 1;      ///< of N, from one K to the next
  std::uint64_t divisor = 1;   ///< quotient, printed
  double origin = 0;           ///< affine
  double length = 1;           ///< affine, more than 0
  bool single = false;         ///< affine, octahedral, of float32: all results are rounded to one
  std::uint8_t precision = 0;  ///< digits, binary, printed: how many significant digits or bits;
                               ///< octahedral: bits of an integer
  bool decimals = false;       ///< printed: precision counts digits behind the point instead
  std::int16_t exponent = 0;   ///< digits, binary

  friend bool operator==(const NumberSystem&, const NumberSystem&) = default;
};

/// Those of all components of an attribute.
struct Numbers {
  Scalar scalar = Scalar::float32;
  /// One a component; or one for all, octahedral, with two integers a value.
  std::vector<NumberSystem> systems;
  std::vector<Axis> axes;  ///< what coders of integers know of them

  /// 0: values are no points of an octahedral grid.
  unsigned octahedral_bits() const {
    return !systems.empty() && systems[0].map == NumberMap::octahedral ? systems[0].precision : 0;
  }

  /// Whether integers are std::int32_t.
  bool narrow() const {
    return std::all_of(axes.begin(), axes.end(),
                       [](const Axis& a) { return a.top <= most_narrow; });
  }
};

/// What was decided for all pieces of a mesh.
struct AttributePlan {
  std::vector<NumberSystem> systems = {};  ///< as in Numbers; none: they are found
  double error = 0;                        ///< of the values, which are in the systems already
  ErrorMeasure measure = ErrorMeasure::difference;
  /// The type of numbers whose K, as std::int32_t, are handed on instead of values.
  std::optional<Scalar> integers_of = {};
};

/// How far apart two neighbours on an axis are; 0 where that is not the same everywhere.
double spacing(const NumberSystem& system);

/// Sets Axis::scale from the systems' spacings.
void set_scales(Numbers& numbers);

/// In words, for people: "6 decimals", "steps of 30", "float, 24 bits", "palette of 17".
std::string describe(const Numbers& numbers, std::size_t component);

}  // namespace clers::internal

#endif

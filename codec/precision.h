// How exactly the values of an attribute come back.
#ifndef CLERS_CODEC_PRECISION_H
#define CLERS_CODEC_PRECISION_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <clers/mesh.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

inline constexpr int min_bits = 1, max_bits = 30;
inline constexpr int min_direction_bits = 2, max_direction_bits = 20;

/// What an error of values is.
enum class ErrorMeasure : std::uint8_t {
  difference,  ///< of a component
  angle,       ///< between directions, in degrees
};

/// As in the enumeration. Precondition: the value is one of it.
constexpr const char* name(ErrorMeasure m) {
  return m == ErrorMeasure::angle ? "angle" : "difference";
}

/// Values come back as they are, or each component is moved to the nearest point of a grid:
/// origin + k * step, rounded to the type of the attribute. With `bits` and `error`, a component
/// that is on a coarser grid already, or nearly, is moved to that one instead. Or values are
/// directions: three floats, of which a vector of length 1 comes back.
struct Precision {
  enum class Kind : std::uint8_t {
    lossless,
    bits,   ///< one step for all components: the longest side of the bounding box has
            ///< 2^bits - 1 steps, and its least corner is the origin
    step,   ///< multiples of `size`: the same grid for all meshes
    error,  ///< no component is off by more than `size`
    grid,   ///< `origin` + k * `size`: meshes that share it share values, as tiles their border
    directions,  ///< the nearest of 4 (2^(bits-1) - 1)^2 + 2 directions, points of a grid on an
                 ///< octahedron. What has none (zero, NaN) is refused
    recomputed,  ///< directions that follow from the positions and faces that are decoded, where
                 ///< these are no more than `size` degrees away; else others within that
  };

  Kind kind = Kind::lossless;
  int bits = 0;                     ///< min_bits .. max_bits, of directions min_direction_bits ..
                                    ///< max_direction_bits
  double size = 0;                  ///< positive
  std::vector<double> origin = {};  ///< one a component, or one for all of them
  /// `bits`: directions instead, where all values are vectors of length 1, to a thousandth, and
  /// there are directions of so many bits.
  bool or_directions = false;

  static Precision lossless() { return {}; }
  static Precision of_bits(int bits) { return {Kind::bits, bits, 0, {}}; }
  static Precision of_step(double size) { return {Kind::step, 0, size, {}}; }
  static Precision of_error(double size) { return {Kind::error, 0, size, {}}; }
  static Precision on_grid(std::vector<double> origin, double step) {
    return {Kind::grid, 0, step, std::move(origin)};
  }
  static Precision of_directions(int bits) { return {Kind::directions, bits, 0, {}}; }
  static Precision recomputed(double degrees) { return {Kind::recomputed, 0, degrees, {}}; }

  friend bool operator==(const Precision&, const Precision&) = default;
};

/// What is asked for all attributes of a name, or for that of one domain.
struct AttributePrecision {
  std::string name;
  Precision precision;
  std::optional<Domain> domain = {};
};

enum class WarningCode : std::uint8_t {
  /// A few values, a thousandth or one, are far from all others: without them two bits less make a
  /// grid that is as fine.
  wasted_bits = 1,
};

/// What encoding does as it was asked, though nobody may want it.
struct Warning {
  WarningCode code = WarningCode::wasted_bits;
  std::size_t mesh = 0;  ///< its index
  std::string attribute;
  Domain domain = Domain::vertex;
  std::uint64_t at = 0;  ///< index of the value, in the order of the input
  std::string what;      ///< one line for people
};

}  // namespace clers

#endif

// Values as integers: what the coders of values work on, whatever the values are.
//
// A number system (number_system.h) makes integers of the components of values, and values of them
// again. Here they are only that: rows of integers, and what is known of each component beforehand.
#ifndef CLERS_CODEC_NUMBERS_LATTICE_H
#define CLERS_CODEC_NUMBERS_LATTICE_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace clers::internal {

/// One component of values on a lattice.
struct Axis {
  /// Every integer is in 0 .. top.
  std::uint64_t top = 0;
  /// How long a step is beside those of the other axes, 1 .. 65535: for lengths and angles.
  std::uint32_t scale = 1;
  /// Ascending, in 0 .. top. If there is any, every integer is one of these.
  std::vector<std::uint64_t> palette = {};
};

/// Integers are std::int32_t where every top is at most this, so that a + b - c does not overflow;
/// else std::int64_t.
inline constexpr std::uint64_t most_narrow = (std::uint64_t(1) << 29) - 1;
/// The greatest top of all.
inline constexpr std::uint64_t most_wide = (std::uint64_t(1) << 60) - 1;

/// Memory for them, narrow or wide.
using Rows = std::variant<std::vector<std::int32_t>, std::vector<std::int64_t>>;

/// The integers of all values, a row each, in the order of the values.
template <class Int>
struct Lattice {
  std::span<Int> rows;         ///< axes.size() a value
  std::span<const Axis> axes;  ///< at least one

  std::size_t count() const { return rows.size() / axes.size(); }
};

}  // namespace clers::internal

#endif

// Symmetries that keep the grid of three axes <-> bytes; and the maps that they are.
#ifndef CLERS_CODEC_ATTRIBUTES_SYMMETRY_H
#define CLERS_CODEC_ATTRIBUTES_SYMMETRY_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// Maps of the grid to itself that reverse or exchange coordinates of one axis, or of two that
/// follow each other cyclically. The numbers are the format's.
struct Symmetry {
  enum Kind : std::uint8_t {
    mirror,        ///< the first axis is reversed
    mirrors,       ///< each of both axes, and both
    half_turn,     ///< both
    quarter_turn,  ///< a turn in their plane, three times
  };
  static constexpr std::uint32_t kinds = 4;

  std::uint32_t axis = 0;
  std::uint64_t sum = 0;  ///< of a coordinate and its image's when it is reversed
  Kind kind = mirror;
  std::uint64_t sum2 = 0;  ///< the same on the next axis; 0 for a mirror

  std::uint32_t axis2() const { return (axis + 1) % 3; }
  /// Whether images are near the grid. A quarter turn is one about a point or a middle of four.
  bool fits(std::span<const Axis> axes) const {
    return axis < 3 && sum <= 2 * axes[axis].top && sum2 <= 2 * axes[axis2()].top &&
           (kind != mirror || sum2 == 0) && (kind != quarter_turn || (sum + sum2) % 2 == 0);
  }
};

/// Appends a byte: 0 for none, else 1 + axis + 3 kind; and then the sum, or both.
inline void put_mirror(Bytes& out, const std::optional<Symmetry>& symmetry) {
  put_u8(out, symmetry ? 1 + symmetry->axis + 3u * symmetry->kind : 0);
  if (symmetry) put_varint(out, symmetry->sum);
  if (symmetry && symmetry->kind != Symmetry::mirror) put_varint(out, symmetry->sum2);
}

/// Reads and checks what put_mirror wrote. Errors: truncated, invalid. Precondition: three axes.
inline Expected<std::optional<Symmetry>> read_mirror(ByteReader& in, std::span<const Axis> axes) {
  const std::uint64_t at = in.offset();
  const std::uint32_t kind = in.u8();
  Symmetry symmetry;
  symmetry.axis = (kind - 1) % 3;
  symmetry.kind = static_cast<Symmetry::Kind>((kind - 1) / 3 % Symmetry::kinds);
  if (kind > 0) symmetry.sum = in.varint();
  if (kind > 3) symmetry.sum2 = in.varint();
  if (!in.ok()) return Failure{in.error()};
  if (kind == 0) return std::optional<Symmetry>();
  if (kind > 3 * Symmetry::kinds || !symmetry.fits(axes))
    return fail(ErrorCode::invalid, Place::byte, at, "a symmetry beyond all vertices");
  return std::optional(symmetry);
}

/// Each map of a symmetry but the one that moves nothing.
template <class Int>
class SymmetryMaps {
 public:
  explicit SymmetryMaps(const Symmetry& s) {
    const std::uint32_t x = s.axis, y = s.axis2();
    count_ = s.kind == Symmetry::mirror || s.kind == Symmetry::half_turn ? 1 : 3;
    for (unsigned m = 0; m < count_; ++m) maps_[m].inverse = m;
    if (s.kind == Symmetry::quarter_turn) {
      for (unsigned m : {0u, 2u}) {
        maps_[m].from[x] = static_cast<std::uint8_t>(y);
        maps_[m].from[y] = static_cast<std::uint8_t>(x);
        // about (sum, sum2) / 2; to exchange two axes reverses too
        maps_[m].reverse(m == 0 ? x : y, (s.sum + s.sum2) / 2);
        const std::uint32_t kept = m == 0 ? y : x;
        maps_[m].moved[kept] = true;
        maps_[m].reverses = false;
        const auto up = static_cast<Int>(s.sum2) - static_cast<Int>(s.sum);
        maps_[m].offset[kept] = (m == 0 ? up : -up) / 2;
        maps_[m].inverse = 2 - m;
      }
      maps_[1].reverse(x, s.sum);
      maps_[1].reverse(y, s.sum2);
      return;
    }
    maps_[0].reverse(x, s.sum);
    if (s.kind == Symmetry::half_turn) maps_[0].reverse(y, s.sum2);
    if (s.kind != Symmetry::mirrors) return;
    maps_[1].reverse(y, s.sum2);
    maps_[2].reverse(x, s.sum);
    maps_[2].reverse(y, s.sum2);
  }

  unsigned count() const { return count_; }
  unsigned inverse(unsigned map) const { return maps_[map].inverse; }
  /// Whether the image of what is counterclockwise is clockwise.
  bool reverses(unsigned map) const { return maps_[map].reverses; }
  /// Whether coordinate c of an image is another one than that of the place.
  bool moves(unsigned map, std::size_t c) const { return maps_[map].moved[c]; }
  /// Coordinate c of the image of a place: within -T .. 2 T if T is the greatest top.
  Int image(unsigned map, const Int* place, std::size_t c) const {
    const Map& m = maps_[map];
    return m.offset[c] + m.sign[c] * place[m.from[c]];
  }

 private:
  /// Coordinate c is that on axis from[c], reversed or not, and an offset.
  struct Map {
    std::array<std::uint8_t, 3> from = {0, 1, 2};
    std::array<bool, 3> moved = {};
    std::array<Int, 3> sign = {1, 1, 1}, offset = {};
    unsigned inverse = 0;  // which of the maps
    bool reverses = false;

    void reverse(std::uint32_t c, std::uint64_t sum) {
      moved[c] = true;
      reverses = !reverses;
      sign[c] = -1;
      offset[c] = static_cast<Int>(sum);
    }
  };

  std::array<Map, 3> maps_;
  unsigned count_ = 0;
};

}  // namespace clers::internal

#endif

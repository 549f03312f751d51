// Vertices on one line along an axis: what was moved along it has such, on the two sides of a plate
// or at the ends of a tube, and what has a mirror image beside. Which vertex is on the line of
// which is found while values are coded, the same by who encodes and who decodes. Knows three
// coordinates and the surface.
//
//          v           w        p and q are on the lines of b and a, along the same axis: then v is
//         / \         / \       perhaps on that of w, which is around p or q, and of those around
//        b---a       p---q      the one nearest to it without regard to the axis.
#ifndef CLERS_CODEC_ATTRIBUTES_LINES_H
#define CLERS_CODEC_ATTRIBUTES_LINES_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/attributes/around_vertex.h"
#include "codec/attributes/repeats.h"
#include "codec/base/portable.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/coder.h"

namespace clers::internal {

template <class Int>
class Lines {
 public:
  /// `rows` has three integers a vertex, which are looked at once they are known. Throws
  /// std::bad_alloc only. Precondition: twins are there.
  Lines(Int* rows, std::size_t vertices, const CodedSurface& surface)
      : surface_(surface), rows_(rows), repeated_(vertices) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      before_[axis].assign(vertices, unknown);
      slots_[axis].assign(static_cast<std::size_t>(slots_for(vertices)), unknown);
    }
  }

  /// The bytes that one takes.
  static std::uint64_t memory(std::uint64_t vertices) {
    return 13 * vertices + 12 * slots_for(vertices);
  }

  /// Codes whether v is on the line of a vertex along an axis, and sets its two other coordinates
  /// then: a bit for each. Otherwise as RepeatedCoordinates::code.
  template <class Decide>
  CLERS_NEVER_INLINE unsigned code(const Gate& gate, const std::array<std::int64_t, 3>& ends,
                                   Decide decide) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      const std::uint32_t q = before_[axis][gate.a], p = before_[axis][gate.b];
      if (q >= nothing && p >= nothing) continue;
      const Nearest found = nearest(axis, q, p, ends);
      if (found.w == unknown) continue;
      const auto was = [&](std::uint32_t u) { return unsigned(repeated_[u]) >> axis & 1u; };
      const unsigned whose = q < nothing && p < nothing ? 8 : 0;
      BitModel& model = models_[axis][whose + 4u * found.both + 2 * was(gate.b) + was(gate.a)];
      Int *const v = row(gate.v), *const w = row(found.w);
      if (!decide(0u, model, on_one_line(axis, v, w))) continue;
      repeated_[gate.v] = static_cast<std::uint8_t>(1u << axis);
      for (const unsigned i : {(axis + 1) % 3, (axis + 2) % 3}) v[i] = w[i];
      return 7u & ~(1u << axis);
    }
    return 0;
  }

  /// Says that the integers of v are in its row from now on.
  CLERS_NEVER_INLINE void known(std::uint32_t v) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      std::uint32_t& last = slots_[axis][slot_of(axis, row(v))];
      before_[axis][v] = last != unknown && on_one_line(axis, row(v), row(last)) ? last : nothing;
      last = v;
    }
  }

 private:
  // What before_ says besides vertices: known, and the first of its line; not known.
  static constexpr std::uint32_t nothing = 0xfffffffeu, unknown = 0xffffffffu;

  static std::uint64_t slots_for(std::uint64_t vertices) {
    return std::bit_ceil(std::max<std::uint64_t>(vertices, 2));
  }

  Int* row(std::uint32_t v) const { return rows_ + 3 * std::size_t(v); }

  static bool on_one_line(unsigned axis, const Int* v, const Int* w) {
    const unsigned y = (axis + 1) % 3, z = (axis + 2) % 3;
    return v[y] == w[y] && v[z] == w[z];
  }
  std::size_t slot_of(unsigned axis, const Int* place) const {
    const std::uint64_t y = static_cast<std::uint64_t>(place[(axis + 1) % 3]);
    const std::uint64_t z = static_cast<std::uint64_t>(place[(axis + 2) % 3]);
    const std::uint64_t mixed = y * 0x9e3779b97f4a7c15u ^ (z + 1) * 0xc2b2ae3d27d4eb4fu;
    return static_cast<std::size_t>(mixed >> 32 ^ mixed) & (slots_[axis].size() - 1);
  }

  struct Nearest {
    std::uint32_t w;
    bool both;  ///< some are around both
  };
  /// What is around both q and p completes a triangle mostly, as v does: it may be farther.
  Nearest nearest(unsigned axis, std::uint32_t q, std::uint32_t p,
                  const std::array<std::int64_t, 3>& ends) const {
    std::uint64_t least = ~std::uint64_t(0);
    Nearest best = {unknown, false};
    const auto consider = [&](std::uint32_t w, std::uint64_t weight) {
      std::uint64_t far = 0;
      for (const unsigned i : {(axis + 1) % 3, (axis + 2) % 3}) far += apart(row(w)[i], ends[i]);
      far = weight * std::min(far, std::uint64_t(1) << 61);
      if (far < least) least = far, best.w = w;
    };
    std::uint32_t found[most_around];
    std::size_t count = 0;
    const auto is_known = [&](std::uint32_t w) { return before_[axis][w] != unknown; };
    if (q < nothing)
      look_around(surface_, q, [&](std::uint32_t w) {
        if (is_known(w)) found[count++] = w;
      });
    if (p < nothing && p != q)
      look_around(surface_, p, [&](std::uint32_t w) {
        if (!is_known(w)) return;
        std::uint32_t* const same = std::find(found, found + count, w);
        const bool both = same != found + count;
        if (both) *same = found[--count];
        best.both |= both;
        consider(w, both ? 1 : 4);
      });
    for (std::size_t i = 0; i < count; ++i) consider(found[i], 4);
    return best;
  }

  CodedSurface surface_;
  Int* const rows_;
  std::array<std::vector<std::uint32_t>, 3> before_;  ///< of each vertex, on its line along an axis
  std::array<std::vector<std::uint32_t>, 3> slots_;   ///< the last on each line
  std::vector<std::uint8_t> repeated_;  ///< of each vertex, a bit for the axis along which it was
  std::array<std::array<BitModel, 16>, 3> models_;
};

}  // namespace clers::internal

#endif

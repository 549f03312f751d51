// Coordinates that occur again: where shapes lie along axes, as walls, boxes and profiles do that
// were moved along one, vertices beside each other agree in a coordinate or two, however irregular
// the rest is. Which do is coded before what differs, and learned the same by who encodes and who
// decodes. Knows three coordinates, and no surface.
#ifndef CLERS_CODEC_ATTRIBUTES_REPEATS_H
#define CLERS_CODEC_ATTRIBUTES_REPEATS_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/attributes/residual_sizes.h"
#include "codec/base/portable.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/coder.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// Whether coordinates of vertices are those of vertices beside them so often, and so far from
/// where parallelograms end, that it may be worth coding which are. Cost: linear. Preconditions:
/// three axes, and twins.
template <class Int>
bool repeats_may_pay(const CodedSurface& surface, const Lattice<Int>& lattice);

/// v, which is across from a-b, and vertices around it:
///
///        d-----v-----e
///         \   / \   /
///          \ /   \ /
///           b-----a
///            \   /
///             \ /
///              c
///
/// a, b and c are known; d or e is v itself where it is not.
struct Gate {
  std::uint32_t v, a, b, c, d, e;
};

/// How far two coordinates are apart, each within -2^61 .. 2^61.
inline std::uint64_t apart(std::int64_t x, std::int64_t y) {
  return static_cast<std::uint64_t>(x < y ? y - x : x - y);
}

template <class Int>
class Repeats {
 public:
  /// `rows` has three integers a vertex, which are looked at once they are known. Throws
  /// std::bad_alloc only.
  Repeats(Int* rows, std::size_t vertices) : rows_(rows), repeated_(vertices), models_(contexts) {}

  /// The bytes that one takes.
  static std::uint64_t memory(std::uint64_t vertices) {
    return vertices + contexts * sizeof(Models);
  }

  /// Codes which coordinates of v are those of a, b, d or e, and sets these: a bit for each that
  /// is, and for those that are `done`. Otherwise as RepeatedCoordinates::code.
  template <class Decide>
  CLERS_NEVER_INLINE unsigned code(const Gate& gate, const std::array<std::int64_t, 3>& ends,
                                   unsigned done, Decide decide) {
    const std::array<std::uint32_t, near> others = {gate.a, gate.b, gate.d, gate.e};
    unsigned repeated = 0, count = 0;
    for (unsigned i = 0; i < 3; ++i) {
      const auto at = [&](std::uint32_t u) { return rows_[3 * std::size_t(u) + i]; };
      const auto was = [&](std::uint32_t u) { return unsigned(repeated_[u]) >> i & 1u; };
      const unsigned like = equal(at(gate.a), at(gate.b), at(gate.c)),
                     around = was(gate.a) + was(gate.b) + was(gate.c);
      Models& models = models_[((i * 5 + like) * 4 + around) * 3 + count];
      bool yes = (done >> i & 1) != 0;
      Int& value = rows_[3 * std::size_t(gate.v) + i];
      std::array<Int, near> asked;
      unsigned n = 0;
      for (unsigned k = 0; k < near && !yes; ++k) {
        const Int x = at(others[k]);
        if (others[k] == gate.v || std::find(&asked[0], &asked[n], x) != &asked[n]) continue;
        asked[n++] = x;
        const unsigned far = std::min(size_of(apart(x, ends[i])) / 8, distances - 1);
        yes = decide(i, models[k][far], value == x);
        if (yes) value = x;
      }
      repeated |= unsigned(yes) << i;
      count += yes;
    }
    repeated_[gate.v] = static_cast<std::uint8_t>(repeated);
    return repeated;
  }

 private:
  static constexpr unsigned near = 4, distances = 8;
  static constexpr std::size_t contexts = 3 * 5 * 4 * 3;
  using Models = std::array<std::array<BitModel, distances>, near>;

  /// Which of three are equal, in 5 ways.
  static unsigned equal(Int a, Int b, Int c) {
    return a == b ? (b == c ? 0u : 1u) : b == c ? 2u : a == c ? 3u : 4u;
  }
  Int* const rows_;
  std::vector<std::uint8_t> repeated_;  ///< of each vertex, a bit for each coordinate
  std::vector<Models> models_;
};

}  // namespace clers::internal

#endif

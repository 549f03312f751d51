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

/// The vertices around v, which is across from a-b:
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
struct Around {
  std::uint32_t a, b, c, d, e;
};

template <class Int>
class Repeats {
 public:
  /// `rows` has three integers a vertex, which are looked at once they are known. Throws
  /// std::bad_alloc only.
  Repeats(Int* rows, std::size_t vertices) : rows_(rows), repeated_(vertices), models_(contexts) {}

  /// The bytes that one takes.
  static std::uint64_t memory(std::uint64_t vertices) {
    return vertices + contexts * sizeof(BitModel);
  }

  /// Codes which coordinates of v are those of a, b, d or e, and sets these: a bit for each that
  /// is, and for those that are `done`. `ends` is where the parallelogram a + b - c ends, within
  /// -2^61 .. 2^61.
  template <class Coder>
  CLERS_NEVER_INLINE unsigned code(Coder& coder, std::uint32_t v, const Around& around,
                                   const std::array<std::int64_t, 3>& ends, unsigned done) {
    const std::array<std::uint32_t, near> others = {around.a, around.b, around.d, around.e};
    unsigned repeated = 0, count = 0;
    for (unsigned i = 0; i < 3; ++i) {
      const auto at = [&](std::uint32_t u) { return rows_[3 * std::size_t(u) + i]; };
      const auto was = [&](std::uint32_t u) { return repeated_[u] >> i & 1u; };
      const unsigned surroundings = (equal(at(around.a), at(around.b), at(around.c)) * 4u +
                                     was(around.a) + was(around.b) + was(around.c)) *
                                        3u +
                                    count;
      bool yes = (done >> i & 1) != 0;
      for (unsigned k = 0; k < near && !yes; ++k) {
        const std::uint32_t u = others[k];
        if (u == v || is_among(at(u), k, [&](unsigned j) {
              return others[j] != v ? at(others[j]) : Int(-1);
            }))
          continue;
        const std::int64_t off = std::int64_t(at(u)) - ends[i];
        const unsigned far =
            std::min(size_of(static_cast<std::uint64_t>(off < 0 ? -off : off)) / 8, distances - 1);
        BitModel& model = models_[((i * near + k) * 5 * 4 * 3 + surroundings) * distances + far];
        yes = coder.flag(i, model, at(v) == at(u));
        if (yes) rows_[3 * std::size_t(v) + i] = at(u);
      }
      repeated |= unsigned(yes) << i;
      count += yes;
    }
    repeated_[v] = static_cast<std::uint8_t>(repeated);
    return repeated;
  }

 private:
  static constexpr unsigned near = 4, distances = 8;
  static constexpr std::size_t contexts = 3 * near * 5 * 4 * 3 * distances;

  /// Which of three are equal, in 5 ways.
  static unsigned equal(Int a, Int b, Int c) {
    return a == b ? (b == c ? 0u : 1u) : b == c ? 2u : a == c ? 3u : 4u;
  }
  /// Whether one of the first k is x.
  template <class At>
  static bool is_among(Int x, unsigned k, const At& at) {
    for (unsigned j = 0; j < k; ++j)
      if (at(j) == x) return true;
    return false;
  }

  Int* const rows_;
  std::vector<std::uint8_t> repeated_;  ///< of each vertex, a bit for each coordinate
  std::vector<BitModel> models_;
};

}  // namespace clers::internal

#endif

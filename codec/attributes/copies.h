// Components that have the connectivity of an earlier one are often copies of it, moved, turned and
// stretched: wheels, leaves, balls. Which vertices are whose copies follows from the surface alone.
// How a component lies is learned from its vertices that are known, the same by who encodes and who
// decodes. Knows three coordinates and the surface, and no coder.
//
//            v              w         w, p, q, o are the originals of v, a, b, c, and M is the
//           / \            / \        linear part of the affine map. v is predicted from the middle
//          a---b          p---q       of a and b, at (a + b) / 2 + M (w - (p + q) / 2), or from the
//           \ /            \ /        parallelogram, at a + b - c + M (w - p - q + o): by what was
//            c              o         nearer lately.
#ifndef CLERS_CODEC_ATTRIBUTES_COPIES_H
#define CLERS_CODEC_ATTRIBUTES_COPIES_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/attributes/linear_fit.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// For each vertex the one in its place in the last component before with the same connectivity, as
/// coded.
struct Originals {
  static constexpr std::uint32_t none = 0xffffffffu;

  std::vector<std::uint32_t> of;         ///< of each vertex that may be in a triangle; or none
  std::vector<std::uint32_t> component;  ///< that introduces it; or none
  std::size_t count = 0;                 ///< vertices that have an original
};

/// How many components a surface has, as coded; 0 without twins. Those of one have no originals.
std::size_t component_count(const CodedSurface& surface);

/// Without twins no vertex has an original. Cost: linear, but for sorting components. Throws
/// std::bad_alloc only.
Originals find_originals(const CodedSurface& surface);

/// What find_originals allocates at most, what it returns included.
inline std::uint64_t originals_memory(std::uint64_t vertices, std::uint64_t triangles) {
  return 12 * vertices + 24 * triangles;
}

/// Whether vertices that have an original are nearer to where they are guessed than to where
/// parallelograms end: worth coding with. Cost: linear. Preconditions: three axes; the originals of
/// the surface.
template <class Int>
bool copies_pay(const CodedSurface& surface, const Originals& originals,
                const Lattice<Int>& lattice);

/// Predicts vertices of copies. Vertices may be met in any order; copies are where all of a
/// component are met before the next one's.
template <class Int>
class Copies {
 public:
  static constexpr std::uint32_t none = Originals::none;
  using Row = std::array<Int, 3>;

  /// `rows` has three integers a vertex, which are looked at once they are known. All are in
  /// 0 .. top of their axis. Throws std::bad_alloc only.
  Copies(const Originals& originals, const Int* rows, std::span<const Axis> axes)
      : originals_(&originals), rows_(rows), known_(originals.of.size()) {
    for (std::size_t c = 0; c < 3; ++c) {
      tops_[c] = static_cast<std::int64_t>(axes[c].top);
      shift_ = std::max(shift_, int(std::bit_width(axes[c].top)) - LinearFit::vector_bits);
    }
  }

  /// The bytes that one takes, besides originals.
  static std::uint64_t memory(std::uint64_t vertices) { return vertices; }

  /// Where vertex v will be, in 0 .. top; nowhere (and false) if that is not known, or if
  /// parallelograms were nearer lately. It is across a-b from c, which may be none. Preconditions:
  /// a, b, c are known.
  bool guess(std::uint32_t v, std::uint32_t a, std::uint32_t b, std::uint32_t c, Int* place) {
    guessed_ = none;
    const std::uint32_t w = original(v);
    if (w == none || originals_->component[v] != component_ || fit_.pairs() == 0) return false;
    const std::uint32_t p = original(a), q = original(b);
    if (p == none || q == none) return false;
    const std::uint32_t o = c == none ? none : original(c);
    guessed_ = v;
    const auto& map = fit_.map();
    const auto at = [&](std::uint32_t u, std::size_t i) { return std::int64_t(row(u)[i]); };
    LinearFit::Vector from_middle, from_parallelogram = {};
    for (std::size_t i = 0; i < 3; ++i) {
      from_middle[i] = 2 * at(w, i) - at(p, i) - at(q, i);
      if (o != none) from_parallelogram[i] = at(w, i) - at(p, i) - at(q, i) + at(o, i);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t sum = at(a, i) + at(b, i);
      const std::int64_t parallelogram = c == none ? (sum + 1) >> 1 : sum - at(c, i);
      const auto set = [&](unsigned by, std::int64_t x) {
        guess_[by][i] = static_cast<Int>(std::clamp<std::int64_t>(x, 0, tops_[i]));
      };
      set(middle, (sum + mapped(map[i], from_middle) + 1) >> 1);
      set(corner,
          o == none ? guess_[middle][i] : parallelogram + mapped(map[i], from_parallelogram));
      set(plain, parallelogram);
    }
    const unsigned by = best();
    if (by == plain) return false;
    std::copy(guess_[by].begin(), guess_[by].end(), place);
    return true;
  }

  /// The original of a vertex, if it is known. Where nothing has twins there are none at all.
  std::uint32_t original(std::uint32_t v) const {
    if (v >= known_.size()) return none;
    const std::uint32_t w = originals_->of[v];
    return w != none && known_[w] ? w : none;
  }

  /// How long the error of a guess is about now, as the number of its bits times 16.
  unsigned expected() const { return errors_[best()]; }

  /// Says that the integers of v are in its row from now on.
  void known(std::uint32_t v) {
    if (v >= known_.size()) return;
    known_[v] = 1;
    const std::uint32_t w = originals_->of[v];
    if (w == none || !known_[w]) return;
    if (originals_->component[v] != component_) {
      component_ = originals_->component[v];
      first_ = v;
      fit_.clear();
      errors_ = {};
      return;
    }
    LinearFit::Vector from, to;
    for (std::size_t i = 0; i < 3; ++i) {
      from[i] = (std::int64_t(row(w)[i]) - row(originals_->of[first_])[i]) >> shift_;
      to[i] = (std::int64_t(row(v)[i]) - row(first_)[i]) >> shift_;
    }
    fit_.add(from, to);
    if (guessed_ != v) return;
    for (unsigned by = 0; by < ways; ++by) {
      std::uint64_t off = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::int64_t d = std::int64_t(row(v)[i]) - guess_[by][i];
        off += static_cast<std::uint64_t>(d < 0 ? -d : d);
      }
      errors_[by] += 4 * static_cast<unsigned>(std::bit_width(off)) - errors_[by] / 4;
    }
  }

 private:
  // What a vertex is predicted by, first those that win where all are alike.
  enum Way : unsigned { middle, corner, plain, ways };

  const Int* row(std::uint32_t v) const { return rows_ + 3 * std::size_t(v); }

  unsigned best() const {
    return static_cast<unsigned>(std::min_element(errors_.begin(), errors_.end()) -
                                 errors_.begin());
  }

  /// A coordinate of the image of a vector below 2^62, within +-2^62.
  static std::int64_t mapped(const LinearFit::Vector& entries, const LinearFit::Vector& vector) {
    std::int64_t high = 0, low = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if constexpr (sizeof(Int) > 4) high += entries[i] * (vector[i] >> 30);
      const std::int64_t rest =
          sizeof(Int) > 4 ? vector[i] & ((std::int64_t(1) << 30) - 1) : vector[i];
      low += entries[i] * rest;
    }
    low = (low + (std::int64_t(1) << (LinearFit::fraction - 1))) >> LinearFit::fraction;
    constexpr std::int64_t most = std::int64_t(1) << 45;
    return std::clamp(high, -most, most) * (std::int64_t(1) << (30 - LinearFit::fraction)) + low;
  }

  const Originals* originals_;
  const Int* rows_;
  std::array<std::int64_t, 3> tops_;
  int shift_ = 0;  // that makes differences short enough for the fit
  std::vector<std::uint8_t> known_;
  std::uint32_t component_ = none, first_ = none;  // what the fit is of
  LinearFit fit_;
  std::array<unsigned, ways> errors_ = {};
  std::uint32_t guessed_ = none;
  std::array<Row, ways> guess_;
};

}  // namespace clers::internal

#endif

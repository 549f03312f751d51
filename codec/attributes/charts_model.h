// How the values of charts are predicted, and how far off predictions are expected to be: what
// encoder and decoder share. It knows the surface and a coder, but no bytes of a file.
#ifndef CLERS_CODEC_ATTRIBUTES_CHARTS_MODEL_H
#define CLERS_CODEC_ATTRIBUTES_CHARTS_MODEL_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "codec/attributes/axis_steps.h"
#include "codec/attributes/charts_apart.h"
#include "codec/attributes/charts_options.h"
#include "codec/attributes/last_at_vertex.h"
#include "codec/attributes/parallelograms.h"
#include "codec/attributes/residual_sizes.h"
#include "codec/attributes/unfolding.h"
#include "codec/attributes/value_repeats.h"
#include "codec/attributes/value_surface.h"
#include "codec/attributes/visit_order.h"
#include "codec/base/portable.h"
#include "codec/entropy/coder.h"
#include "codec/entropy/lanes.h"

namespace clers::internal {

/// Codes values along their surface. Each is predicted from up to three triangles beside it whose
/// values are known, each with one across a side:
///
///        d-----v-----e
///       / \   / \   / \        across a b from o, across b d from d',
///      d'  \ /   \ /   e'      across e a from e'
///           b-----a
///            \   /
///             \ /
///              o
///
/// in two ways: as the parallelogram a + b - o, and by the shape (unfolding.h). The parallelograms'
/// mean is taken where it was nearer around; else the other one.
template <class Int>
class ChartsModel {
 public:
  ChartsModel(std::span<Int> rows, std::span<const Axis> axes, const ValueSurface& along,
              std::span<const GridPlace> places, const ChartsOptions& options)
      : surface_(along.surface),
        along_(along),
        places_(places),
        rows_(rows.data()),
        options_(options),
        wedges_(rows.size() / 2) {
    for (unsigned c = 0; c < 2; ++c) top_[c] = static_cast<std::int64_t>(axes[c].top);
    const auto bits = static_cast<int>(std::bit_width(std::max(axes[0].top, axes[1].top)));
    down_ = sizeof(Int) == 4 ? 0 : std::max(bits - 34, 0);
    for (unsigned c = 0; c < 2; ++c)
      beside_[c] =
          static_cast<std::int64_t>((std::uint64_t(axes[1 - c].scale) << 8) / axes[c].scale);
    if (options.same) last_at_vertex_.emplace(along.vertex_of);
    if (options.likeness && !surface_.twins.empty())
      repeats_.emplace(*options.likeness, rows.data(), wedges_.size(), surface_);
  }

  static std::uint64_t memory(std::uint64_t values) {
    return values * sizeof(Wedge) + ChartShapes::memory() + (1 << 16);
  }

  /// False if no values are what was decoded.
  template <class Coder>
  bool code(Coder& coder) {
    const auto at = [&](std::uint32_t h) {
      if (valid_) code_at(coder, h, next_in(h), previous_in(h));
    };
    if (surface_.twins.empty())
      for_each_introduced(surface_, [&](std::uint32_t t, unsigned i) {
        if (valid_) code_apart(coder, 3 * t + i);
      });
    else if (options_.by_parallelograms)
      for_each_by_parallelograms(surface_, [&](HalfEdge h, const Visited&) { at(h.index()); });
    else
      for_each_introduced(surface_, [&](std::uint32_t t, unsigned i) { at(3 * t + i); });
    for (std::uint32_t v = 0; v < wedges_.size() && valid_; ++v)
      if (!surface_.has(v)) code_start(coder, v);
    return valid_;
  }

 private:
  using Pair = std::array<std::int64_t, 2>;

  /// A value that is known, where it is on the surface, and sizes of what predictions were off: of
  /// its components, more by 1, and of the two ways to predict it.
  struct alignas(8) Wedge {
    std::array<Int, 2> value = {};
    GridPlace place = {};
    std::array<std::uint8_t, 2> size = {};  // 0: not known
    std::uint8_t shape = 0, parallelogram = 0;
  };
  /// Values of a triangle across whose side from a to b another one is predicted.
  struct Beside {
    std::uint32_t a, b, o;
  };

  unsigned known(std::uint32_t v) const { return wedges_[v].size[0] != 0; }
  GridPlace place_of(std::uint32_t v) const {
    const std::uint32_t vertex = along_.vertex(v);
    return vertex < places_.size() ? places_[vertex] : GridPlace{};
  }

  template <class Coder>
  CLERS_ALWAYS_INLINE void code_at(Coder& coder, std::uint32_t h, std::uint32_t next,
                                   std::uint32_t previous) {
    const std::uint32_t* corner = surface_.corners.data();
    const HalfEdge* twin = surface_.twins.data();
    const std::uint32_t v = corner[h], a = corner[next], b = corner[previous];
    // What is not there is v itself, which is not known.
    std::uint32_t o = v, d = v, dd = v, e = v, ee = v;
    if (const HalfEdge out = twin[next]) [[likely]]
      o = corner[previous_in(out.index())];
    if (const HalfEdge out = twin[previous]) [[likely]] {
      d = corner[previous_in(out.index())];
      if (const HalfEdge over = twin[next_in(out.index())]) [[likely]]
        dd = corner[previous_in(over.index())];
    }
    if (const HalfEdge in = twin[h]) [[likely]] {
      const std::uint32_t side = previous_in(in.index());
      e = corner[side];
      if (const HalfEdge over = twin[side]) [[likely]]
        ee = corner[previous_in(over.index())];
    }
    if (last_at_vertex_ && code_same(coder, v)) [[unlikely]]
      return;
    Beside beside[3];
    unsigned n = 0;
    const auto add = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) CLERS_INLINE_LAMBDA {
      beside[n] = {x, y, z};
      n += known(x) & known(y) & known(z);
    };
    add(a, b, o);
    add(b, d, dd);
    add(e, a, ee);
    if (n == 0) [[unlikely]]
      return code_alone(coder, v, a, b);
    code_beside(coder, v, beside, n);
  }

  /// The value of corner h where there are no twins.
  template <class Coder>
  void code_apart(Coder& coder, std::uint32_t h) {
    const std::uint32_t* corner = surface_.corners.data();
    code_alone(coder, corner[h], corner[next_in(h)], corner[previous_in(h)]);
  }

  /// v by the triangles beside it.
  template <class Coder>
  CLERS_ALWAYS_INLINE void code_beside(Coder& coder, std::uint32_t v, const Beside* beside,
                                       unsigned n) {
    if (repeats_ && code_repeat(coder, v, beside[0].a, beside[0].b, beside[0].o)) {
      const Wedge& like = wedges_[beside[0].a];
      return remember(v, like.size, like.shape, like.parallelogram);
    }
    const GridPlace place = place_of(v);
    Pair shaped[3], straight[3];
    int sizes[2] = {}, shape_sizes = 0, parallelogram_sizes = 0;
    for (unsigned i = 0; i < n; ++i) {
      const Wedge &a = wedges_[beside[i].a], &b = wedges_[beside[i].b], &o = wedges_[beside[i].o];
      Unfolded flat;
      const bool unfolds = unfold(a.place, b.place, o.place, place, flat);
      for (unsigned c = 0; c < 2; ++c) {
        const std::int64_t from = a.value[c], to_b = b.value[c] - from, to_o = o.value[c] - from;
        straight[i][c] = 4 * bounded(from + to_b - to_o, top_[c]);
        shaped[i][c] =
            unfolds ? bounded(4 * from + flattened(flat, to_b, to_o), 4 * top_[c]) : straight[i][c];
        sizes[c] += a.size[c] + b.size[c] + o.size[c];
      }
      shape_sizes += a.shape + b.shape + o.shape;
      parallelogram_sizes += a.parallelogram + b.parallelogram + o.parallelogram;
    }
    const Pair by_shape = mean(shaped, n), by_parallelogram = mean(straight, n);
    // Better by half an octave, on average over the 3 n values around.
    const int around = 3 * static_cast<int>(n);
    const bool straighter = shape_sizes > parallelogram_sizes + 2 * around;
    const Pair& predicted = straighter ? by_parallelogram : by_shape;
    std::array<int, 2> expected;
    for (unsigned c = 0; c < 2; ++c) {
      const int usual = (2 * sizes[c] + around) / (2 * around) - 1;
      const std::int64_t apart = n == 1 ? by_shape[c] - by_parallelogram[c] : spread(shaped, n, c);
      expected[c] = (2 * usual + static_cast<int>(size_of(magnitude(apart)))) / 3;
    }
    std::array<std::uint8_t, 2> size;
    for (unsigned c = 0; c < 2; ++c) {
      if (c == 1) expected[1] = (3 * expected[1] + size[0] - 1) / 4;
      const ResidualContext context(2 * c, static_cast<unsigned>(expected[c]));
      const std::int64_t r = code_one(coder, c, v, inside(c, predicted[c]), context, n - 1);
      size[c] = static_cast<std::uint8_t>(size_of(magnitude(r)) + 1);
    }
    remember(v, size, off(v, by_shape), off(v, by_parallelogram));
  }

  /// Quarters of a step from a.
  CLERS_ALWAYS_INLINE std::int64_t flattened(const Unfolded& flat, std::int64_t to_b,
                                             std::int64_t to_o) const {
    return quarters(flat.q * coarse(to_b) - flat.r * coarse(to_o));
  }
  /// A difference that products of 28 bits and it fit 64 bits of.
  CLERS_ALWAYS_INLINE std::int64_t coarse(std::int64_t difference) const {
    return sizeof(Int) == 4 ? difference : difference >> down_;
  }
  /// A product of such a difference and so many 1/2^unfolded_bits.
  CLERS_ALWAYS_INLINE std::int64_t quarters(std::int64_t product) const {
    const std::int64_t to = product >> (unfolded_bits - 2);
    if constexpr (sizeof(Int) == 4) return to;
    constexpr std::int64_t most = std::int64_t(1) << 36;
    return std::clamp(to, -most, most) * (std::int64_t(1) << down_);
  }
  /// Within 0 .. most, where something would overflow if it were not.
  CLERS_ALWAYS_INLINE static std::int64_t bounded(std::int64_t x, std::int64_t most) {
    return sizeof(Int) == 4 ? x : std::clamp<std::int64_t>(x, 0, most);
  }
  /// Within the values that there are, in quarters.
  CLERS_ALWAYS_INLINE std::int64_t inside(unsigned c, std::int64_t quarters) const {
    return std::clamp<std::int64_t>(quarters, 0, 4 * top_[c]);
  }
  CLERS_ALWAYS_INLINE static Pair mean(const Pair* ends, unsigned n) {
    if (n == 1) return ends[0];
    Pair m;
    for (unsigned c = 0; c < 2; ++c)
      m[c] = n == 2 ? (ends[0][c] + ends[1][c]) >> 1
                    : ends[0][c] + (ends[1][c] - ends[0][c]) / 3 + (ends[2][c] - ends[0][c]) / 3;
    return m;
  }
  CLERS_ALWAYS_INLINE static std::int64_t spread(const Pair* ends, unsigned n, unsigned c) {
    std::int64_t low = std::min(ends[0][c], ends[1][c]), high = std::max(ends[0][c], ends[1][c]);
    if (n == 3) {
      low = std::min(low, ends[2][c]);
      high = std::max(high, ends[2][c]);
    }
    return high - low;
  }
  /// The size of what a prediction of v is off.
  CLERS_ALWAYS_INLINE std::uint8_t off(std::uint32_t v, const Pair& predicted) const {
    const Int* row = rows_ + 2 * std::size_t(v);
    return static_cast<std::uint8_t>(
        size_of(std::max(magnitude(4 * std::int64_t(row[0]) - predicted[0]),
                         magnitude(4 * std::int64_t(row[1]) - predicted[1]))));
  }

  /// One component, predicted in quarters. Returns what it is off from that.
  template <class Coder>
  CLERS_ALWAYS_INLINE std::int64_t code_one(Coder& coder, unsigned c, std::uint32_t v,
                                            std::int64_t predicted, ResidualContext context,
                                            unsigned near) {
    Int& value = rows_[2 * std::size_t(v) + c];
    const std::int64_t nearest = (predicted + 2) >> 2, rest = predicted - 4 * nearest;  // -2 .. 1
    // So that the prediction is above: mirror images are the same context.
    const std::int64_t below = -static_cast<std::int64_t>(rest < 0);
    if (options_.fractions && context.octave <= 2 && context.kind <= 2)
      near += 3 * static_cast<unsigned>((rest ^ below) - below);
    std::int64_t r = 0;
    std::uint64_t low = 0;
    if constexpr (Coder::encodes) {
      r = ((std::int64_t(value) - nearest) ^ below) - below;
      low = place_in_bin(r, context.width);
      coder.bits(context.width, low);
    } else {
      low = coder.bits(context.width, 0, 0)[0];
    }
    valid_ &= residuals_.code(coder, c, context, near, low, r);
    if constexpr (!Coder::encodes) put(v, c, nearest + ((r ^ below) - below));
    return 4 * std::int64_t(value) - predicted;
  }
  /// Sets a component to what was decoded, if that may be.
  CLERS_ALWAYS_INLINE void put(std::uint32_t v, unsigned c, std::int64_t x) {
    const bool there = static_cast<std::uint64_t>(x) <= static_cast<std::uint64_t>(top_[c]);
    valid_ &= there;
    rows_[2 * std::size_t(v) + c] = static_cast<Int>(there ? x : 0);
  }

  CLERS_ALWAYS_INLINE void remember(std::uint32_t v, std::array<std::uint8_t, 2> size,
                                    std::uint8_t shape, std::uint8_t parallelogram) {
    const Int* row = rows_ + 2 * std::size_t(v);
    wedges_[v] = {{row[0], row[1]}, place_of(v), size, shape, parallelogram};
    last_ = v;
    if (last_at_vertex_) last_at_vertex_->coded(v);
    if (repeats_ && valid_) [[unlikely]] {
      repeats_->known(v, guessed_);
      guessed_ = ValueRepeats<Int>::nobody;
    }
  }
  /// The same where predictions say nothing of those that follow.
  void remember(std::uint32_t v) {
    const Wedge& like = wedges_[last_];
    std::array<std::uint8_t, 2> size = like.size;
    if (size[0] == 0) size = {1, 1};
    remember(v, size, like.shape, like.parallelogram);
  }

  /// v as the value coded last at its vertex, if there is one and it is; false if not.
  template <class Coder>
  CLERS_NEVER_INLINE bool code_same(Coder& coder, std::uint32_t v) {
    const std::uint32_t u = (*last_at_vertex_)(v);
    if (u == LastAtVertex::none) return false;
    Int *row = rows_ + 2 * std::size_t(v), *same = rows_ + 2 * std::size_t(u);
    const bool is_same =
        coder.flag(2, same_[last_same_], Coder::encodes && row[0] == same[0] && row[1] == same[1]);
    last_same_ = (2 * last_same_ + is_same) % 4;
    if (!is_same) return false;
    std::copy_n(same, 2, row);
    remember(v, wedges_[u].size, wedges_[u].shape, wedges_[u].parallelogram);
    return true;
  }

  /// v as a repetition of a value elsewhere, if it is about one; false if not.
  template <class Coder>
  CLERS_NEVER_INLINE bool code_repeat(Coder& coder, std::uint32_t v, std::uint32_t a,
                                      std::uint32_t b, std::uint32_t o) {
    guessed_ = repeats_->guess(a, b, o);
    if (guessed_ == ValueRepeats<Int>::nobody) return false;
    bool hit = false;
    if constexpr (Coder::encodes) hit = repeats_->is_image(guessed_, v);
    hit = coder.flag(2, hits_[last_hits_], hit);
    last_hits_ = (2 * last_hits_ + hit) % 8;
    if (!hit) return false;
    for (unsigned c = 0; c < 2; ++c) {
      const std::int64_t image = repeats_->image(guessed_, c);
      const bool near = repeats_->reflects() && c == repeats_->axis();
      const std::int64_t given = Coder::encodes ? rows_[2 * std::size_t(v) + c] - image : 0;
      std::int64_t off = 0;
      if (near && coder.flag(2, off_image_[0], given != 0))
        off = coder.flag(2, off_image_[1], given > 0) ? 1 : -1;
      if constexpr (!Coder::encodes) put(v, c, image + off);
    }
    return true;
  }

  /// v without parallelograms, in a triangle with a and b.
  template <class Coder>
  CLERS_NEVER_INLINE void code_alone(Coder& coder, std::uint32_t v, std::uint32_t a,
                                     std::uint32_t b) {
    const bool from_a = a != v && known(a), from_b = b != v && known(b), third = from_a && from_b;
    if (!from_a && !from_b) return code_start(coder, v);
    const std::uint32_t from = from_b ? b : a;
    if (third && repeats_ && code_repeat(coder, v, a, b, ValueRepeats<Int>::nobody))
      return remember(v);
    Int* row = rows_ + 2 * std::size_t(v);
    const std::array<Int, 2> base = wedges_[from].value;
    ChartShapes::Step step{};
    if constexpr (Coder::encodes)
      step = {std::int64_t(row[0]) - base[0], std::int64_t(row[1]) - base[1]};
    shapes_.begin(third);
    if (shapes_.code(coder, 2, step, valid_)) {
      if constexpr (!Coder::encodes)
        for (unsigned c = 0; c < 2; ++c) put(v, c, base[c] + step[c]);
      return remember(v);
    }
    Pair predicted = {4 * std::int64_t(base[0]), 4 * std::int64_t(base[1])};
    if (third) predict_third(coder, v, a, b, predicted);
    for (unsigned c = 0; c < 2; ++c) {
      UsualSize& usual = usual_[1 + third][c];
      usual.learn(magnitude(code_one(coder, c, v, predicted[c], {3 + c, usual.size()}, 1 + third)));
    }
    shapes_.learn({std::int64_t(row[0]) - base[0], std::int64_t(row[1]) - base[1]});
    remember(v);
  }

  /// As a triangle of the same angles, on either side of a-b.
  template <class Coder>
  void predict_third(Coder& coder, std::uint32_t v, std::uint32_t a, std::uint32_t b,
                     Pair& predicted) {
    Unfolded flat;
    if (!unfold_alike(wedges_[a].place, wedges_[b].place, place_of(v), flat)) return;
    const std::array<Int, 2>&from = wedges_[a].value, &to = wedges_[b].value;
    Pair ends[2];
    for (unsigned c = 0; c < 2; ++c) {
      const std::int64_t along = std::int64_t(to[c]) - from[c],
                         across = std::int64_t(to[1 - c]) - from[1 - c];
      const std::int64_t turned = turn(flat.r, across, c);
      const std::int64_t foot = 4 * std::int64_t(from[c]) + flattened({flat.q, 0}, along, 0);
      ends[0][c] = inside(c, foot + (c == 0 ? -turned : turned));
      ends[1][c] = inside(c, foot + (c == 0 ? turned : -turned));
    }
    bool other = false;
    if constexpr (Coder::encodes) {
      const Int* row = rows_ + 2 * std::size_t(v);
      const auto far = [&](const Pair& end) {
        return magnitude(4 * std::int64_t(row[0]) - end[0]) / 2 +
               magnitude(4 * std::int64_t(row[1]) - end[1]) / 2;
      };
      other = far(ends[1]) < far(ends[0]);
    }
    other = coder.flag(2, sides_[last_sides_], other);
    last_sides_ = (2 * last_sides_ + other) % 4;
    predicted = ends[other];
  }
  /// r times what is across, in quarters of steps of the other axis.
  std::int64_t turn(std::int64_t r, std::int64_t across, unsigned c) const {
    constexpr std::int64_t most = std::int64_t(1) << 42;
    return quarters(std::clamp(coarse(across) * beside_[c] >> 8, -most, most) * r);
  }

  template <class Coder>
  void code_start(Coder& coder, std::uint32_t v) {
    for (unsigned c = 0; c < 2; ++c) {
      UsualSize& usual = usual_[0][c];
      usual.learn(
          magnitude(code_one(coder, c, v, 4 * starts_[c].guess(), {3 + c, usual.size()}, 0)));
      starts_[c].learn(rows_[2 * std::size_t(v) + c]);
    }
    remember(v);
  }

  const CodedSurface surface_;
  const ValueSurface& along_;
  const std::span<const GridPlace> places_;
  Int* const rows_;
  const ChartsOptions options_;
  std::array<std::int64_t, 2> top_{};
  int down_ = 0;   ///< bits of differences that are left out of products
  Pair beside_{};  ///< steps of the other axis in one of this, in 1/256
  std::vector<Wedge> wedges_;
  ResidualModel residuals_;
  ChartShapes shapes_;
  ChartStarts starts_[2];
  UsualSize usual_[3][2];  ///< first, second and third values of charts
  std::optional<ValueRepeats<Int>> repeats_;
  std::uint32_t guessed_ = ValueRepeats<Int>::nobody;
  std::optional<LastAtVertex> last_at_vertex_;
  BitModel hits_[8], off_image_[2], sides_[4], same_[4];
  unsigned last_hits_ = 7, last_sides_ = 0, last_same_ = 0;
  std::uint32_t last_ = 0;
  bool valid_ = true;
};

}  // namespace clers::internal

#endif

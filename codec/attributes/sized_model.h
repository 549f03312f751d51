// How positions are predicted, and how far off predictions are expected to be: what encoder and
// decoder share. It knows the surface and a coder, but no bytes of a file.
#ifndef CLERS_CODEC_ATTRIBUTES_SIZED_MODEL_H
#define CLERS_CODEC_ATTRIBUTES_SIZED_MODEL_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <type_traits>
#include <vector>

#include "codec/attributes/axis_steps.h"
#include "codec/attributes/parallelograms.h"
#include "codec/attributes/repetition.h"
#include "codec/attributes/residual_sizes.h"
#include "codec/attributes/sized_around.h"
#include "codec/attributes/sized_guides.h"
#include "codec/attributes/sized_positions.h"
#include "codec/attributes/triples.h"
#include "codec/attributes/visit_order.h"
#include "codec/base/portable.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/coder.h"
#include "codec/entropy/lanes.h"
#include "codec/numbers/lattice.h"
#include "topology/ids.h"

namespace clers::internal {

/// Codes the positions along a surface. Int is that of the rows; Triple what geometry is computed
/// in: Narrow where all axes have one scale, no palette, and tops below narrow_top; else Wide.
///
/// A position is predicted at the mean of up to three parallelograms, each where all its vertices
/// are known:
///
///        d-----v-----e
///       / \   / \   / \        that of the triangle a b v, at a + b - c,
///      d'  \ /   \ /   e'      and of those beside it around v, at b + d - d' and a + e - e'
///           b-----a
///            \   /
///             \ /
///              c
///
/// Along the normal of the first a residual is smaller than in their plane, mostly, and what is
/// known of the one in the plane says more: the vertex lies in the plane. So the axis next to the
/// normal is coded last, its mean lifted by the slope of the plane.
template <class Int, class Triple, VisitOrder order>
class SizedModel {
  static constexpr bool wide = std::is_same_v<Triple, Wide>;
  using Record = Quadruple<typename Triple::Number>;
  static constexpr std::uint32_t nobody = GuidedCoding<Int, Triple>::nobody;

 public:
  SizedModel(const CodedSurface& surface, Lattice<Int> positions, const Guides& guides)
      : surface_(surface),
        rows_(positions.rows.data()),
        count_(static_cast<std::uint32_t>(positions.count())),
        steps_(positions.axes),
        records_(count_),
        guided_(guides, surface, positions, steps_),
        any_guide_(guided_.any()),
        repeated_(guides.repeats, rows_, count_, surface),
        repeats_(repeated_.any()) {}

  /// False if no positions are what was decoded.
  template <class Coder>
  bool code(Coder& coder) {
    if constexpr (order == VisitOrder::parallelograms)
      code_visited(coder);
    else if (surface_.twins.empty())
      for_each_introduced(surface_, [&](std::uint32_t t, unsigned i) {
        code_across(coder, around_apart(surface_, t, i));
      });
    else
      code_introduced(coder);
    for (std::uint32_t v = 0; v < count_; ++v)
      if (!surface_.has(v)) code_beside(coder, v, last_);
    return valid_ && guided_.valid();
  }

 private:
  /// What is known of a vertex: where it is; and the sizes of its residual in the plane and, times
  /// 2^16, across it. Sizes of a known vertex are not 0.
  static unsigned known(const Record& r) { return r.at[3] != 0; }
  static std::uint32_t sizes(const Record& r) { return static_cast<std::uint32_t>(r.at[3]); }

  /// The order does not ask for values, and comes first. So it is known which memory will be read.
  template <class Coder>
  void code_visited(Coder& coder) {
    std::vector<HalfEdge> visited;
    visited.reserve(count_);
    for_each_by_parallelograms(surface_, [&](HalfEdge h, const Visited&) { visited.push_back(h); });
    constexpr std::size_t many = 32;
    std::array<Around, many> batch;
    for (std::size_t begin = 0; begin < visited.size(); begin += many) {
      const std::size_t end = std::min(begin + many, visited.size());
      for (std::size_t i = end; i < std::min(end + many, visited.size()); ++i) {
        fetch(&surface_.corners[visited[i].index()]);
        fetch(&surface_.twins[visited[i].index()]);
      }
      for (std::size_t i = begin; i < end; ++i) {
        const std::uint32_t h = visited[i].index();
        const Around x = around(surface_, h, next_in(h), previous_in(h));
        for (const std::uint32_t u : {x.v, x.a, x.b, x.c, x.d, x.dd, x.e, x.ee})
          fetch(&records_[u]);
        batch[i - begin] = x;
      }
      for (std::size_t i = begin; i < end; ++i) code_across(coder, batch[i - begin]);
    }
  }

  /// As for_each_introduced, but corners 0 and 1 are looked at only where they may introduce.
  template <class Coder>
  void code_introduced(Coder& coder) {
    const std::uint32_t triangles = static_cast<std::uint32_t>(surface_.corners.size() / 3);
    for (std::uint32_t t = 0; t < triangles; ++t) {
      const std::uint32_t* c = surface_.corners.data() + 3 * std::size_t(t);
      const HalfEdge before = surface_.twins[3 * std::size_t(t)];
      if (!before || left(before).index() >= t) [[unlikely]] {
        if (surface_.introduced_by[c[0]] == t) code_beside(coder, c[0], last_);
        if (surface_.introduced_by[c[1]] == t && c[1] != c[0]) code_beside(coder, c[1], c[0]);
      }
      if (surface_.introduced_by[c[2]] == t && c[2] != c[1] && c[2] != c[0])
        code_across(coder, around(surface_, 3 * t + 2, 3 * t, 3 * t + 1));
    }
  }

  /// v by the parallelograms that are known.
  template <class Coder>
  CLERS_ALWAYS_INLINE void code_across(Coder& coder, const Around& at) {
    if (!valid_) return;
    const auto [v, a, b, c, d, dd, e, ee] = at;
    const Record *r = records_.data(), &ra = r[a], &rb = r[b], &rc = r[c], &rd = r[d], &rdd = r[dd],
                 &re = r[e], &ree = r[ee];
    if (!(known(ra) & known(rb) & known(rc))) [[unlikely]]
      return code_beside(coder, v, known(rb) ? b : known(ra) ? a : last_);
    if (any_guide_) [[unlikely]] {
      const std::uint32_t like =
          guided_.code(coder, v, a, b, c, order == VisitOrder::parallelograms, alone(coder, v));
      if (like != nobody) return remember_like(v, like);
    }
    const unsigned left = known(rd) & known(rdd), right = known(re) & known(ree);
    const unsigned n = 1u + left + right;

    // Residuals of those around, and which way the plane is.
    std::uint32_t sum = sizes(ra) + sizes(rb) + sizes(rc);
    sum += (sizes(rd) + sizes(rdd)) & (0u - left);
    sum += (sizes(re) + sizes(ree)) & (0u - right);
    const Triple A(ra), B(rb), C(rc), D(rd), E(re);
    const std::array<std::int64_t, 3> normal = steps_.normal(B - A, B - C);
    const std::int64_t nx = std::abs(normal[0]), ny = std::abs(normal[1]), nz = std::abs(normal[2]);
    const unsigned z = (2u - (ny > nz)) & (0u - !((nx > ny) & (nx > nz)));
    static constexpr std::uint8_t after[] = {1, 2, 0};
    const unsigned x = after[z], y = after[x];

    // The mean, in quarters of a step, and how far the first two are apart.
    const Triple first = steps_.inside(A + B - C);
    const Triple from_left = (steps_.inside(B + D - Triple(rdd)) - first).when(left),
                 from_right = (steps_.inside(A + E - Triple(ree)) - first).when(right);
    const Record start = first.stored(), off = (from_left + from_right).stored(),
                 spread = (from_left + from_right.when(!left)).magnitude().stored();
    std::int64_t mean[3];
    for (unsigned i = 0; i < 3; ++i)
      mean[i] = 4 * std::int64_t(start.at[i]) + steps_.quarters(off.at[i], n);

    // What to expect.
    const auto apart = [&](unsigned i) CLERS_INLINE_LAMBDA {
      return steps_.size(i, 4 * std::uint64_t(spread.at[i]));
    };
    const int plane = expected(n, sum & 0xffff, std::max(apart(x), apart(y))),
              across = expected(n, sum >> 16, apart(z));
    const auto slopes = slopes_of(normal[x], normal[y], normal[z], plane - across);

    Int* row = rows_ + 3 * std::size_t(v);
    if (any_guide_ && guided_.asks()) [[unlikely]] {
      const std::uint32_t like = guided_.code_nearest(coder, v, a, b, mean, alone(coder, v));
      if (like != nobody) return remember_like(v, like);
    }
    const ResidualContext in_x = steps_.context(x, 0, plane), in_y = steps_.context(y, 0, plane),
                          in_z = steps_.context(z, 1, across);
    if (repeats_) [[unlikely]] {
      const unsigned done = repeated_.code(
          {v, a, b, c, known(rd) ? d : v, known(re) ? e : v},
          {start.at[0], start.at[1], start.at[2]},
          [&](unsigned i, BitModel& model, bool yes) { return coder.flag(i, model, yes); });
      const auto code_rest = [&](unsigned lane, unsigned i, std::int64_t from,
                                 ResidualContext context) {
        return done >> i & 1 ? 4 * std::int64_t(row[i]) - from
                             : code_alone(coder, lane, i, row[i], from, context, n);
      };
      const std::int64_t rx = code_rest(0, x, mean[x], in_x), ry = code_rest(1, y, mean[y], in_y),
                         lift = steps_.lift(slopes, {rx, ry}, {x, y, z});
      return remember(v, x, y, z, rx, ry, code_rest(2, z, mean[z] - lift, in_z));
    }
    std::array<std::uint64_t, 3> low{};
    if constexpr (!Coder::encodes) low = coder.bits(in_x.width, in_y.width, in_z.width);
    const std::int64_t rx = code_one(coder, 0, x, row[x], mean[x], in_x, low[0], n);
    const std::int64_t ry = code_one(coder, 1, y, row[y], mean[y], in_y, low[1], n);
    const std::int64_t lifted = mean[z] - steps_.lift(slopes, {rx, ry}, {x, y, z});
    const std::int64_t rz = code_one(coder, 2, z, row[z], lifted, in_z, low[2], n);
    remember(v, x, y, z, rx, ry, rz);
  }

  /// One component whose low bits do not come with those of others.
  template <class Coder>
  CLERS_NEVER_INLINE std::int64_t code_alone(Coder& coder, unsigned lane, unsigned i, Int& value,
                                             std::int64_t mean, ResidualContext context,
                                             unsigned n) {
    std::uint64_t low = 0;
    if constexpr (!Coder::encodes) low = coder.bits(context.width, 0, 0)[0];
    return code_one(coder, lane, i, value, mean, context, low, n);
  }

  /// That for components of v, as guides want it.
  template <class Coder>
  auto alone(Coder& coder, std::uint32_t v) {
    return [this, &coder, v](unsigned i, std::int64_t from, ResidualContext context, unsigned n) {
      code_alone(coder, i, i, rows_[3 * std::size_t(v) + i], 4 * from, context, n);
    };
  }

  /// v by the position of a vertex beside it; where there is none, by 0.
  template <class Coder>
  CLERS_NEVER_INLINE void code_beside(Coder& coder, std::uint32_t v, std::uint32_t from) {
    if (!valid_) return;
    Int* row = rows_ + 3 * std::size_t(v);
    for (unsigned i = 0; i < 3; ++i) {
      const std::int64_t r = code_alone(coder, i, i, row[i], 4 * std::int64_t(records_[from].at[i]),
                                        steps_.context(i, 2, beside_[i] >> 4), 1);
      beside_[i] += (16 * steps_.size(i, magnitude(r)) - beside_[i]) >> 2;
    }
    remember(v);
  }

  /// One component. Returns what it is off from the mean, in quarters.
  template <class Coder>
  CLERS_ALWAYS_INLINE std::int64_t code_one(Coder& coder, unsigned lane, unsigned i, Int& value,
                                            std::int64_t mean, ResidualContext context,
                                            std::uint64_t low, unsigned n) {
    mean = steps_.inside(i, mean);
    const std::int64_t nearest = (mean + 2) >> 2, rest = mean - 4 * nearest;  // -2 .. 1
    // So that the mean is above: mirror images are the same context.
    const std::int64_t below = -static_cast<std::int64_t>(rest < 0);
    const unsigned fraction = static_cast<unsigned>((rest ^ below) - below);
    const unsigned near = n - 1 + 3 * fraction * (context.width <= 1);
    std::int64_t r = 0;
    if constexpr (Coder::encodes) {
      r = steps_.difference(i, std::int64_t(value), nearest);
      r = (r ^ below) - below;
      low = place_in_bin(r, context.width);
      coder.bits(context.width, low);
    }
    valid_ &= residuals_.code(coder, lane, context, near, low, r);
    if constexpr (!Coder::encodes) {
      std::int64_t decoded = 0;
      valid_ &= steps_.apply(i, nearest, (r ^ below) - below, decoded);
      value = static_cast<Int>(decoded);
    }
    return 4 * std::int64_t(value) - mean;
  }

  /// The mean of what n parallelograms' vertices had, two thirds, and of how far two are apart.
  CLERS_ALWAYS_INLINE static int expected(unsigned n, std::uint32_t sum, int apart) {
    // Over the 3, 5 or 7 vertices, in 1/2^16. One parallelogram alone is worse by half an octave.
    static constexpr int of_sum[] = {0, 21846, 8738, 6242}, of_apart[] = {0, 0, 21845, 21845},
                         more[] = {0, 1 << 16, -43690, -43690};
    return std::max((static_cast<int>(sum) * of_sum[n] + apart * of_apart[n] + more[n]) >> 16, 0);
  }

  /// How fast the plane rises along z by x and by y, in 1/2^16; but less where residuals in the
  /// plane are not expected to be larger than those across it by an octave.
  CLERS_ALWAYS_INLINE static std::array<std::int64_t, 2> slopes_of(std::int64_t nx, std::int64_t ny,
                                                                   std::int64_t nz, int larger) {
    const std::int64_t share = std::clamp(larger, 0, 4);
    const int shift = std::max(static_cast<int>(std::bit_width(magnitude(nz) | 1)) - 15, 0);
    const std::int32_t z = static_cast<std::int32_t>(nz >> shift);
    const std::int64_t inverse = (1 << 29) / (z + (z == 0));
    return {((nx >> shift) * inverse >> 15) * share, ((ny >> shift) * inverse >> 15) * share};
  }

  static std::uint32_t sizes_of(int plane, int across) {
    return static_cast<std::uint32_t>((plane + 1) | (across + 1) << 16);
  }
  CLERS_ALWAYS_INLINE void remember(std::uint32_t v, unsigned x, unsigned y, unsigned z,
                                    std::int64_t rx, std::int64_t ry, std::int64_t rz) {
    if constexpr (wide)
      typical_ = sizes_of(std::max(steps_.size(x, magnitude(rx)), steps_.size(y, magnitude(ry))),
                          steps_.size(z, magnitude(rz)));
    else
      typical_ = sizes_of(steps_.size(x, std::max(magnitude(rx), magnitude(ry))),
                          steps_.size(z, magnitude(rz)));
    remember(v);
  }
  /// v, around which residuals are as large as around w.
  CLERS_ALWAYS_INLINE void remember_like(std::uint32_t v, std::uint32_t w) {
    typical_ = sizes(records_[w]);
    remember(v);
  }
  CLERS_ALWAYS_INLINE void remember(std::uint32_t v) {
    using Number = typename Triple::Number;
    const Int* row = rows_ + 3 * std::size_t(v);
    records_[v] = {{static_cast<Number>(row[0]), static_cast<Number>(row[1]),
                    static_cast<Number>(row[2]), static_cast<Number>(typical_)}};
    last_ = v;
    if (any_guide_ && valid_) [[unlikely]]
      guided_.known(v);
    if (repeats_ && valid_) [[unlikely]]
      repeated_.known(v);
  }

  const CodedSurface surface_;
  Int* const rows_;
  const std::uint32_t count_;
  const AxisSteps<Triple> steps_;
  std::vector<Record> records_;
  ResidualModel residuals_;
  GuidedCoding<Int, Triple> guided_;
  const bool any_guide_;
  RepeatedCoordinates<Int> repeated_;
  const bool repeats_;
  int beside_[3] = {};  ///< how far vertices are apart where nothing else is known, in 1/16
  std::uint32_t last_ = 0;
  std::uint32_t typical_ = 0x00010001;  ///< sizes of the last one that was predicted
  bool valid_ = true;
};

/// Calls use(SizedModel) with the one for these axes and this order.
template <class Int, class Use>
auto with_sized_model(const CodedSurface& surface, Lattice<Int> positions, const Guides& guides,
                      VisitOrder order, Use use) {
  const auto with_order = [&]<class Triple>(std::type_identity<Triple>) {
    if (order == VisitOrder::introduction) {
      SizedModel<Int, Triple, VisitOrder::introduction> model(surface, positions, guides);
      return use(model);
    }
    SizedModel<Int, Triple, VisitOrder::parallelograms> model(surface, positions, guides);
    return use(model);
  };
  if constexpr (sizeof(Int) == 4)
    if (AxisSteps<Narrow>::fit(positions.axes)) return with_order(std::type_identity<Narrow>());
  return with_order(std::type_identity<Wide>());
}

}  // namespace clers::internal

#endif

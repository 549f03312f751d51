// The model of positions: what experts say of the next vertex, and what is learned of it. Written
// once for both directions.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_MODEL_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_MODEL_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "codec/attributes/mixed_correction.h"
#include "codec/attributes/mixed_decisions.h"
#include "codec/attributes/mixed_elsewhere.h"
#include "codec/attributes/mixed_mixing.h"
#include "codec/attributes/mixed_past.h"
#include "codec/attributes/mixed_ruler.h"
#include "codec/attributes/mixed_shapes.h"
#include "codec/attributes/mixed_space.h"
#include "codec/attributes/mixed_spread.h"
#include "codec/attributes/mixed_star.h"
#include "codec/attributes/mixed_surroundings.h"
#include "codec/attributes/repetition.h"
#include "codec/attributes/vector.h"
#include "codec/numbers/lattice.h"

namespace clers::internal::mixed {

template <class Int>
class Model {
 public:
  Model(const CodedSurface& surface, const Lattice<Int>& lattice,
        const std::optional<Symmetry>& plane, const Originals* originals, Repetition repetition)
      : rows_(lattice.rows.data()),
        axes_(lattice.axes),
        space_(axes_),
        point_(space_, rows_),
        at_(space_.least_size()),
        past_(space_, lattice.count()),
        edge_((space_.bits() - 4) * fixed::octave),
        lonely_{edge_ - 512, edge_ - 512},
        repeated_(repetition, rows_, lattice.count(), surface) {
    const int first = edge_ - 1024;
    if (plane) image_.emplace(*plane, space_, axes_, rows_, lattice.count(), surface, first);
    if (originals) copy_.emplace(*originals, space_, axes_, rows_, first);
  }

  /// Codes vertex v, whose star is known; `before` was coded before, if there is any. False: what
  /// was decoded is not on its axis.
  template <class Coder>
  bool code(Coder& coder, const Stars& stars, std::uint32_t v, const Star& star,
            std::uint32_t before) {
    if (image_) image_->forget();
    if (copy_) copy_->forget();
    if (star.parallelograms == 0) {
      if (!code_lonely(coder, v, star, before)) return false;
    } else {
      at_.look(point_, star);
      edge_ += (at_.edge - edge_) >> 5;
      predict(stars, v, star);
      if (!code_components(coder, v, code_repeated(coder, v, star))) return false;
      learn(v);
    }
    if (image_) image_->known(v);
    if (copy_) copy_->known(v);
    repeated_.known(v);
    return true;
  }

 private:
  /// The mean of each expert, in the frame.
  void predict(const Stars& stars, std::uint32_t v, const Star& star) {
    const Vector shape = predict_shape(stars, v, star);
    const Recent past = past_.look(star, at_.frame);
    Correction& f = correction_;
    const Vector& from = at_.mean_end;
    f.set(0, at_.ends[0] - from);
    f.set(1, at_.count > 1 ? at_.ends[1] - from : Vector{});
    f.set(2, at_.count > 2 ? at_.ends[2] - from : Vector{});
    f.set(3, (at_.ring - from) * 2);
    f.set(4, (at_.b >> 1) - from);
    f.set(5, (at_.lines - from) * 2);
    f.set(6, (at_.line_a - from) * 2);
    f.set(7, (at_.line_b - from) * 2);
    f.set(8, (shape - from) * 2);
    f.set(9, at_.c - from);
    f.set(10, past.a);
    f.set(11, past.b);
    f.set(12, past.c);
    f.set(13, past.ring);
    f.set(14, past.corners);
    f.set(15, at_.normal * 8);
    const Vector corrected =
        from + clamp(f.predict(std::min(at_.count, 3u) - 1, at_.normal), Frame::most);
    spread_.predict(at_, past, corrected);
    means_ = {from, corrected, at_.lines, from, at_.ends[0], shape, at_.ring, from};
    if (copy_) copy_->predict(v, star, at_, corrected, spread_.across);
    if (image_) image_->predict(point_, star, at_, corrected, spread_.across);
    if (copied()) means_[shape_or_copy] = copy_->mean();
    if (mirrored()) means_[mirror_image] = image_->mean();
    shape_ = shape;
  }
  bool copied() const { return copy_ && copy_->present(); }
  bool mirrored() const { return image_ && image_->present(); }

  /// By the shapes of other vertices, on average over the first parallelograms.
  Vector predict_shape(const Stars& stars, std::uint32_t v, const Star& star) {
    sides_ = std::min(at_.count, most_sides);
    Vector sum;
    for (unsigned i = 0; i < sides_; ++i) {
      const Star::Parallelogram& p = star.parallelogram[i];
      const unsigned key =
          Shapes::key(stars.degree(v), stars.degree(p.a), stars.degree(p.b), stars.degree(p.c));
      side_[i] = Shapes::place(at_.frame.place(point_(p.a)), at_.frame.place(point_(p.b)),
                               at_.normal, key);
      sum += clamp(shapes_.predict(side_[i], at_.normal), Frame::most);
    }
    return mean(sum, sides_);
  }

  /// Scales in the frame, at least a quarter of a step.
  int local(int scale, const Ruler& ruler) const {
    return std::clamp(scale + at_.frame.octaves(), std::max(ruler.step() - 512, 256), 36 * 256);
  }

  /// Which components of v are those of other vertices, a bit for each, if it is no copy and no
  /// image.
  template <class Coder>
  unsigned code_repeated(Coder& coder, std::uint32_t v, const Star& star) {
    if (!repeated_.any() || copied()) return 0;
    const auto [a, b, c] = star.parallelogram[0];
    const auto at = [&](std::uint32_t u, std::size_t i) {
      return std::int64_t(rows_[3 * std::size_t(u) + i]);
    };
    std::array<std::int64_t, 3> ends;
    for (std::size_t i = 0; i < 3; ++i) ends[i] = at(a, i) + at(b, i) - at(c, i);
    const std::uint32_t d = star.ring_size > 2 ? star.ring[2] : v,
                        e = star.ring_size > 3 ? star.ring[star.ring_size - 1] : v;
    return repeated_.code({v, a, b, c, d, e}, ends, [&](unsigned, BitModel& model, bool yes) {
      return coder.bit(model, yes);
    });
  }

  /// All but those that are `done`.
  template <class Coder>
  bool code_components(Coder& coder, std::uint32_t v, unsigned done) {
    std::array<Vector, experts> missed;
    Context context;
    context.support = std::min(at_.count, 3u);
    int farthest = 0;    // by which a lead missed, in 1/128 of its scale
    bool wrong = false;  // whether an image or a copy was far off
    for (unsigned k = 0; k < 3; ++k) {
      const std::size_t c = at_.order[k];
      const Ruler ruler(space_, axes_[c], c, at_.frame);
      std::array<Opinion, experts> opinions;
      for (unsigned i = 0; i < experts; ++i) opinions[i] = opinion(i, k, ruler, missed[i]);
      unsigned lead = opinions[axis_mean].scale + 128 < opinions[corrected_mean].scale
                          ? axis_mean
                          : corrected_mean;
      const auto follow = [&](unsigned i) {
        if (wrong || opinions[i].scale >= opinions[lead].scale) return false;
        lead = i;
        return true;
      };
      context.mode = 0;
      if (copied()) {
        follow(shape_or_copy);
        context.mode = 1;
      }
      if (mirrored()) context.mode = follow(mirror_image) ? 3 : 2;
      context.component = k;
      context.missed = k == 0 ? 0 : farthest < 64 ? 0 : farthest < 128 ? 1 : farthest < 256 ? 2 : 3;
      context.scale = scale_context(opinions[lead], ruler);
      mixing_.set(context);
      if ((done >> c & 1) == 0 && !code_one(coder, ruler, opinions, lead, v, c)) return false;
      set_place(v, c);
      farthest = std::max(farthest, distance(opinions[lead], place_[c]));
      const auto far_off = [&](unsigned i, int scale) {
        const int usual = std::max(scale, space_.step(c));
        return at_.size(place_[c] - opinions[i].mean) > usual + 512;
      };
      if (copied()) wrong = wrong || far_off(shape_or_copy, copy_->scale());
      if (mirrored()) wrong = wrong || far_off(mirror_image, image_->sure());
      for (unsigned i = 0; i < experts; ++i) missed[i][k] = place_[c] - means_[i][c];
    }
    return true;
  }

  /// What expert i says of the k-th component, given what it missed the ones before by.
  Opinion opinion(unsigned i, unsigned k, const Ruler& ruler, const Vector& missed) const {
    const std::size_t c = at_.order[k];
    std::int64_t where = means_[i][c];
    int scale = spread_.across + spread_.covariance.scale[k] + spread_.bias(i);
    if (i == axis_mean) {
      scale = spread_.axis[c];
    } else {
      if (k == 1) where += spread_.covariance.second(missed[0]);
      if (k == 2) where += spread_.covariance.third(missed[0], missed[1]);
      if (i == shape_or_copy && copied()) scale = copy_->scale();
      if (i == mirror_image && mirrored()) scale = image_->scale(c);
    }
    return {std::clamp(where, -4 * Frame::most, 4 * Frame::most), local(scale, ruler)};
  }

  static unsigned scale_context(const Opinion& opinion, const Ruler& ruler) {
    const int octave = (opinion.scale - ruler.step()) >> 8;
    return static_cast<unsigned>(std::clamp(octave + 1, 0, int(Context::scales) - 1));
  }

  template <class Coder>
  bool code_one(Coder& coder, const Ruler& ruler, const std::array<Opinion, experts>& opinions,
                unsigned lead, std::uint32_t v, std::size_t c) {
    Int& integer = rows_[3 * std::size_t(v) + c];
    std::uint64_t value = static_cast<std::uint64_t>(integer);
    // The image is the last expert.
    ComponentCoder<Coder> component(coder, mixing_, ruler, opinions,
                                    mirrored() ? experts : mirror_image);
    if (!component.code(opinions[lead], value)) return false;
    integer = static_cast<Int>(value);
    return true;
  }
  /// Component c of v is known.
  void set_place(std::uint32_t v, std::size_t c) {
    const Int integer = rows_[3 * std::size_t(v) + c];
    place_[c] = Frame::scaled(space_.coordinate(c, integer) - at_.frame.origin[c], at_.frame.finer);
  }

  void learn(std::uint32_t v) {
    if (copied()) copy_->learn(at_, place_);
    if (mirrored()) image_->learn(at_, place_);
    means_[shape_or_copy] = shape_;
    for (unsigned i = 0; i < sides_; ++i) shapes_.learn(side_[i], place_, at_.normal);
    const Vector left = place_ - means_[corrected_mean];
    correction_.learn(left, 3 * at_.length(spread_.along), 3 * at_.length(spread_.across));
    spread_.learn(at_, place_, means_);
    past_.remember(v, at_, left, place_ - means_[plain_mean]);
  }

  /// Codes a vertex that no parallelogram predicts: by the mean of known neighbours, or by the
  /// vertex before. All experts say the same.
  template <class Coder>
  bool code_lonely(Coder& coder, std::uint32_t v, const Star& star, std::uint32_t before) {
    const unsigned n = star.ring_size;
    int& scale = lonely_[n == 0];
    at_.look_nowhere(n != 0                ? point_(star.ring[0])
                     : before != no_vertex ? point_(before)
                                           : space_.middle(),
                     std::min(Frame::edge_bits - (scale >> 8), Frame::edge_bits));
    Vector sum;
    for (unsigned i = 0; i < n; ++i) sum += at_.frame.place(point_(star.ring[i]));
    const Vector from = n != 0 ? mean(sum, n) : Vector{};
    Context context;
    for (unsigned c = 0; c < 3; ++c) {
      const Ruler ruler(space_, axes_[c], c, at_.frame);
      std::array<Opinion, experts> opinions;
      opinions.fill({from[c], local(scale, ruler)});
      context.component = c;
      context.scale = scale_context(opinions[0], ruler);
      mixing_.set(context);
      if (!code_one(coder, ruler, opinions, corrected_mean, v, c)) return false;
      set_place(v, c);
    }
    scale += static_cast<int>(excess(at_.size(place_ - from), scale)) / 4;
    past_.remember(v, edge_ - 512);
    return true;
  }

  static constexpr unsigned most_sides = 3;

  Int* rows_;
  std::span<const Axis> axes_;
  Space space_;
  Points<Int> point_;
  Surroundings at_;
  Past past_;
  int edge_;       ///< log2 of edges' lengths, on average
  int lonely_[2];  ///< scales where there are neighbours, and where there are none
  Correction correction_;
  Spread spread_;
  Shapes shapes_;
  Mixing mixing_;
  std::optional<ImageExpert<Int>> image_;
  std::optional<CopyExpert<Int>> copy_;
  RepeatedCoordinates<Int> repeated_;

  // Of the vertex that is coded.
  std::array<Vector, experts> means_;
  Vector shape_, place_;
  Shapes::Place side_[most_sides];
  unsigned sides_ = 0;
};

}  // namespace clers::internal::mixed

#endif

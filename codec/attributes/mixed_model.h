// The model of positions: what experts say of the next vertex, and what is learned of it.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_MODEL_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_MODEL_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "codec/attributes/copies.h"
#include "codec/attributes/lattice.h"
#include "codec/attributes/mixed_correction.h"
#include "codec/attributes/mixed_covariance.h"
#include "codec/attributes/mixed_decisions.h"
#include "codec/attributes/mirror.h"
#include "codec/attributes/mixed_guess.h"
#include "codec/attributes/mixed_mixing.h"
#include "codec/attributes/mixed_scales.h"
#include "codec/attributes/mixed_space.h"
#include "codec/attributes/mixed_star.h"
#include "codec/attributes/vector.h"

namespace clers::internal::mixed {

/// What is remembered of a vertex: its residual, and the sizes of that.
struct Past {
  std::int32_t residual[3];
  std::int16_t along, across;  ///< log2 in 1/256, of coordinates
  std::int16_t axis[3];
};

template <class Int>
class Model {
 public:
  Model(const CodedSurface& surface, const Lattice<Int>& lattice,
        const std::optional<MirrorPlane>& plane, const Originals* originals)
      : rows_(lattice.rows.data()), axes_(lattice.axes), space_(axes_), past_(lattice.count()) {
    coarser_ = static_cast<int>(space_.bits() > 31 ? space_.bits() - 31 : 0) - 4;
    edge_log_ = static_cast<int>(space_.bits()) * 256 - 1024;
    lonely_[0] = lonely_[1] = edge_log_ - 512;
    least_size_ = std::min({space_.step(0), space_.step(1), space_.step(2)}) - 512;
    if (space_.drop()) least_size_ = -512;
    if (plane) mirror_.emplace(*plane, rows_, lattice.count(), surface);
    if (originals) copies_.emplace(*originals, rows_, axes_);
    guess_[0].emplace(edge_log_ - 1024);
    guess_[1].emplace(edge_log_ - 1024);
    guess_[2].emplace(edge_log_ - 1024);
    mirror_axis_ = plane ? plane->axis : 0;
  }

  /// Codes vertex v, about which the star is known; before: a vertex coded before, if there is any.
  template <class Coder>
  bool code(Coder& coder, std::uint32_t v, const Star& star, std::uint32_t before) {
    partner_ = Mirror<Int>::nobody;
    if (star.parallelograms == 0) {
      if (!code_lonely(coder, v, star, before)) return false;
    } else {
      look(star);
      predict(star);
      guess(v, star);
      if (!code_components(coder, v, star)) return false;
    }
    if (mirror_) mirror_->known(v, partner_);
    if (copies_) copies_->known(v);
    return true;
  }

 private:
  Vector point(std::uint32_t v) const { return space_.point(rows_ + 3 * std::size_t(v)); }

  static std::int64_t part(unsigned n) { return 65536 / n; }

  void look(const Star& star) {
    const Star::Parallelogram& gate = star.parallelogram[0];
    const Vector a = point(gate.a), b = point(gate.b), c = point(gate.c);
    const std::int64_t length =
        std::max({largest(a - b), largest(a - c), largest(b - c), std::int64_t(1)});
    frame_.origin = a;
    frame_.finer = 20 - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(length)));
    const Vector edge = frame_.local(b - a), side = frame_.local(c - a);
    const auto square = [](Vector d) {
      d = d >> 4;
      return static_cast<std::uint64_t>(dot(d, d));
    };
    const std::uint64_t squares = square(edge) + square(side) + square(edge - side);
    edge_ = (fixed::log2(squares) + 8 * 256 - 406) / 2;  // of a third of them
    edge_log_ += (edge_ - frame_.finer * 256 - edge_log_) >> 5;

    // parallelograms
    const unsigned n = star.parallelograms;
    Vector sum, normal;
    for (unsigned i = 0; i < n; ++i) {
      const Star::Parallelogram& p = star.parallelogram[i];
      const Vector x = point(p.a), y = point(p.b), z = point(p.c);
      ends_[i] = frame_.local(x + y - z - a);
      sum += ends_[i];
      normal += cross(frame_.local(x - z) >> 4, frame_.local(y - z) >> 4);
    }
    mean_ = sum * part(n) >> 16;
    set_normal(normal);

    const unsigned ring = star.ring_size;
    Vector around;
    for (unsigned i = 0; i < ring; ++i) {
      places_[i] = frame_.local(point(star.ring[i]) - a);
      around += places_[i];
    }
    ring_mean_ = around * part(ring) >> 16;

    Vector lines;
    line_a_ = line_b_ = mean_;
    for (unsigned i = 0; i < star.lines; ++i) {
      const Star::Line& l = star.line[i];
      const Vector w = frame_.local(point(l.w[0]) - a), u = frame_.local(point(l.w[1]) - a);
      const Vector end = places_[l.at] * 2 - ((w + u) >> 1);
      lines += end;
      if (star.ring[l.at] == gate.a) line_a_ = end;
      if (star.ring[l.at] == gate.b) line_b_ = end;
    }
    lines_ = star.lines ? lines * part(star.lines) >> 16 : mean_;
    middle_ = edge >> 1;
    tip_ = side;
  }

  void set_normal(Vector n) {
    const std::int64_t size = largest(n);
    normal_ = {};
    if (size != 0) {
      const int shift = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(size))) - 15;
      const Vector v = shift >= 0 ? n >> shift : n * (std::int64_t(1) << -shift);
      normal_ = v * fixed::inverse_root(static_cast<std::uint64_t>(dot(v, v))) >> 16;
    }
    order_ = axis_order(normal_);
  }

  Vector residual(std::uint32_t v) const {
    const Past& p = past_[v];
    const int shift = frame_.finer + coarser_;
    const Vector r = {p.residual[0], p.residual[1], p.residual[2]};
    return clamp(shift >= 0 ? r * (std::int64_t(1) << shift) : r >> -shift, Frame::most);
  }

  void predict(const Star& star) {
    const Star::Parallelogram& gate = star.parallelogram[0];
    const unsigned n = star.parallelograms;
    class_ = std::min(n, 3u) - 1;
    Vector around, across_from;
    int sum[5] = {};
    for (unsigned i = 0; i < star.ring_size; ++i) {
      const Past& p = past_[star.ring[i]];
      around += residual(star.ring[i]);
      sum[0] += p.along, sum[1] += p.across;
      for (unsigned c = 0; c < 3; ++c) sum[2 + c] += p.axis[c];
    }
    around = around * part(star.ring_size) >> 16;
    for (int& s : sum) s = static_cast<int>(s * part(star.ring_size) >> 16);
    for (unsigned i = 0; i < n; ++i) across_from += residual(star.parallelogram[i].c);
    across_from = across_from * part(n) >> 16;

    Correction& f = correction_;
    f.set(0, ends_[0] - mean_);
    f.set(1, n > 1 ? ends_[1] - mean_ : Vector{});
    f.set(2, n > 2 ? ends_[2] - mean_ : Vector{});
    f.set(3, ring_mean_ - mean_);
    f.set(4, middle_ - mean_);
    f.set(5, lines_ - mean_);
    f.set(6, line_a_ - mean_);
    f.set(7, line_b_ - mean_);
    f.set(8, Vector{});
    f.set(9, tip_ - mean_);
    f.set(10, residual(gate.a));
    f.set(11, residual(gate.b));
    f.set(12, residual(gate.c));
    f.set(13, around);
    f.set(14, across_from);
    f.set(15, normal_ * 32);
    corrected_ = mean_ + clamp(correction_.predict(class_, normal_), Frame::most);

    // Scales.
    const Past &a = past_[gate.a], &b = past_[gate.b], &c = past_[gate.c];
    const int edge = edge_ - frame_.finer * 256;
    base_[0] = (2 * sum[0] + a.along + b.along) / 4;
    base_[1] = (2 * sum[1] + a.across + b.across) / 4;
    int spread[2] = {base_[0], base_[1]};
    if (n > 1) sizes(ends_[1] - ends_[0], spread[0], spread[1]);
    Features<16>& g = features_;
    g.set(0, 256);
    g.set(1, base_[0] - base_[1]);
    g.set(2, base_[0] - edge);
    g.set(3, edge / 4);
    g.set(4, a.along - base_[0]);
    g.set(5, b.along - base_[0]);
    g.set(6, c.along - base_[0]);
    g.set(7, n == 1 ? 256 : 0);
    g.set(8, a.across - base_[1]);
    g.set(9, b.across - base_[1]);
    g.set(10, c.across - base_[1]);
    g.set(11, n > 2 ? 256 : 0);
    g.set(12, spread[0] - base_[0]);
    g.set(13, spread[1] - base_[1]);
    g.set(14, star.lines ? size(lines_ - mean_) - base_[1] : 0);
    g.set(15, size(corrected_ - mean_) - base_[1]);
    inverse_power_ = g.inverse_power();
    along_ = base_[0] + along_of_.predict(g);
    across_ = base_[1] + across_of_.predict(g);
    covariance_.set(normal_, order_, along_, across_);

    int whole[3];
    for (unsigned k = 0; k < 3; ++k) {
      // Not given the other components.
      const unsigned c2 = order_[k];
      whole[c2] = k == 0 ? across_ + covariance_.scale[0] : 0;
    }
    for (unsigned i = 0; i < 3; ++i) {
      const std::int64_t ni = normal_[i];
      const int ratio = std::clamp(2 * (along_ - across_), -2048, 2048);
      const std::int64_t p = static_cast<std::int64_t>(fixed::exp2(ratio)) - 65536;
      whole[i] = across_ + (fixed::log2(static_cast<std::uint64_t>(
                                std::max<std::int64_t>(65536 + (p * (ni * ni >> 12) >> 16), 64))) -
                            4096) /
                               2;
      axis_base_[i] = (2 * sum[2 + i] + a.axis[i] + b.axis[i]) / 4;
      Features<8>& h = axis_features_[i];
      h.set(0, 256);
      h.set(1, whole[i] - axis_base_[i]);
      h.set(2, axis_base_[i] - edge);
      h.set(3, a.axis[i] - axis_base_[i]);
      h.set(4, b.axis[i] - axis_base_[i]);
      h.set(5, c.axis[i] - axis_base_[i]);
      h.set(6, n == 1 ? 256 : 0);
      h.set(7, n > 1 ? size1(ends_[1][i] - ends_[0][i]) - axis_base_[i] : 0);
      axis_[i] = axis_base_[i] + axis_of_[i].predict(h);
    }
  }

  /// log2 of lengths in coordinates.
  int size1(std::int64_t d) const {
    const int s = fixed::log2(static_cast<std::uint64_t>(d < 0 ? -d : d)) - frame_.finer * 256;
    return std::max(s, least_size_);
  }
  int size(Vector d) const {
    d = clamp(d, Frame::most);
    const int s = fixed::log2(static_cast<std::uint64_t>(dot(d, d))) / 2 - frame_.finer * 256;
    return std::max(s, least_size_);
  }
  void sizes(Vector d, int& along, int& across) const {
    d = clamp(d, Frame::most);
    const std::int64_t n = dot(d, normal_) >> 14;
    along = size1(n);
    const std::int64_t rest = std::max<std::int64_t>(dot(d, d) - n * n, 0);
    across = std::max(fixed::log2(static_cast<std::uint64_t>(rest)) / 2 - 128 - frame_.finer * 256,
                      least_size_);
  }

  /// Experts that know of other places.
  void guess(std::uint32_t v, const Star& star) {
    present_ = 0x5f;
    const Star::Parallelogram& gate = star.parallelogram[0];
    const int edge = edge_ - frame_.finer * 256;
    const auto place = [&](const std::array<Int, 3>& row) { return frame_.local(space_.point(row.data()) - frame_.origin); };
    if (copies_) {
      std::array<Int, 3> row;
      if (copies_->guess(v, gate.a, gate.b, gate.c, row.data())) {
        present_ |= 1 << 5;
        copy_ = place(row);
        const int expected = static_cast<int>(copies_->expected()) * 16 - 256;
        guess_[0]->predict(expected, least_size_, size(copy_ - corrected_), across_, edge);
      }
    }
    if (mirror_) {
      std::array<Int, 3> row;
      for (std::size_t i = 0; i < 3; ++i)
        row[i] = integer(i, corrected_[static_cast<unsigned>(i)]);
      partner_ = mirror_->guess(gate.a, gate.b, row.data());
      if (partner_ != Mirror<Int>::nobody) {
        present_ |= 1 << 7;
        for (std::size_t i = 0; i < 3; ++i) row[i] = mirror_->image(partner_, i);
        image_ = place(row);
        image_[mirror_axis_] += frame_.finer >= 8 ? shift_ * (std::int64_t(1) << (frame_.finer - 8)) : shift_ >> (8 - frame_.finer);
        const Vector a = mismatch(gate.a), b = mismatch(gate.b), d = image_ - corrected_;
        guess_[1]->predict(size1(a[mirror_axis_]), size1(b[mirror_axis_]), size1(d[mirror_axis_]),
                           across_, edge);
        guess_[2]->predict(size(beside(a)), size(beside(b)), size(beside(d)), across_, edge);
      }
    }
  }

  /// The integer on an axis that is at a place in the frame, within the axis.
  Int integer(std::size_t axis, std::int64_t place) const {
    const unsigned c = static_cast<unsigned>(axis);
    const std::int64_t x = frame_.origin[c] + (frame_.finer >= 0 ? place >> frame_.finer : place * (std::int64_t(1) << -frame_.finer));
    const std::int64_t k = x <= 0 ? 0 : space_.scale(c) == 1 ? x : x / space_.scale(c);
    return static_cast<Int>(std::min(k, static_cast<std::int64_t>(axes_[axis].top) >> space_.drop()) << space_.drop());
  }

  /// From a vertex to the image of its partner.
  Vector mismatch(std::uint32_t v) const {
    const std::uint32_t w = mirror_->partner(v);
    if (w == Mirror<Int>::nobody) {
      const auto usual = static_cast<std::int64_t>(fixed::exp2(std::clamp(across_ + frame_.finer * 256, 0, 28 * 256)) >> 16);
      return {usual, usual, usual};
    }
    std::array<Int, 3> row;
    for (std::size_t i = 0; i < 3; ++i) row[i] = mirror_->image(w, i);
    return frame_.local(space_.point(row.data()) - point(v));
  }
  /// What of a vector is not along the mirror's axis.
  Vector beside(Vector d) const {
    d[mirror_axis_] = 0;
    return d;
  }

  int local_scale(int scale, int step) const {
    return std::clamp(scale + frame_.finer * 256, std::max(step - 512, 256), 36 * 256);
  }

  template <class Coder>
  bool code_components(Coder& coder, std::uint32_t v, const Star& star) {
    const Vector means[experts] = {mean_, corrected_, lines_, mean_, ends_[0], copy_, ring_mean_, image_};
    std::int64_t missed[2][experts];
    Int* const row = rows_ + 3 * std::size_t(v);
    Context context;
    context.support = std::min(star.parallelograms, 3u);
    int farthest = 0;
    bool wrong = false;
    for (unsigned k = 0; k < 3; ++k) {
      const unsigned c = order_[k];
      const Ruler ruler(space_, axes_[c], c, frame_);
      std::array<Opinion, experts> opinions;
      const int common = across_ + covariance_.scale[k];
      for (unsigned i = 0; i < experts; ++i) {
        Opinion& o = opinions[i];
        o.mean = means[i][c];
        int scale = common;
        if (i == 3) {
          scale = axis_[c];
        } else if (i == 5 || i == 7) {
          scale = guess_[i == 5 ? 0 : c == mirror_axis_ ? 1 : 2]->scale();
        } else {
          if (k == 1) o.mean += covariance_.second(missed[0][i]);
          if (k == 2) o.mean += covariance_.third(missed[0][i], missed[1][i]);
          if (i != 1) scale += bias_[i] >> 8;
        }
        o.mean = std::clamp(o.mean, -4 * Frame::most, 4 * Frame::most);
        o.scale = local_scale(scale, ruler.step());
      }
      unsigned lead = opinions[3].scale + 128 < opinions[1].scale ? 3 : 1;
      context.mode = 0;
      for (const unsigned i : {5u, 7u}) {
        if ((present_ >> i & 1) == 0) continue;
        const bool leads = opinions[i].scale < opinions[lead].scale && !wrong;
        if (leads) lead = i;
        context.mode = i == 5 ? 1 : leads ? 3 : 2;
      }
      context.component = k;
      context.missed = k == 0 ? 0 : farthest < 64 ? 0 : farthest < 128 ? 1 : farthest < 256 ? 2 : 3;
      const int octave = (opinions[lead].scale - ruler.step()) >> 8;
      context.scale = static_cast<unsigned>(std::clamp(octave + 1, 0, 7));
      mixing_.set(context);
      std::uint64_t value = static_cast<std::uint64_t>(row[c]);
      if (!code_component(coder, mixing_, ruler, opinions, present_, lead, value)) return false;
      row[c] = static_cast<Int>(value);
      const std::int64_t place = Frame::scaled(
          (static_cast<std::int64_t>(value) >> space_.drop()) * space_.scale(c) - frame_.origin[c],
          frame_.finer);
      if (k < 2) {
        for (const unsigned i : {5u, 7u}) {
          if ((present_ >> i & 1) == 0) continue;
          const std::int64_t off = place - opinions[i].mean;
          wrong = wrong || size1(off) > std::max(guess_[i == 5 ? 0 : 2]->scale(), ruler.step() - frame_.finer * 256) + 512;
        }
        for (unsigned i = 0; i < experts; ++i) missed[k][i] = place - means[i][c];
        const std::int64_t off = place - opinions[lead].mean;
        const std::int64_t by =
            (off < 0 ? -off : off) *
                fixed::tables::powers[static_cast<std::size_t>(-opinions[lead].scale & 255)] >>
            (9 - ((-opinions[lead].scale) >> 8));
        farthest = std::max(farthest, static_cast<int>(std::min<std::int64_t>(by, 10000)));
      }
      place_[c] = place;
    }
    learn(v);
    return true;
  }

  void learn(std::uint32_t v) {
    int along, across;
    const Vector error = place_ - corrected_;
    sizes(error, along, across);
    const std::int64_t rate = rate_.next();
    const std::int64_t e0 = excess(along, along_), e1 = excess(across, across_);
    along_of_.learn(features_, inverse_power_, rate, e0);
    across_of_.learn(features_, inverse_power_, rate, e1);
    if (present_ >> 5 & 1) guess_[0]->learn(size(place_ - copy_));
    if (present_ >> 7 & 1) {
      const Vector off = place_ - image_;
      guess_[1]->learn(size1(off[mirror_axis_]));
      guess_[2]->learn(size(beside(off)));
      const std::int64_t o = off[mirror_axis_];
      const std::int64_t most = std::int64_t(256) * space_.scale(mirror_axis_);
      const std::int64_t moved = frame_.finer >= 8 ? o >> (frame_.finer - 8) : o * (std::int64_t(1) << (8 - frame_.finer));
      shift_ += std::clamp(moved, -most, most) >> 5;
    }
    const Vector others[experts] = {mean_,    corrected_, lines_,     mean_,
                                    ends_[0], mean_,      ring_mean_, mean_};
    for (const unsigned i : {0u, 2u, 4u, 6u}) {
      int n, t;
      sizes(place_ - others[i], n, t);
      bias_[i] += static_cast<int>(
          (rate * (excess(n, along_ + (bias_[i] >> 8)) + excess(t, across_ + (bias_[i] >> 8)))) >>
          9);
    }
    const Vector plain = place_ - mean_;
    for (unsigned i = 0; i < 3; ++i)
      axis_of_[i].learn(axis_features_[i], axis_features_[i].inverse_power(), rate,
                        excess(size1(plain[i]), axis_[i]));
    const auto three = [&](int scale) {
      return static_cast<std::int64_t>(
          fixed::exp2(std::clamp(scale + frame_.finer * 256, 0, 28 * 256)) * 3 >> 16);
    };
    correction_.learn(place_ - corrected_, three(along_), three(across_));
    remember(v, plain, place_ - corrected_);
  }

  void remember(std::uint32_t v, Vector residual, Vector error) {
    Past& p = past_[v];
    int along, across;
    sizes(residual, along, across);
    const int shift = frame_.finer + coarser_;
    const Vector r = clamp(shift >= 0 ? error >> shift : error * (std::int64_t(1) << -shift), 0x7fffffff);
    for (unsigned i = 0; i < 3; ++i) {
      p.residual[i] = static_cast<std::int32_t>(r[i]);
      p.axis[i] = static_cast<std::int16_t>(size1(residual[i]));
    }
    p.along = static_cast<std::int16_t>(along);
    p.across = static_cast<std::int16_t>(across);
  }

  template <class Coder>
  bool code_lonely(Coder& coder, std::uint32_t v, const Star& star, std::uint32_t before) {
    normal_ = {};
    const unsigned n = star.ring_size;
    int& scale = lonely_[n == 0];
    frame_.finer = std::min(20 - (scale >> 8), 20);
    frame_.origin = n ? point(star.ring[0]) : before != no_vertex ? point(before) : Vector{};
    mean_ = {};
    for (unsigned i = 0; i < n; ++i) mean_ += frame_.local(point(star.ring[i]) - frame_.origin);
    if (n) mean_ = mean_ * part(n) >> 16;
    if (!n && before == no_vertex)
      mean_ = frame_.local(Vector{std::int64_t(axes_[0].top >> space_.drop()) * space_.scale(0),
                                  std::int64_t(axes_[1].top >> space_.drop()) * space_.scale(1),
                                  std::int64_t(axes_[2].top >> space_.drop()) * space_.scale(2)} >>
                           1);
    Int* const row = rows_ + 3 * std::size_t(v);
    Context context;
    for (unsigned c = 0; c < 3; ++c) {
      const Ruler ruler(space_, axes_[c], c, frame_);
      std::array<Opinion, experts> opinions;
      opinions.fill({mean_[c], local_scale(scale, ruler.step())});
      context.component = c;
      context.scale =
          static_cast<unsigned>(std::clamp(((opinions[0].scale - ruler.step()) >> 8) + 1, 0, 7));
      mixing_.set(context);
      std::uint64_t value = static_cast<std::uint64_t>(row[c]);
      if (!code_component(coder, mixing_, ruler, opinions, 0x5f, 0, value)) return false;
      row[c] = static_cast<Int>(value);
      place_[c] = Frame::scaled(
          (static_cast<std::int64_t>(value) >> space_.drop()) * space_.scale(c) - frame_.origin[c],
          frame_.finer);
    }
    const Vector error = place_ - mean_;
    scale += static_cast<int>(excess(size(error), scale)) / 4;
    remember(v, Vector{}, Vector{});
    Past& p = past_[v];
    p.along = p.across = p.axis[0] = p.axis[1] = p.axis[2] =
        static_cast<std::int16_t>(edge_log_ - 512);
    return true;
  }

  Int* rows_;
  std::span<const Axis> axes_;
  Space space_;
  std::vector<Past> past_;
  int coarser_, edge_log_, least_size_, lonely_[2];

  Frame frame_;
  Vector normal_, mean_, corrected_, lines_, line_a_, line_b_, ring_mean_, middle_, tip_, place_;
  Vector ends_[Star::most_parallelograms], places_[Star::most_ring];
  AxisOrder order_ = {};
  Covariance covariance_;
  int edge_ = 0, along_ = 0, across_ = 0, base_[2], axis_[3], axis_base_[3];
  unsigned class_ = 0;
  Features<16> features_;
  Features<8> axis_features_[3];
  std::int64_t inverse_power_ = 0;
  Regression<16> along_of_, across_of_;
  Regression<8> axis_of_[3];
  int bias_[experts] = {};
  Rate rate_;
  std::optional<Mirror<Int>> mirror_;
  std::optional<Copies<Int>> copies_;
  std::optional<Guess> guess_[3];
  unsigned mirror_axis_ = 0;
  std::int64_t shift_ = 0;
  Vector copy_, image_;
  std::uint32_t partner_ = 0;
  unsigned present_ = 0;
  Correction correction_;
  Mixing mixing_;
};

}  // namespace clers::internal::mixed

#endif

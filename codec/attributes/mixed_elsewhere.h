// Experts that know of other places: the mirror image, and the component that this is a copy of.
// What else is like a vertex says where it is, and how far off that is, is learned from how far off
// it was.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_ELSEWHERE_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_ELSEWHERE_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "codec/attributes/copies.h"
#include "codec/attributes/mirror.h"
#include "codec/attributes/mixed_scales.h"
#include "codec/attributes/mixed_space.h"
#include "codec/attributes/mixed_star.h"
#include "codec/attributes/mixed_surroundings.h"
#include "codec/attributes/vector.h"

namespace clers::internal::mixed {

/// The scale of such an expert. Sizes are log2 in 1/256, of coordinates.
class Trust {
 public:
  explicit Trust(int first) : usual_(first), last_(first) {}

  /// Given two sizes that tell of it, the distance to the corrected mean, the scale of that across
  /// the normal, and the length of edges.
  void predict(int here, int there, int distance, int others, int edge) {
    Features<8>& f = features_;
    f.set(0, 256);
    f.set(1, last_ - usual_);
    f.set(2, here - usual_);
    f.set(3, there - usual_);
    f.set(4, distance - usual_);
    f.set(5, others - usual_);
    f.set(6, edge - usual_);
    f.set(7, distance > others + 384 ? 256 : 0);
    scale_ = usual_ + regression_.predict(f);
  }
  int scale() const { return scale_; }
  void learn(int size) {
    regression_.learn(features_, features_.inverse_power(), rate_.next(), excess(size, scale_));
    last_ = size;
    usual_ += (size - usual_) / 8;
  }

 private:
  int usual_, last_, scale_ = 0;
  Features<8> features_;
  Regression<8> regression_;
  Rate rate_;
};

/// The mirror image, whose coordinate along the mirrored axis is less sure than the others: the
/// plane may be anywhere between two that the lattice has.
template <class Int>
class ImageExpert {
 public:
  ImageExpert(const Symmetry& plane, const Space& space, std::span<const Axis> axes,
              const Int* rows, std::size_t vertices, const CodedSurface& surface, int first)
      : mirror_(plane, rows, vertices, surface),
        space_(&space),
        axes_(axes),
        axis_(plane.axis),
        trust_{Trust(first), Trust(first)} {}

  bool present() const { return partner_ != Mirror<Int>::nobody; }
  const Vector& mean() const { return mean_; }
  int scale(std::size_t component) const { return trust_[component != axis_].scale(); }
  /// Of the sure coordinates.
  int sure() const { return trust_[1].scale(); }

  void forget() { partner_ = Mirror<Int>::nobody; }

  void predict(const Points<Int>& point, const Star& star, const Surroundings& at,
               const Vector& corrected, int across) {
    const Star::Parallelogram& gate = star.parallelogram[0];
    Row row;
    for (std::size_t i = 0; i < 3; ++i)
      row[i] = static_cast<Int>(
          space_->integer(i, at.frame.origin[i] + shifted(corrected[i], -at.frame.finer)));
    partner_ = mirror_.guess(gate.a, gate.b, row.data());
    if (!present()) return;
    mean_ = at.frame.place(image(partner_));
    mean_[axis_] += shifted(shift_, at.frame.finer - shift_bits);
    const Vector a = mismatch(point, gate.a, at, across), b = mismatch(point, gate.b, at, across);
    const Vector d = mean_ - corrected;
    trust_[0].predict(at.size(a[axis_]), at.size(b[axis_]), at.size(d[axis_]), across, at.edge);
    trust_[1].predict(at.size(beside(a)), at.size(beside(b)), at.size(beside(d)), across, at.edge);
  }

  void learn(const Surroundings& at, const Vector& place) {
    const Vector off = place - mean_;
    trust_[0].learn(at.size(off[axis_]));
    trust_[1].learn(at.size(beside(off)));
    const std::int64_t step = space_->scale(axis_) << shift_bits;
    shift_ += std::clamp(shifted(off[axis_], shift_bits - at.frame.finer), -step, step) >> 5;
  }

  void known(std::uint32_t v) { mirror_.known(v, partner_); }

 private:
  using Row = std::array<Int, 3>;
  static constexpr int shift_bits = 8;

  Vector image(std::uint32_t w) const {
    const Row row = {mirror_.image(w, 0), mirror_.image(w, 1), mirror_.image(w, 2)};
    return space_->point(row.data());
  }
  /// From a vertex to the image of its partner; as usual, if it has none.
  Vector mismatch(const Points<Int>& point, std::uint32_t v, const Surroundings& at,
                  int across) const {
    const std::int64_t usual = at.length(across);
    if (mirror_.partner(v) == Mirror<Int>::nobody) return {{usual, usual, usual}};
    const Row row = {mirror_.partner_image(v, 0), mirror_.partner_image(v, 1),
                     mirror_.partner_image(v, 2)};
    return at.frame.scaled(space_->point(row.data()) - point(v));
  }
  /// What of a vector is not along the mirrored axis.
  Vector beside(Vector d) const {
    d[axis_] = 0;
    return d;
  }

  Mirror<Int> mirror_;
  const Space* space_;
  std::span<const Axis> axes_;
  std::size_t axis_;
  std::uint32_t partner_ = Mirror<Int>::nobody;
  Vector mean_;
  std::array<Trust, 2> trust_;  ///< along the mirrored axis, along the others
  std::int64_t shift_ = 0;      ///< along it, on average; coordinates in units of 2^-shift_bits
};

/// The original of what is a copy.
template <class Int>
class CopyExpert {
 public:
  CopyExpert(const Originals& originals, const Space& space, std::span<const Axis> axes,
             const Int* rows, int first)
      : copies_(originals, rows, axes), space_(&space), trust_(first) {}

  bool present() const { return present_; }
  const Vector& mean() const { return mean_; }
  int scale() const { return trust_.scale(); }

  void forget() { present_ = false; }

  void predict(std::uint32_t v, const Star& star, const Surroundings& at, const Vector& corrected,
               int across) {
    const Star::Parallelogram& gate = star.parallelogram[0];
    std::array<Int, 3> row;
    present_ = copies_.guess(v, gate.a, gate.b, gate.c, row.data());
    if (!present_) return;
    mean_ = at.frame.place(space_->point(row.data()));
    // 16 a bit, and the sum of three coordinates.
    const int expected = static_cast<int>(copies_.expected()) * 16 - 256;
    trust_.predict(expected, space_->least_size(), at.size(mean_ - corrected), across, at.edge);
  }
  void learn(const Surroundings& at, const Vector& place) { trust_.learn(at.size(place - mean_)); }
  void known(std::uint32_t v) { copies_.known(v); }

 private:
  Copies<Int> copies_;
  const Space* space_;
  bool present_ = false;
  Vector mean_;
  Trust trust_;
};

}  // namespace clers::internal::mixed

#endif

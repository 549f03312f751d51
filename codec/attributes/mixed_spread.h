// How far experts that look at what is around a vertex will be off: along its normal and across,
// and along each axis; learned by regression on how far off they were nearby.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_SPREAD_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_SPREAD_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/attributes/mixed_covariance.h"
#include "codec/attributes/mixed_mixing.h"
#include "codec/attributes/mixed_past.h"
#include "codec/attributes/mixed_scales.h"
#include "codec/attributes/mixed_surroundings.h"
#include "codec/attributes/vector.h"

namespace clers::internal::mixed {

/// Scales are log2 in 1/256, of coordinates.
class Spread {
 public:
  /// Of the corrected mean along the normal and across.
  int along = 0, across = 0;
  /// Of the plain mean along each axis.
  std::array<int, 3> axis = {};
  /// Of the corrected mean, by component.
  Covariance covariance;

  /// By how much an expert's scales exceed those of the corrected mean.
  int bias(std::size_t expert) const { return bias_[expert] >> 8; }

  void predict(const Surroundings& at, const Recent& past, const Vector& corrected) {
    const PastSizes &a = *past.at_a, &b = *past.at_b, &c = *past.at_c;
    const bool several = at.count > 1;
    const Vector apart = several ? at.ends[1] - at.ends[0] : Vector{};
    const int base_along = (2 * past.along + a.along + b.along) / 4;
    const int base_across = (2 * past.across + a.across + b.across) / 4;
    const Surroundings::Sizes spread = at.sizes(apart);
    Features<16>& f = features_;
    f.set(0, 256);
    f.set(1, base_along - base_across);
    f.set(2, base_along - at.edge);
    f.set(3, at.edge / 4);
    f.set(4, a.along - base_along);
    f.set(5, b.along - base_along);
    f.set(6, c.along - base_along);
    f.set(7, at.count == 1 ? 256 : 0);
    f.set(8, a.across - base_across);
    f.set(9, b.across - base_across);
    f.set(10, c.across - base_across);
    f.set(11, at.count > 2 ? 256 : 0);
    f.set(12, several ? spread.along - base_along : 0);
    f.set(13, several ? spread.across - base_across : 0);
    f.set(14, at.has_lines ? at.reach - base_across : 0);
    f.set(15, at.size(corrected - at.mean_end) - base_across);
    along = base_along + along_.predict(f);
    across = base_across + across_.predict(f);
    covariance.set(at.normal, at.order, along, across);

    for (std::size_t i = 0; i < 3; ++i) {
      const int base = (2 * past.axis[i] + a.axis[i] + b.axis[i]) / 4;
      Features<8>& g = axis_features_[i];
      g.set(0, 256);
      g.set(1, across + covariance.whole[i] - base);
      g.set(2, base - at.edge);
      g.set(3, a.axis[i] - base);
      g.set(4, b.axis[i] - base);
      g.set(5, c.axis[i] - base);
      g.set(6, at.count == 1 ? 256 : 0);
      g.set(7, several ? at.size(apart[i]) - base : 0);
      axis[i] = base + axis_[i].predict(g);
    }
  }

  /// By how much each expert was off.
  void learn(const Surroundings& at, const Vector& place,
             const std::array<Vector, experts>& means) {
    const std::int64_t rate = rate_.next();
    const Surroundings::Sizes off = at.sizes(place - means[corrected_mean]);
    const std::int64_t inverse = features_.inverse_power();
    along_.learn(features_, inverse, rate, excess(off.along, along));
    across_.learn(features_, inverse, rate, excess(off.across, across));
    const Vector plain = place - means[plain_mean];
    for (std::size_t i = 0; i < 3; ++i)
      axis_[i].learn(axis_features_[i], axis_features_[i].inverse_power(), rate,
                     excess(at.size(plain[i]), axis[i]));
    for (const unsigned i : {plain_mean, line_mean, gate_end, shape_or_copy, ring_mean}) {
      const Surroundings::Sizes other = at.sizes(place - means[i]);
      const std::int64_t more =
          excess(other.along, along + bias(i)) + excess(other.across, across + bias(i));
      bias_[i] += static_cast<int>(rate * more >> 9);
    }
  }

 private:
  Features<16> features_;
  Features<8> axis_features_[3];
  Regression<16> along_, across_;
  Regression<8> axis_[3];
  std::array<int, experts> bias_ = {};  ///< in 1/65536 octaves
  Rate rate_;
};

}  // namespace clers::internal::mixed

#endif

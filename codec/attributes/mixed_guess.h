// An expert that knows where a vertex will be by other means than what is around it: how far off it
// is, learned from how far off it was.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_GUESS_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_GUESS_H

#include <algorithm>
#include <cstdint>

#include "codec/attributes/mixed_scales.h"

namespace clers::internal::mixed {

/// Sizes are log2 of lengths in coordinates, in 1/256.
class Guess {
 public:
  explicit Guess(int first) : usual_(first), last_(first) {}

  /// The scale expected now, given sizes that tell of it.
  int predict(int here, int there, int distance, int others, int edge) {
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
    return scale_;
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

}  // namespace clers::internal::mixed

#endif

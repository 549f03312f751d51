// What a model would take, without coding anything.
#ifndef CLERS_CODEC_ENTROPY_MEASURE_H
#define CLERS_CODEC_ENTROPY_MEASURE_H

#include <cstdint>

#include "codec/entropy/coder.h"

namespace clers::internal {

/// A coder that writes nothing and knows what it would take.
class Measure {
 public:
  static constexpr bool encodes = true;
  bool bit(BitModel& model, bool value) {
    decide(model.share(), value);
    model.update(value);
    return value;
  }
  bool decide(std::uint32_t share, bool value) {
    cost_ += rans::cost({0, static_cast<std::uint16_t>(value ? share : rans::scale - share)});
    return value;
  }
  std::uint32_t raw(unsigned n, std::uint32_t value) {
    cost_ += 256 * n;
    return value;
  }
  std::uint64_t cost() const { return cost_; }  ///< in 1/256 bits

 private:
  std::uint64_t cost_ = 0;
};

}  // namespace clers::internal

#endif

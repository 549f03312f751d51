// What the two directions of attribute coding share.
#ifndef CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_FORMAT_H
#define CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_FORMAT_H

#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/attributes/attribute.h"
#include "codec/attributes/prediction.h"
#include "codec/entropy/zstd_frame.h"

namespace clers::internal {

constexpr bool is_float(Scalar s) {
  return s == Scalar::float32 || s == Scalar::float64;
}

/// Calls f(U()) with the unsigned word of a scalar's size.
template <class F>
auto with_word(Scalar s, F f) {
  switch (size_of(s)) {
    case 1: return f(std::uint8_t());
    case 2: return f(std::uint16_t());
    case 4: return f(std::uint32_t());
    default: return f(std::uint64_t());
  }
}

/// Calls visit(value, guess) for every value in the order in which differences are stored. A value
/// that is its own guess has none.
template <class Visit>
void for_each_value(Predictor predictor, std::size_t count, std::span<const std::uint32_t> corners,
                    Visit visit) {
  if (predictor == Predictor::parallelogram)
    return for_each_vertex(corners, static_cast<std::uint32_t>(count), visit);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t v = static_cast<std::uint32_t>(i);
    const std::uint32_t g = predictor == Predictor::none || i == 0 ? v : v - 1;
    visit(v, Guess{g, g, g});
  }
}

}  // namespace clers::internal

#endif

// Weights -> bytes.
#include <cmath>
#include <vector>

#include "codec/attributes/weights.h"
#include "codec/attributes/weights_model.h"
#include "codec/base/portable.h"
#include "codec/numbers/ranks.h"

namespace clers::internal {

template <class Int>
bool look_like_weights(std::span<const Int> rows, const Numbers& numbers) {
  const DoublePrecision doubles;
  const NumberLines lines = number_lines(numbers);
  const std::size_t width = lines.size(), values = rows.size() / width;
  std::size_t whole = 0;
  for (std::size_t v = 0; v < values; ++v) {
    double sum = 0;
    for (std::size_t c = 0; c < width; ++c)
      sum += lines[c]->value(static_cast<std::uint64_t>(rows[v * width + c]));
    whole += std::fabs(sum - 1) < 1. / 64;
  }
  return 2 * whole >= values && values > 0;
}

template <class Int>
Bytes encode_weights(std::span<const Int> rows, const Numbers& numbers, const ValueSurface& along) {
  const DoublePrecision doubles;
  Bytes bytes;
  if (rows.empty()) return bytes;
  std::vector<Int> ranks(rows.begin(), rows.end());
  integers_to_ranks(Lattice<Int>{ranks, numbers.axes});
  const std::size_t values = rows.size() / numbers.axes.size();
  LaneEncoder coder;
  WeightsModel<Int, LaneEncoder> model(coder, numbers, along.joints, ranks);
  for_each_with_nearby(along, values, values, [&](std::uint32_t v, const Nearby& nearby) {
    return model.code(v, nearby);
  });
  coder.finish(bytes);
  return bytes;
}

template bool look_like_weights(std::span<const std::int32_t>, const Numbers&);
template bool look_like_weights(std::span<const std::int64_t>, const Numbers&);
template Bytes encode_weights(std::span<const std::int32_t>, const Numbers&, const ValueSurface&);
template Bytes encode_weights(std::span<const std::int64_t>, const Numbers&, const ValueSurface&);

}  // namespace clers::internal

// Bytes -> weights.
#include <algorithm>

#include "codec/attributes/weights.h"
#include "codec/attributes/weights_model.h"
#include "codec/base/portable.h"

namespace clers::internal {

bool may_be_weights(const Numbers& numbers) {
  const std::size_t n = numbers.axes.size();
  return numbers.octahedral_bits() == 0 && n >= 2 && n <= 16 &&
         (is_float(numbers.scalar) || clers::size_of(numbers.scalar) <= 2);
}

bool fit_as_joints(const Attribute& joints, std::size_t values, std::size_t components) {
  return (joints.scalar == Scalar::uint8 || joints.scalar == Scalar::uint16) &&
         joints.components == components && joints.value_count() == values;
}

template <class Int>
Expected<Done> decode_weights(std::span<const std::byte> bytes, std::uint64_t at,
                              const Numbers& numbers, const ValueSurface& along,
                              std::span<Int> rows) {
  const DoublePrecision doubles;
  const auto invalid = [&](const char* what) {
    return fail(ErrorCode::invalid, Place::byte, at, what);
  };
  if (!may_be_weights(numbers)) return invalid("weights of another kind");
  const std::size_t values = rows.size() / numbers.axes.size();
  if (along.joints != nullptr && !fit_as_joints(*along.joints, values, numbers.axes.size()))
    return invalid("weights of joints that they do not fit");
  if (values == 0) return bytes.empty() ? Expected<Done>(Done{}) : invalid("bytes of no weights");
  ByteReader in(bytes, at);
  LaneDecoder coder(in);
  if (!in.ok()) return Failure{in.error()};
  WeightsModel<Int, LaneDecoder> model(coder, numbers, along.joints, rows);
  const bool ok = for_each_with_nearby(
      along, values, values,
      [&](std::uint32_t v, const Nearby& nearby) { return model.code(v, nearby); });
  if (!ok) return invalid("a weight beyond the greatest");
  if (!coder.finished()) return invalid("weights do not end where their bytes end");
  for (std::size_t c = 0; c < numbers.axes.size(); ++c) {
    const auto& palette = numbers.axes[c].palette;
    for (std::size_t i = c; !palette.empty() && i < rows.size(); i += numbers.axes.size())
      rows[i] = static_cast<Int>(palette[static_cast<std::size_t>(rows[i])]);
  }
  return Done{};
}

std::uint64_t weights_memory(std::uint64_t values, std::uint64_t components,
                             std::uint64_t vertices) {
  return WeightsModel<std::int64_t, LaneDecoder>::memory(values, components) +
         known_values_memory(values, vertices);
}

template Expected<Done> decode_weights(std::span<const std::byte>, std::uint64_t, const Numbers&,
                                       const ValueSurface&, std::span<std::int32_t>);
template Expected<Done> decode_weights(std::span<const std::byte>, std::uint64_t, const Numbers&,
                                       const ValueSurface&, std::span<std::int64_t>);

}  // namespace clers::internal

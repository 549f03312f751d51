// Bytes -> joints.
#include <algorithm>
#include <string>

#include "codec/attributes/joints.h"
#include "codec/attributes/joints_model.h"
#include "codec/entropy/stream.h"

namespace clers::internal {

bool may_be_joints(std::span<const Axis> axes) {
  return axes.size() >= 2 && axes.size() <= 16 &&
         std::all_of(axes.begin(), axes.end(), [](const Axis& a) { return a.top <= 0xffff; });
}

Expected<Done> decode_joints(std::span<const std::byte> bytes, std::uint64_t at,
                             std::span<const Axis> axes, const ValueSurface& along,
                             std::span<std::int32_t> rows) {
  const auto invalid = [&](const char* what) {
    return fail(ErrorCode::invalid, Place::byte, at, what);
  };
  if (!may_be_joints(axes)) return invalid("joints of another kind");
  const std::size_t values = rows.size() / axes.size();
  if (values == 0) return bytes.empty() ? Expected<Done>(Done{}) : invalid("bytes of no joints");
  const Stream stream{bytes, at};
  if (values > stream.max_decisions()) return invalid("more joints than their bytes can say");
  return decode_stream(stream, "the joints", [&](DecodeFrom& coder) {
    JointsModel<DecodeFrom> model(coder, axes, rows);
    const bool ok = for_each_with_nearby(
        along, values, values,
        [&](std::uint32_t v, const Nearby& nearby) { return model.code(v, nearby); });
    return std::string(ok ? "" : "a joint beyond the greatest");
  });
}

std::uint64_t joints_memory(std::uint64_t values, std::uint64_t components,
                            std::uint64_t vertices) {
  return JointsModel<DecodeFrom>::memory(components) + known_values_memory(values, vertices);
}

}  // namespace clers::internal

// Joints -> bytes.
#include <vector>

#include "codec/attributes/joints.h"
#include "codec/attributes/joints_model.h"
#include "codec/entropy/stream.h"

namespace clers::internal {
namespace {

// Values that are looked at.
constexpr std::size_t sample = 8192;

}  // namespace

bool look_like_joints(std::span<const std::int32_t> rows, std::span<const Axis> axes,
                      const ValueSurface& along) {
  const std::size_t width = axes.size(), values = rows.size() / width;
  std::size_t looked_at = 0, alike = 0;
  for_each_with_nearby(along, values, sample, [&](std::uint32_t v, const Nearby& nearby) {
    const auto row = rows.subspan(v * width, width);
    bool is = false;
    for (std::size_t i = 0; i < nearby.count; ++i) {
      const auto other = rows.subspan(nearby.around[i] * width, width);
      is |= std::equal(row.begin(), row.end(), other.begin());
    }
    alike += is;
    ++looked_at;
    return true;
  });
  return 2 * alike >= looked_at;
}

Bytes encode_joints(std::span<const std::int32_t> rows, std::span<const Axis> axes,
                    const ValueSurface& along) {
  if (rows.empty()) return {};
  std::vector<std::int32_t> coded(rows.begin(), rows.end());
  const std::size_t values = rows.size() / axes.size();
  return encode_stream([&](EncodeTo& coder) {
    JointsModel<EncodeTo> model(coder, axes, coded);
    for_each_with_nearby(along, values, values, [&](std::uint32_t v, const Nearby& nearby) {
      return model.code(v, nearby);
    });
  });
}

}  // namespace clers::internal

// Indices of any type of integers.
#include "codec/gltf/values.h"

namespace clers::gltf {

std::vector<std::uint32_t> gather_indices(const Run& run, const Buffers& buffers) {
  std::vector<std::uint32_t> indices(static_cast<std::size_t>(run.count));
  const std::byte* from = buffers[run.buffer].data() + run.start;
  with_type(run.scalar, [&](auto type) {
    using T = decltype(type);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      T value;
      std::memcpy(&value, from + i * run.stride, sizeof value);
      indices[i] = value < T{} ? 0xffffffffu : static_cast<std::uint32_t>(value);
    }
  });
  return indices;
}

void scatter_indices(const Run& run, std::span<const std::uint32_t> indices, Buffers& buffers) {
  std::byte* to = buffers[run.buffer].data() + run.start;
  with_type(run.scalar, [&](auto type) {
    using T = decltype(type);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const T value = static_cast<T>(indices[i]);
      std::memcpy(to + i * run.stride, &value, sizeof value);
    }
  });
}

}  // namespace clers::gltf

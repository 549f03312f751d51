// Do so many bytes hold the values that they should? A header alone, since bindings use it too.
#ifndef CLERS_CODEC_BASE_HOLDS_VALUES_H
#define CLERS_CODEC_BASE_HOLDS_VALUES_H

#include <cstdint>

namespace clers::internal {

/// Whether so many bytes are those of `count` values of `size` bytes, `stride` apart: the last may
/// be followed by the rest of its stride, or not. Precondition: 0 < size <= stride.
inline bool holds_values(std::uint64_t bytes, std::uint64_t count, std::uint64_t size,
                         std::uint64_t stride) {
  if (count == 0) return bytes == 0;
  return bytes >= size && (bytes - size) / stride == count - 1 &&
         (bytes - size) % stride <= stride - size;
}

}  // namespace clers::internal

#endif

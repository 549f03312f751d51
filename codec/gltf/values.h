// Values of a run <-> packed ones.
#ifndef CLERS_CODEC_GLTF_VALUES_H
#define CLERS_CODEC_GLTF_VALUES_H

#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "codec/gltf/layout.h"

namespace clers::gltf {

using Buffers = std::vector<std::vector<std::byte>>;

/// Calls use(place of a column in its buffer, bytes of it) for all columns of a run in order.
template <class Use>
void for_each_column(const Run& run, Use use) {
  const std::size_t bytes = run.rows * size_of(run.scalar);
  for (std::uint64_t i = 0; i < run.count; ++i)
    for (unsigned c = 0; c < run.columns; ++c)
      use(static_cast<std::size_t>(run.start + i * run.stride + c * run.column), bytes);
}

/// Bytes of all values, packed.
inline std::size_t packed_size(const Run& run) {
  return static_cast<std::size_t>(run.count) * run.components() * size_of(run.scalar);
}

/// Appends the values. Precondition: run.has_bytes(), and the buffer has them.
inline void gather(const Run& run, const Buffers& buffers, std::vector<std::byte>& out) {
  const std::vector<std::byte>& from = buffers[run.buffer];
  std::size_t at = out.size();
  out.resize(at + packed_size(run));
  for_each_column(run, [&](std::size_t place, std::size_t bytes) {
    std::memcpy(out.data() + at, from.data() + place, bytes);
    at += bytes;
  });
}

/// Puts packed values where they belong. The same precondition.
inline void scatter(const Run& run, std::span<const std::byte> values, Buffers& buffers) {
  std::vector<std::byte>& to = buffers[run.buffer];
  std::size_t at = 0;
  for_each_column(run, [&](std::size_t place, std::size_t bytes) {
    std::memcpy(to.data() + place, values.data() + at, bytes);
    at += bytes;
  });
}

/// Single integers of a run; those below 0 become none that an index can be.
std::vector<std::uint32_t> gather_indices(const Run& run, const Buffers& buffers);
/// The inverse. Precondition: they fit the run's type.
void scatter_indices(const Run& run, std::span<const std::uint32_t> indices, Buffers& buffers);

}  // namespace clers::gltf

#endif

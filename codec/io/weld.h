// Equal values -> one number.
#ifndef CLERS_CODEC_IO_WELD_H
#define CLERS_CODEC_IO_WELD_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace clers::io {

struct Welded {
  std::vector<std::uint32_t> number;  ///< of each value; numbers follow first appearances
  std::vector<std::uint32_t> first;   ///< of each number, the first value that has it
};

/// Numbers values of `stride` bytes so that those with equal bytes share a number.
/// Precondition: fewer than 2^32 values. Cost: sorts them.
Welded weld(std::span<const std::byte> values, std::size_t stride);

}  // namespace clers::io

#endif

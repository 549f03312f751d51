// The number of no vertex, no face, no half-edge, and whatever else is numbered.
#ifndef CLERS_CODEC_BASE_NO_INDEX_H
#define CLERS_CODEC_BASE_NO_INDEX_H

#include <cstdint>

namespace clers::internal {

inline constexpr std::uint32_t no_index = 0xffffffffu;

}  // namespace clers::internal

#endif

// What measuring a mesh (codec/inspect.h) takes.
#ifndef CLERS_CODEC_MEASURE_H
#define CLERS_CODEC_MEASURE_H

#include <cstdint>

namespace clers {

/// Bytes at most; `sizes`: does the mesh have face sizes?
std::uint64_t measuring_memory(std::uint64_t corners, std::uint64_t faces, std::uint64_t vertices,
                               bool sizes);

}  // namespace clers

#endif

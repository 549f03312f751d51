// The order of vertices and faces.
#ifndef CLERS_CODEC_ORDER_H
#define CLERS_CODEC_ORDER_H

#include <cstdint>
#include <vector>

#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// The order in which vertices and faces come back, and the corner that each face begins with.
enum class Order : std::uint8_t {
  free,  ///< the codec's, which costs nothing: Encoded::permutations says what became of them
  keep,  ///< that of the input, which is stored: index buffers come back identical
};

/// Where the elements of a decoded mesh were in the input. With Order::keep: 0, 1, 2 .., and first
/// corners 0.
struct Permutation {
  std::vector<std::uint32_t> vertices;       ///< vertices[new] = old, one for each vertex
  std::vector<std::uint32_t> faces;          ///< faces[new] = old, one for each face
  std::vector<std::uint32_t> first_corners;  ///< first_corners[new] = the corner, 0, 1 .., of the
                                             ///< old face that comes first now
};

}  // namespace clers

#endif

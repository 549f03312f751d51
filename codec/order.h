// What becomes of the order of vertices and faces.
#ifndef CLERS_CODEC_ORDER_H
#define CLERS_CODEC_ORDER_H

#include <cstdint>
#include <vector>

namespace clers {

/// What becomes of the order of vertices and faces, and of the corner that a face begins with.
enum class Order : std::uint8_t {
  free,  ///< the codec's: Encoded::permutations
  keep,  ///< stored: index buffers come back identical
};

/// What the codec renumbered. Decoding gives the mesh in the new order. With Order::keep all
/// are 0, 1, 2 .. and first corners 0.
struct Permutation {
  std::vector<std::uint32_t> vertices;       ///< vertices[new] = old, one for each vertex
  std::vector<std::uint32_t> faces;          ///< faces[new] = old, one for each face
  std::vector<std::uint32_t> first_corners;  ///< first_corners[new] = the corner of the old face
                                             ///< (0, 1, ..) that comes first now
};

}  // namespace clers

#endif

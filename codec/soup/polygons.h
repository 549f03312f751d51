// What makes polygons of coded triangles again: how many corners each has.
//
// Edgebreaker (connectivity/edgebreaker.h) enters a polygon through the edge a -> b and makes of it
// a fan of triangles around b, from a on, which follow each other.
//
//              v1_______v2
//              /\ .      \              faces of the surface: (a, b, v1), (v1, b, v2), (v2, b, v3)
//             /   . .     \             the polygon:          a, b, v3, v2, v1
//            a       .  .  v3
//             \         . ./
//              `---------b
#ifndef CLERS_CODEC_SOUP_POLYGONS_H
#define CLERS_CODEC_SOUP_POLYGONS_H

#include <algorithm>
#include <cstdint>

#include "codec/entropy/coder.h"

namespace clers::internal {

/// The sizes of polygons, each in the context of the two before.
class SizeModel {
 public:
  template <class Coder>
  std::uint32_t code(Coder& coder, std::uint32_t size) {
    size = 3 + sizes_[before_].code(coder, size - 3);
    before_ = (before_ * 3 + std::min(size - 3, 2u)) % 9;
    return size;
  }

 private:
  NumberModel sizes_[9];
  unsigned before_ = 0;  ///< sizes 3, 4, more of the last two
};

}  // namespace clers::internal

#endif

// Which triangles of a surface make a polygon. The triangles of one follow each other, so its size
// says it. Decoding checks that they do, and makes polygons of them. codec/format.md, Polygons.
//
// A polygon entered through the edge a -> b is a fan of triangles around b, from a on; the side
// b -> v of each but the last is the diagonal through which the next one is entered:
//
//              v1_______v2
//              /\ .      \              triangles:   (a, b, v1), (v1, b, v2), (v2, b, v3)
//             /   . .     \             the polygon:  a, b, v3, v2, v1
//            a       .  .  v3
//             \         . ./
//              `---------b
#ifndef CLERS_CODEC_SOUP_POLYGON_SIZES_H
#define CLERS_CODEC_SOUP_POLYGON_SIZES_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "codec/entropy/stream.h"

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

/// Sizes in the order of the coded faces; empty where all are triangles.
inline EncodedStream encode_sizes(std::span<const std::uint32_t> sizes) {
  if (std::all_of(sizes.begin(), sizes.end(), [](std::uint32_t size) { return size == 3; }))
    return {};
  return {{sizes.size()}, encode_stream([&](EncodeTo& coder) {
            SizeModel model;
            for (const std::uint32_t size : sizes) model.code(coder, size);
          })};
}

/// What a mesh says of its polygons before it is decoded.
struct PolygonHeader {
  std::uint64_t faces = 0;  ///< triangles among them
  Stream stream;

  void read(ByteReader& in) { stream = read_stream(in, {&faces}); }
  /// Why so many triangles cannot make them; empty: they can.
  std::string fault(std::uint64_t triangles) const {
    if (faces > 0 && faces < triangles) return {};
    return std::to_string(faces) + " polygons cannot be made of " + std::to_string(triangles) +
           " triangles";
  }
};

/// The sizes of polygons that consecutive triangles make. Precondition: no fault. Error: invalid.
inline Expected<std::vector<std::uint32_t>> decode_sizes(const PolygonHeader& header,
                                                         std::span<const std::uint32_t> triangles) {
  std::vector<std::uint32_t> sizes;
  sizes.reserve(static_cast<std::size_t>(header.faces));
  auto ok = decode_stream(header.stream, "the polygons", [&](DecodeFrom& coder) -> std::string {
    SizeModel model;
    std::size_t left = triangles.size() / 3;
    for (std::uint64_t i = 0; i < header.faces; ++i) {
      const std::uint32_t size = model.code(coder, 3);
      if (size < 3 || size - 2 > left)
        return "polygon " + std::to_string(i) + " has " + std::to_string(size) + " corners where " +
               std::to_string(left) + " triangles are left";
      const std::uint32_t* t = triangles.data() + triangles.size() - 3 * left;
      for (std::uint32_t k = 3; k < size; ++k, t += 3)
        if (t[3] != t[2] || t[4] != t[1])
          return "the triangles of polygon " + std::to_string(i) + " do not follow each other";
      left -= size - 2;
      sizes.push_back(size);
    }
    return left == 0 ? std::string() : std::to_string(left) + " triangles belong to no polygon";
  });
  if (!ok) return Failure{ok.error()};
  return sizes;
}

/// Appends the corners of the polygons that triangles make.
inline void append_polygons(std::span<const std::uint32_t> triangles,
                            std::span<const std::uint32_t> sizes,
                            std::vector<std::uint32_t>& corners) {
  const std::uint32_t* t = triangles.data();
  for (const std::uint32_t size : sizes) {
    corners.insert(corners.end(), {t[0], t[1]});
    for (std::uint32_t k = size - 2; k-- > 0;) corners.push_back(t[3 * std::size_t(k) + 2]);
    t += 3 * std::size_t(size - 2);
  }
}

}  // namespace clers::internal

#endif

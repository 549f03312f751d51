// Which corner of a face each corner of the triangles is that the face was cut into. Knows sizes of
// faces, and no vertices.
#ifndef CLERS_CODEC_SOUP_CORNER_MAP_H
#define CLERS_CODEC_SOUP_CORNER_MAP_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace clers::internal {

/// Of triangles as polygons are coded (polygon_sizes.h): so many corners of them, and the sizes of
/// the polygons, which other faces may follow. Precondition: they are those of the triangles.
inline std::vector<std::uint32_t> corners_of_polygons(std::span<const std::uint32_t> sizes,
                                                      std::size_t corners) {
  std::vector<std::uint32_t> result;
  result.reserve(corners);
  std::uint32_t begin = 0;
  for (std::size_t f = 0; result.size() < corners; begin += sizes[f++]) {
    // The fan around the second corner goes backwards through the others.
    const std::uint32_t size = sizes[f];
    for (std::uint32_t k = 0; k + 2 < size; ++k)
      result.insert(result.end(),
                    {k == 0 ? begin : begin + size - k, begin + 1, begin + size - 1 - k});
  }
  return result;
}

/// Of the fans that fan_triangles (raw_faces.h) makes of faces.
inline std::vector<std::uint32_t> corners_of_fans(std::span<const std::uint32_t> sizes,
                                                  std::size_t corners) {
  std::vector<std::uint32_t> result;
  result.reserve(corners);
  std::uint32_t begin = 0;
  for (const std::uint32_t size : sizes) {
    for (std::uint32_t k = 2; k < size; ++k)
      result.insert(result.end(), {begin, begin + k - 1, begin + k});
    begin += size;
  }
  return result;
}

}  // namespace clers::internal

#endif

// Google's decoder, run on bytes that nobody vouches for.
#ifndef CLERS_CODEC_DRACO_DECODED_H
#define CLERS_CODEC_DRACO_DECODED_H

#include <draco/mesh/mesh.h>
#include <draco/point_cloud/point_cloud.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <clers/error.h>
#include <clers/limits.h>

namespace clers::draco {

struct Decoded {
  std::unique_ptr<::draco::PointCloud> points;
  const ::draco::Mesh* mesh = nullptr;  ///< the same, if there are triangles
  bool edgebreaker = false;             ///< triangles are in an order of Draco's
  bool tree = false;                    ///< points are, and all values were made integers
  std::vector<unsigned> bits;           ///< to how many each attribute is quantised; 0: not known
  std::size_t left = 0;                 ///< bytes behind it
};

/// What there is has the sizes that it says: faces are of points, and points of values. Errors as
/// of read().
Expected<Decoded> decode_checked(std::span<const std::byte> bytes, const Limits& limits);

}  // namespace clers::draco

#endif

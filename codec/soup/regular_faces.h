// The faces of a mesh that a surface can have, apart from the degenerate ones: those of fewer than
// three corners, or with a vertex twice. Knows faces only as cycles.
#ifndef CLERS_CODEC_SOUP_REGULAR_FACES_H
#define CLERS_CODEC_SOUP_REGULAR_FACES_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/base/faces.h"

namespace clers::internal {

class RegularFaces {
 public:
  /// `sizes` are those of `all`; the spans must outlive this. Vertices are below vertex_count.
  /// Cost: linear; a copy of the faces if any is degenerate.
  RegularFaces(const Cycles& all, std::span<const std::uint32_t> sizes, std::uint32_t vertex_count);
  RegularFaces(const RegularFaces&) = delete;

  std::span<const std::uint32_t> corners() const { return corners_; }
  std::span<const std::uint32_t> sizes() const { return sizes_; }  ///< none: triangles
  /// The number that a face has among all.
  std::uint32_t in_all(std::uint32_t f) const { return kept_.empty() ? f : kept_[f]; }
  const std::vector<std::uint32_t>& degenerate() const { return degenerate_; }  ///< ascending

 private:
  std::span<const std::uint32_t> corners_, sizes_;
  std::vector<std::uint32_t> degenerate_, kept_;  ///< faces of all; nothing kept: all are
  std::vector<std::uint32_t> kept_corners_, kept_sizes_;
};

}  // namespace clers::internal

#endif

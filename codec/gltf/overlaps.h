// Runs that share bytes.
#ifndef CLERS_CODEC_GLTF_OVERLAPS_H
#define CLERS_CODEC_GLTF_OVERLAPS_H

#include <vector>

#include "codec/gltf/layout.h"

namespace clers::gltf {

struct Overlaps {
  std::vector<std::size_t> first;  ///< for each run, the first that is the same
  /// For each run, whether it may have bytes in common with one that is not the same, or has an
  /// element twice: then its bytes stay as they are.
  std::vector<bool> fixed;
};

/// Runs that are interleaved have none in common:
///
///     xyz nnn uv xyz nnn uv          one stride, and parts of it that are apart
///
/// Cost: n log n in the runs.
Overlaps find_overlaps(const Layout& layout);

}  // namespace clers::gltf

#endif

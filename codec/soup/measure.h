// Counts what a mesh is, as the surface that is left when it is cut where it is none (CAGD 2010,
// §2.2). An independent witness: knows neither how the codec cuts nor how it pairs half-edges.
#ifndef CLERS_CODEC_SOUP_MEASURE_H
#define CLERS_CODEC_SOUP_MEASURE_H

#include <cstdint>

#include "codec/error.h"
#include "codec/info.h"
#include "codec/mesh_view.h"

namespace clers::internal {

/// The shape of any mesh. Errors: inconsistent_mesh, too_large. Throws std::bad_alloc and
/// std::length_error.
Expected<MeshShape> shape_of(const MeshView& mesh);

/// Bytes that shape_of takes at most; `sizes`: does the mesh have face sizes?
std::uint64_t measuring_memory(std::uint64_t corners, std::uint64_t faces, std::uint64_t vertices,
                               bool sizes);

}  // namespace clers::internal

#endif

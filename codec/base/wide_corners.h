// A view of any mesh as one with 32-bit corners, which is what the codec works on.
#ifndef CLERS_CODEC_BASE_WIDE_CORNERS_H
#define CLERS_CODEC_BASE_WIDE_CORNERS_H

#include <cstdint>
#include <vector>

#include "codec/error.h"
#include "codec/mesh_view.h"

namespace clers::internal {

/// The mesh, its corners copied to `memory` if they have 16 bits. Error: inconsistent_mesh, if
/// there are corners of either kind. Throws std::bad_alloc.
inline Expected<MeshView> with_wide_corners(MeshView mesh, std::vector<std::uint32_t>& memory) {
  if (mesh.corners_16.empty()) return mesh;
  if (!mesh.corners.empty())
    return fail(ErrorCode::inconsistent_mesh,
                "corners of 16 and of 32 bits, expected one of the two");
  memory.assign(mesh.corners_16.begin(), mesh.corners_16.end());
  mesh.corners = memory;
  mesh.corners_16 = {};
  return mesh;
}

}  // namespace clers::internal

#endif

// What a mesh is and what a file holds, without decoding more than is needed.
#ifndef CLERS_CODEC_INSPECT_H
#define CLERS_CODEC_INSPECT_H

#include <cstddef>
#include <span>

#include "codec/error.h"
#include "codec/info.h"
#include "codec/limits.h"
#include "codec/mesh.h"

namespace clers {

/// Describes a .clers file. Checks it as decode does, and decodes the connectivity to count.
/// Errors: those of decode.
Expected<FileInfo> inspect(std::span<const std::byte> bytes, const Limits& limits = {});

/// Measures any mesh, polygons and non-manifold ones included. Errors: inconsistent_mesh,
/// too_large, out_of_memory.
Expected<MeshShape> measure(const Mesh& mesh);

}  // namespace clers

#endif

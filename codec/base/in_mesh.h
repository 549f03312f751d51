// In which mesh of several an error is. Knows no mesh.
#ifndef CLERS_CODEC_BASE_IN_MESH_H
#define CLERS_CODEC_BASE_IN_MESH_H

#include <cstddef>
#include <string>
#include <utility>

#include "codec/error.h"

namespace clers::internal {

/// The error, with the number of its mesh if there are several.
inline Failure<Error> in_mesh(Error error, std::size_t mesh, std::size_t meshes) {
  if (meshes > 1) error.what += " (mesh " + std::to_string(mesh) + ")";
  return {std::move(error)};
}

}  // namespace clers::internal

#endif

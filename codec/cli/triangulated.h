// Polygons cut into triangles, with all their values.
#ifndef CLERS_CODEC_CLI_TRIANGULATED_H
#define CLERS_CODEC_CLI_TRIANGULATED_H

#include <vector>

#include "codec/cli/vec3.h"
#include "codec/mesh.h"

namespace clers::cli {

/// The mesh in triangles: quadrilaterals are cut along the shorter diagonal, larger polygons from
/// their first corner. A triangle has the values of its polygon and of the corners that it has of
/// it. Faces of fewer than three corners become none.
/// Precondition: `at` is by vertex. Throws std::bad_alloc.
Mesh triangulated(const Mesh& mesh, const std::vector<Vec3>& at);

}  // namespace clers::cli

#endif

// The places of a mesh's vertices as numbers.
#ifndef CLERS_CODEC_CLI_PLACES_H
#define CLERS_CODEC_CLI_PLACES_H

#include <vector>

#include "codec/cli/vec3.h"
#include "codec/error.h"
#include "codec/mesh.h"
#include "topology/surface.h"

namespace clers::cli {

/// By vertex. Errors: unsupported, which says that there is nothing to do something `by`;
/// not_on_grid (a vertex that a face uses is at no number below 1e100).
Expected<std::vector<Vec3>> places_of(const Mesh& mesh, const char* by);

/// Of the box around the vertices of the surface.
double diagonal_of(const Surface& surface, const std::vector<Vec3>& at);

}  // namespace clers::cli

#endif

// What keeps the faces of a mesh from being those of an oriented manifold, where a caller does not
// want that. Knows what the options say of it.
#ifndef CLERS_CODEC_SOUP_DEFECTS_H
#define CLERS_CODEC_SOUP_DEFECTS_H

#include "codec/error.h"
#include "codec/mesh.h"
#include "codec/options.h"

namespace clers::internal {

/// Names the first face or vertex that the options do not allow. Precondition: the mesh's arrays
/// agree. Errors: degenerate_face, duplicate_face, nonmanifold_edge, nonorientable,
/// nonmanifold_vertex. Cost: none where all is allowed; else linear, and a sort of the faces for
/// duplicates. Throws std::bad_alloc only.
Expected<Done> refuse_defects(const Mesh& mesh, const EncodeOptions& options);

}  // namespace clers::internal

#endif

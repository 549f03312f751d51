// Faces on the same vertices, in whatever cycle. Serves those who refuse or count them; what is
// coded as a repeat is another question (distinct_faces.h).
#ifndef CLERS_CODEC_SOUP_DUPLICATES_H
#define CLERS_CODEC_SOUP_DUPLICATES_H

#include <cstdint>
#include <utility>
#include <vector>

#include "codec/mesh_view.h"

namespace clers::internal {

/// Every face that has the same vertices as an earlier one, in whatever order, after the first such
/// earlier face: pairs (earlier, later), by rising later face. Cost: a sort of the corners of each
/// face and one of the faces; linear memory. Precondition: the mesh's arrays agree.
std::vector<std::pair<std::uint32_t, std::uint32_t>> duplicate_faces(const MeshView& mesh);

}  // namespace clers::internal

#endif

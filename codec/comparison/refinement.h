// Colour refinement (Weisfeiler and Leman 1968): elements learn what is around them.
// Knows hashes alone.
#ifndef CLERS_CODEC_COMPARISON_REFINEMENT_H
#define CLERS_CODEC_COMPARISON_REFINEMENT_H

#include <vector>

#include "codec/comparison/compared_mesh.h"

namespace clers::internal {

/// One round: a vertex's new colour is its old one and the multiset of the faces around it, each
/// read as a cycle of colours and values from that vertex on. Cost: linear.
void refine(ComparedMesh& mesh);

/// Colours of faces: their cycles of vertices and all values. Cost: linear.
std::vector<Colour> face_colours(const ComparedMesh& mesh);

}  // namespace clers::internal

#endif

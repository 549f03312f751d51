// The proof of a comparison: does this renumbering carry one mesh onto the other? Knows bits, and
// trusts no colour.
#ifndef CLERS_CODEC_COMPARISON_RENUMBERING_H
#define CLERS_CODEC_COMPARISON_RENUMBERING_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "codec/comparison/compared_mesh.h"

namespace clers::internal {

/// What fails when vertex v of one mesh is vertex image[v] of the other, faces and values compared
/// bit by bit; nothing: they are the same. Cost: that of sorting the faces.
/// Precondition: the same counts and attributes.
std::optional<std::string> renumbering_fails(const ComparedMesh& a, const ComparedMesh& b,
                                             const std::vector<std::uint32_t>& image);

}  // namespace clers::internal

#endif

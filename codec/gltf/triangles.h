// Triangles of a mesh by the lists that they are from, and vertices as a glTF numbers them.
#ifndef CLERS_CODEC_GLTF_TRIANGLES_H
#define CLERS_CODEC_GLTF_TRIANGLES_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/gltf/layout.h"
#include <clers/error.h>
#include <clers/mesh.h>

namespace clers::gltf {

using Corners = std::vector<std::uint32_t>;

/// The face attribute of lists (list_name); nullptr if there is none.
const Attribute* lists_of(const Mesh& mesh);

/// Corners of the triangles of each list, in their order; one list without such an attribute, none
/// without faces. Errors: inconsistent_mesh, of any mesh.
Expected<std::vector<Corners>> part_triangles(const Mesh& mesh);

/// What each vertex is numbered: as it is, or, where the last list is to be the vertices in turn,
/// by its place there. Errors: inconsistent_mesh, where a vertex is there twice or not at all.
Expected<std::vector<std::uint32_t>> vertex_numbers(std::uint32_t vertices,
                                                    const std::vector<Corners>& lists,
                                                    bool in_turn);

/// Whether an attribute has just the values of a run.
bool is_values_of(const Attribute& a, const Run& run);

/// Values in the order of such numbers. Precondition: there is one for each vertex.
std::vector<std::byte> renumbered(const Attribute& a, const std::vector<std::uint32_t>& numbers);

}  // namespace clers::gltf

#endif

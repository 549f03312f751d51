// Meshes by their recipe: the calls of generate.h as text, for manifests and command lines.
#ifndef CLERS_CORPUS_RECIPE_H
#define CLERS_CORPUS_RECIPE_H

#include <optional>
#include <string_view>

#include "codec/mesh.h"

namespace clers::corpus {

/// Makes the mesh that a call describes, such as "shuffle(flip_edges(torus(30, 20), 5000, 1), 2)"
/// or "gyroid(2, 2, 2, 16, open)". All functions of generate.h are known; "disjoint_union" takes
/// two meshes. The mesh's name is the recipe. Nothing if the recipe is not understood; the
/// functions' preconditions are not checked.
std::optional<Mesh> cook(std::string_view recipe);

}  // namespace clers::corpus

#endif

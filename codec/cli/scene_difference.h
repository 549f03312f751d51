// Do two scenes agree in what is not in their meshes?
#ifndef CLERS_CODEC_CLI_SCENE_DIFFERENCE_H
#define CLERS_CODEC_CLI_SCENE_DIFFERENCE_H

#include <span>
#include <string>
#include <vector>

#include "codec/info.h"
#include "codec/scene.h"

namespace clers::cli {

/// The first difference of their documents, arrays and blobs, for people; "" if there is none.
/// Values may be off by what is stated of their array.
/// Arrays of vertices are looked at only as far as numbers of vertices do not matter: see
/// with_uses.
std::string scene_difference(const Scene& expected, const Scene& found,
                             std::span<const ArrayInfo> stated);

/// The meshes. Each has for each array of its vertices one attribute more, of 128 bits, that says
/// where in the array each vertex is: so where meshes are the same, arrays name the same vertices.
std::vector<Mesh> with_uses(const Scene& scene);

}  // namespace clers::cli

#endif

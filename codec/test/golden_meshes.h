// The meshes of golden_cases.cc: those of corpus/, and polygons and defects that it does not make.
#ifndef CLERS_CODEC_TEST_GOLDEN_MESHES_H
#define CLERS_CODEC_TEST_GOLDEN_MESHES_H

#include <cstdint>
#include <vector>

#include "codec/mesh.h"

namespace clers::test {

struct NamedMesh {
  const char* name;
  Mesh mesh;
};

/// Surfaces as they are: nothing to cut.
std::vector<NamedMesh> surfaces();

/// Faces that a surface does not have, or not so.
std::vector<NamedMesh> defects();

/// Without attributes.
Mesh bare(Mesh mesh);

/// Generators compute places in doubles, which may differ in the last bit from one library or
/// processor to the next; their multiples of 1/1024 do not.
Mesh steady(Mesh mesh);

/// Makes quadrilaterals of `percent` of the pairs of triangles that generators split them into.
Mesh quads(const Mesh& mesh, unsigned percent = 100, std::uint64_t seed = 0);

}  // namespace clers::test

#endif

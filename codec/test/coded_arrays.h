// Coded surfaces without twins: of meshes, and any at all.
#ifndef CLERS_CODEC_TEST_CODED_ARRAYS_H
#define CLERS_CODEC_TEST_CODED_ARRAYS_H

#include <cstdint>
#include <random>

#include "codec/connectivity/coded_surface.h"
#include "codec/mesh.h"
#include "codec/test/coded_surfaces.h"

namespace clers::internal::test {

/// What is coded of a mesh, with its twins left out.
inline CodedArrays coded_without_twins(const Mesh& mesh) {
  CodedArrays arrays = coded(mesh);
  arrays.twins.clear();
  return arrays;
}

/// Any triangles on any of these vertices: what faces that are coded one by one may look like.
inline CodedArrays any_triangles(std::uint32_t vertices, std::uint32_t triangles,
                                 std::mt19937_64& random) {
  CodedArrays arrays;
  for (std::uint32_t i = 0; i < 3 * triangles; ++i)
    arrays.corners.push_back(static_cast<std::uint32_t>(random() % vertices));
  arrays.introduced_by.resize(vertices);
  find_introducing(arrays.corners, arrays.introduced_by);
  return arrays;
}

}  // namespace clers::internal::test

#endif

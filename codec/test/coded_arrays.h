// Coded surfaces without twins: of meshes, and any at all.
#ifndef CLERS_CODEC_TEST_CODED_ARRAYS_H
#define CLERS_CODEC_TEST_CODED_ARRAYS_H

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "codec/connectivity/coded_surface.h"
#include "codec/connectivity/connectivity.h"
#include "codec/mesh.h"
#include "codec/test/polygon_surface.h"

namespace clers::internal::test {

/// What is coded of a mesh, with its twins left out.
inline CodedArrays coded(const Mesh& mesh) {
  SurfaceCopy consumed = surface_of(mesh);
  auto connectivity = encode_connectivity(consumed.arrays(), 3, true);
  EXPECT_TRUE(connectivity.ok());
  consumed = surface_of(mesh);
  CodedArrays arrays = coded_surface(consumed.arrays(), *connectivity);
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

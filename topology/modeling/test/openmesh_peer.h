// Subdivision by OpenMesh, on plain arrays.
#ifndef CLERS_TOPOLOGY_MODELING_TEST_OPENMESH_PEER_H
#define CLERS_TOPOLOGY_MODELING_TEST_OPENMESH_PEER_H

#include <array>
#include <cstdint>
#include <vector>

namespace clers::test {

struct Plain {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

enum class PeerScheme { loop, sqrt3 };

/// `times` steps; `seconds`, of processor time, are those of the steps alone.
Plain subdivide_by_openmesh(const Plain& mesh, PeerScheme scheme, unsigned times,
                            double* seconds = nullptr);

}  // namespace clers::test

#endif

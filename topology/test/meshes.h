// Small surfaces for tests.
#ifndef CLERS_TOPOLOGY_TEST_MESHES_H
#define CLERS_TOPOLOGY_TEST_MESHES_H

#include <array>
#include <cstdint>
#include <vector>

#include "topology/surface.h"

namespace clers::test {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// The surface of triangles over shared vertex indices; no two half-edges may run between the same
/// two vertices the same way.
Surface from_triangles(const Triangles& triangles);

/// columns x rows squares, each cut into two triangles: a disk.
Surface grid(std::uint32_t columns, std::uint32_t rows);

/// The same with opposite sides glued; at least 3 x 3.
Surface torus(std::uint32_t columns, std::uint32_t rows);

/// `tori` tori in a row, each with a triangle removed and glued to the next: genus `tori`.
Surface chain_of_tori(std::uint32_t tori, std::uint32_t side);

}  // namespace clers::test

#endif

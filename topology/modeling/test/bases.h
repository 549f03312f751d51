// Tri-quad meshes to adapt, most of them no simplicial complexes.
#ifndef CLERS_TOPOLOGY_MODELING_TEST_BASES_H
#define CLERS_TOPOLOGY_MODELING_TEST_BASES_H

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "topology/surface.h"

namespace clers::test {

/// Triangles glued along these pairs of half-edges, one pair after the other.
Surface glued(std::uint32_t faces, std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs);

/// Quadrilaterals as blocks and larger polygons cut, then Program 5 where a triangle is left; the
/// first diagonal of each. All edges are equally long.
Surface tri_quad_of(std::span<const std::uint32_t> sizes, std::span<const std::uint32_t> corners,
                    std::uint32_t vertices);
/// Program 5 on any surface.
Surface tri_quad_of(Surface surface);

struct Base {
  const char* name;
  Surface surface;
};
/// Closed and open, of genus 0, 1 and 2, simplicial complexes and others.
std::vector<Base> bases();

/// Any tri-quad mesh whatever: split edges glued to split edges, sides to sides, as the choices
/// say. No choices: one face.
Surface random_base(std::span<const std::uint16_t> choices);

/// The cube of six quadrilaterals, as arrays.
extern const std::vector<std::uint32_t> cube_sizes, cube_corners;

}  // namespace clers::test

#endif

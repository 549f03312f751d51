// Surfaces of polygons, whose quadrilaterals are blocks of a tri-quad mesh (four_eight.h).
#ifndef CLERS_TOPOLOGY_MODELING_BASE_MESH_H
#define CLERS_TOPOLOGY_MODELING_BASE_MESH_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <clers/topology/export.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// A surface in which polygons are cut into triangles, and the diagonals of its quadrilaterals, a
/// half-edge of each: half-edge 1 of both its faces. make_tri_quad takes both.
struct PolygonSurface {
  Surface surface;
  std::vector<HalfEdge> quads;
};

/// The surface of polygons given by their sizes and all corners one after the other,
/// counterclockwise: `n` vertices. A quadrilateral (a b c d) is cut from b to d into (a b d) and
/// (c d b), or from a to c into (b c a) and (d a c) where `across(a, b, c, d)` is true: if a-c is
/// shorter, say; it is called with vertices below n only. Larger polygons are cut from their first
/// corner. Faces are in the order of polygons, vertex i is on point i.
///
/// Errors: `array_sizes` if sizes below 3 occur or do not add up (element: the polygon, or their
/// number); else as Surface::from_faces, of the triangles. Cost: O(corners + n + B log B).
template <class Across>
Result<PolygonSurface, BrokenRule> surface_of_polygons(std::span<const std::uint32_t> sizes,
                                                       std::span<const std::uint32_t> corners,
                                                       std::uint32_t n, Across&& across) {
  std::vector<std::uint32_t> triangles;
  std::vector<HalfEdge> quads;
  std::size_t first = 0;
  for (std::size_t p = 0; p < sizes.size(); ++p) {
    const std::size_t left = corners.size() - first;
    if (sizes[p] < 3 || sizes[p] > left || triangles.size() / 3 > max_faces - sizes[p])
      return Failure{BrokenRule{FaceRule::array_sizes, static_cast<std::uint32_t>(p)}};
    const auto v = corners.subspan(first, sizes[p]);
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      triangles.insert(triangles.end(), {a, b, c});
    };
    if (v.size() == 4) {
      quads.push_back(half_edge(Face(static_cast<std::uint32_t>(triangles.size() / 3)), 1));
      const bool known = std::max(std::max(v[0], v[1]), std::max(v[2], v[3])) < n;
      const unsigned turn = known && across(v[0], v[1], v[2], v[3]) ? 1 : 0;
      add(v[turn], v[turn + 1], v[(turn + 3) % 4]);
      add(v[turn + 2], v[(turn + 3) % 4], v[turn + 1]);
    } else {
      for (std::size_t i = 2; i < v.size(); ++i) add(v[0], v[i - 1], v[i]);
    }
    first += sizes[p];
  }
  if (first != corners.size())
    return Failure{BrokenRule{FaceRule::array_sizes, static_cast<std::uint32_t>(sizes.size())}};
  Result<Surface, BrokenRule> surface = Surface::from_faces(triangles, n);
  if (!surface) return Failure{surface.error()};
  return PolygonSurface{std::move(*surface), std::move(quads)};
}

}  // namespace clers

#endif

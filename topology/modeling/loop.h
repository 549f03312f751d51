// Loop subdivision: one triangle becomes four, by edge splits and flips (CAGD 2010, §7.3).
#ifndef CLERS_TOPOLOGY_MODELING_LOOP_H
#define CLERS_TOPOLOGY_MODELING_LOOP_H

#include <span>
#include <vector>

#include <clers/modeling/creases.h>
#include <clers/modeling/geometry.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// Where a vertex goes in a step: 1 - a, and a/n for each of n neighbours, a(n) = (40 - (3 + 2 cos
/// 2pi/n)^2) / 64 (Loop 1987); on a sharp curve 3/4, and 1/8 for each neighbour on it; corners
/// stay.
void loop_vertex_mask(const Surface& surface, const Creases& creases, Vertex v,
                      std::vector<Term>& mask);
/// The vertex put on an edge: 3/8 for each end, 1/8 for each opposite vertex; 1/2, 1/2 if sharp.
void loop_edge_mask(const Surface& surface, const Creases& creases, HalfEdge h,
                    std::vector<Term>& mask);
/// Where a vertex goes in the limit of all steps, from where it and its neighbours are now.
void loop_limit_mask(const Surface& surface, const Creases& creases, Vertex v,
                     std::vector<Term>& mask);

/// The connectivity alone: splits all edges, and flips those new ones that lead to old vertices.
/// Which vertex is on which of `edges`. Preconditions: those of subdivide_loop hold, `edges` are
/// all, each once.
std::vector<Vertex> loop_refine(Surface& surface, Creases& creases,
                                std::span<const HalfEdge> edges);
/// Are there ids for all new faces, and two faces at every interior edge?
Result<Done, Violation> loop_check(const Surface& surface);

/// One step. F faces become 4F; b, g and s stay. The surface need not be a simplicial
/// complex. New vertices are on the null point.
///
/// Preconditions: `ids_left`; `two_faces` of every interior edge; the geometry has values of all
/// vertices. When memory runs out it throws std::bad_alloc: the surface is valid, but may be partly
/// subdivided. Cost: O(F), and the degrees of vertices once. Ids: vertices stay; faces are reused.
template <class Geometry>
Result<Done, Violation> subdivide_loop(Surface& surface, Geometry& geometry, Creases& creases) {
  if (const auto ok = loop_check(surface); !ok) return ok;
  std::vector<Term> mask;
  const std::vector<Face> faces = newest_faces(surface);
  Moves<Geometry> moves(
      vertices_along(surface, faces), geometry,
      [&](Vertex v, std::vector<Term>& of_v) { loop_vertex_mask(surface, creases, v, of_v); });
  const std::vector<HalfEdge> edges = edges_along(surface, faces);
  std::vector<typename Geometry::Value> values;
  values.reserve(edges.size());
  for (const HalfEdge h : edges) {
    loop_edge_mask(surface, creases, h, mask);
    values.push_back(geometry.combine(mask));
  }
  const std::vector<Vertex> made = loop_refine(surface, creases, edges);
  reserve_values(geometry, surface.vertex_limit());
  moves.set(geometry);
  for (std::size_t i = 0; i < made.size(); ++i) geometry.set(made[i], std::move(values[i]));
  return Done{};
}

}  // namespace clers

#endif

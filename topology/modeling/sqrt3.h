// Square root of 3 subdivision (Kobbelt 2000; CAGD 2010, §7.3, Algorithm 4, Fig. 15).
#ifndef CLERS_TOPOLOGY_MODELING_SQRT3_H
#define CLERS_TOPOLOGY_MODELING_SQRT3_H

#include <array>
#include <span>
#include <vector>

#include <clers/modeling/creases.h>
#include <clers/modeling/geometry.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// Steps come in pairs: two of them cut every edge in three. A sharp edge (one on the boundary
/// too), which must not be flipped, waits through the first of a pair and is cut in three by the
/// second.
enum class Sqrt3Step { first, second };

/// Where a vertex goes in a step: 1 - a, and a/n for each of n neighbours, a(n) = (4 - 2 cos 2pi/n)
/// / 9; on a sharp curve it stays in the first step and in the second goes to 19/27, and 4/27 for
/// each neighbour on it; corners stay.
void sqrt3_vertex_mask(const Surface& surface, const Creases& creases, Vertex v, Sqrt3Step step,
                       std::vector<Term>& mask);
/// Of the two vertices that cut the edge in three, that near org(h): 16/27 and 10/27 of the ends
/// and 1/27 of the neighbour of org(h) on the curve. Where no curve goes on, the edge does,
/// straight.
void sqrt3_edge_mask(const Surface& surface, const Creases& creases, HalfEdge h,
                     std::vector<Term>& mask);
/// The same from its other end.
void sqrt3_edge_mask_at_dest(const Surface& surface, const Creases& creases, HalfEdge h,
                             std::vector<Term>& mask);
/// Where a vertex goes in the limit of all pairs of steps, from where it and its neighbours are
/// now, before the first of a pair.
void sqrt3_limit_mask(const Surface& surface, const Creases& creases, Vertex v,
                      std::vector<Term>& mask);

/// The faces that the step splits, and the edges that it cuts in three, in the order of `faces`,
/// which are all.
struct Sqrt3Plan {
  std::vector<Face> faces;
  std::vector<HalfEdge> edges;
};
Result<Sqrt3Plan, Violation> sqrt3_plan(const Surface& surface, const Creases& creases,
                                        Sqrt3Step step, std::span<const Face> faces);
/// The vertices that were put there; of an edge, that near org(h) first.
struct Sqrt3Made {
  std::vector<Vertex> in_faces;
  std::vector<std::array<Vertex, 2>> on_edges;
};
/// The connectivity alone: splits, then flips of all old edges that are not sharp.
Sqrt3Made sqrt3_refine(Surface& surface, Creases& creases, const Sqrt3Plan& plan);

/// One step. F faces become 3F; b, g and s stay. Works on surfaces that are no simplicial complex,
/// too. New vertices are on the null point.
///
/// Preconditions: `ids_left`; `one_sharp_edge` of every face, in the second step of a pair (the
/// first sees to it); `two_faces` of every interior edge that is cut; the geometry has values of
/// all vertices. When memory runs out it throws std::bad_alloc: the surface is valid, but may be
/// partly subdivided. Cost: O(F), and the degrees of vertices once. Ids: all stay valid.
template <class Geometry>
Result<Done, Violation> subdivide_sqrt3(Surface& surface, Geometry& geometry, Creases& creases,
                                        Sqrt3Step step) {
  std::vector<Term> mask;
  const std::vector<Face> faces = newest_faces(surface);
  const auto plan = sqrt3_plan(surface, creases, step, faces);
  if (!plan) return Failure{plan.error()};
  Moves<Geometry> moves(vertices_along(surface, faces), geometry,
                        [&](Vertex v, std::vector<Term>& of_v) {
                          sqrt3_vertex_mask(surface, creases, v, step, of_v);
                        });
  std::vector<typename Geometry::Value> in_faces, on_edges;
  in_faces.reserve(plan->faces.size());
  for (const Face f : plan->faces) {
    face_mask(surface, f, mask);
    in_faces.push_back(geometry.combine(mask));
  }
  on_edges.reserve(2 * plan->edges.size());
  for (const HalfEdge h : plan->edges) {
    sqrt3_edge_mask(surface, creases, h, mask);
    on_edges.push_back(geometry.combine(mask));
    sqrt3_edge_mask_at_dest(surface, creases, h, mask);
    on_edges.push_back(geometry.combine(mask));
  }
  const Sqrt3Made made = sqrt3_refine(surface, creases, *plan);
  reserve_values(geometry, surface.vertex_limit());
  moves.set(geometry);
  for (std::size_t i = 0; i < in_faces.size(); ++i)
    geometry.set(made.in_faces[i], std::move(in_faces[i]));
  for (std::size_t i = 0; i < on_edges.size(); ++i)
    geometry.set(made.on_edges[i / 2][i % 2], std::move(on_edges[i]));
  return Done{};
}

}  // namespace clers

#endif

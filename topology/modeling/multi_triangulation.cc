// Levels, and what refine and simplify look at before they change anything.
#include "topology/modeling/multi_triangulation.h"

#include <algorithm>

namespace CLERS_VISIBLE clers {

MultiTriangulation::MultiTriangulation(Surface base)
    : surface_(std::move(base)), level_(surface_.vertex_limit()) {}

Result<MultiTriangulation, Violation> MultiTriangulation::over(Surface base) {
  if (const auto ok = check_tri_quad(base); !ok) return Failure{ok.error()};
  return MultiTriangulation(std::move(base));
}

MultiTriangulation::Growth MultiTriangulation::growth(HalfEdge h) const {
  const auto faces_at = [&](HalfEdge edge) { return surface_.is_boundary(edge) ? 1u : 2u; };
  Growth all{1, faces_at(h)};
  // Each face of h whose split edge is another waits for that, which waits for the face beyond if
  // that is coarser, and so on. Both chains go through the same levels, edge by edge, and may meet.
  std::array<HalfEdge, 2> edges;
  std::size_t chains = 0;
  for (const HalfEdge side : surface_.star(h))
    if (corner(side) != 1) edges[chains++] = half_edge(left(side), 1);
  while (chains != 0) {
    if (chains == 2 && surface_.same_edge(edges[0], edges[1])) chains = 1;
    std::size_t longer = 0;
    for (std::size_t i = 0; i < chains; ++i) {
      ++all.splits, all.faces += faces_at(edges[i]);
      const HalfEdge beyond = surface_.sym(edges[i]);
      if (beyond && corner(beyond) != 1) edges[longer++] = half_edge(left(beyond), 1);
    }
    chains = longer;
  }
  return all;
}

std::optional<Violation> MultiTriangulation::refuse_refine(HalfEdge h) const {
  if (!surface_.is_live(h)) return Violation{Precondition::live_half_edge, h.index()};
  for (const HalfEdge side : surface_.star(h))
    if (level(left(side)) + (corner(side) == 1 ? 0 : 1) >= max_level)
      return Violation{Precondition::levels_left, h.index()};
  if (makes_more_faces(h, max_faces - surface_.characteristic().f))
    return Violation{Precondition::ids_left, max_faces};
  return std::nullopt;
}

std::optional<Violation> MultiTriangulation::refuse_simplify(Vertex v) const {
  if (!surface_.is_live(v)) return Violation{Precondition::live_vertex, v.index()};
  if (level(v) == 0) return Violation{Precondition::refined_vertex, v.index()};
  return std::nullopt;
}

Vertex MultiTriangulation::finer_neighbour(Vertex v) const {
  Vertex finest = v;
  for (const Vertex u : surface_.adjacent_vertices(v))
    if (level(u) > level(finest)) finest = u;
  return finest == v ? Vertex() : finest;
}

}  // namespace clers

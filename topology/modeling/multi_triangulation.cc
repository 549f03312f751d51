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

unsigned MultiTriangulation::splits(HalfEdge h) const {
  // A split edge waits for at most one face, that beyond it; an edge that is none, for two.
  unsigned count = 1;
  for (const HalfEdge side : surface_.star(h)) {
    HalfEdge edge = half_edge(left(side), 1);
    if (edge == side) continue;
    for (;;) {
      ++count;
      const HalfEdge beyond = surface_.sym(edge);
      if (!beyond || corner(beyond) == 1) break;
      edge = half_edge(left(beyond), 1);
    }
  }
  return count;
}

std::optional<Violation> MultiTriangulation::refuse_refine(HalfEdge h) const {
  if (!surface_.is_live(h)) return Violation{Precondition::live_half_edge, h.index()};
  for (const HalfEdge side : surface_.star(h))
    if (level(left(side)) + (corner(side) == 1 ? 0 : 1) >= max_level)
      return Violation{Precondition::levels_left, h.index()};
  constexpr std::int64_t most = 2 * (2 * (max_level + 1) + 1);  // faces that one call can make
  if (surface_.characteristic().f > max_faces - most &&
      surface_.characteristic().f > max_faces - 2 * std::int64_t{splits(h)})
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

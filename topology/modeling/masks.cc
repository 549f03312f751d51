// Smooth, along a curve, or fixed.
#include "topology/modeling/masks.h"

namespace CLERS_VISIBLE clers {

void vertex_mask(const Surface& surface, const Creases& creases, Vertex v,
                 double (*ring)(std::uint32_t degree), double along, std::vector<Term>& mask) {
  const SharpEdges sharp = sharp_edges(surface, creases, v);
  mask.clear();
  if (sharp.smooth()) {
    const std::uint32_t n = surface.degree(v);
    const double shared = ring(n);
    mask.push_back({v, 1 - shared});
    for (const Vertex x : surface.adjacent_vertices(v)) mask.push_back({x, shared / n});
  } else if (sharp.curve() && along > 0) {
    mask = {{v, 1 - along}, {sharp.ends[0], along / 2}, {sharp.ends[1], along / 2}};
  } else {
    mask = {{v, 1}};
  }
}

void edge_mask(const Surface& surface, const Creases& creases, HalfEdge h, double end,
               std::vector<Term>& mask) {
  const bool sharp = creases.is_sharp(surface, h);
  mask = {{surface.org(h), sharp ? 0.5 : end}, {surface.dest(h), sharp ? 0.5 : end}};
  if (sharp) return;
  for (const HalfEdge opposite : surface.link(h))
    mask.push_back({surface.org(opposite), 0.5 - end});
}

}  // namespace clers

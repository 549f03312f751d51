// The refinement of 4-8 subdivision: splits of the edges opposite to the newest vertices.
#include "topology/modeling/four_eight.h"

#include <algorithm>
#include <numeric>

#include "topology/modeling/masks.h"

namespace CLERS_VISIBLE clers {

bool is_split_edge(const Surface& surface, HalfEdge h) {
  return corner(h) == 1 && (surface.is_boundary(h) || corner(surface.sym(h)) == 1);
}

Result<Done, Violation> check_tri_quad(const Surface& surface) {
  for (const Face f : surface.faces()) {
    const HalfEdge h = half_edge(f, 1);
    if (!is_split_edge(surface, h)) return Failure{Violation{Precondition::tri_quad, h.index()}};
  }
  return Done{};
}

Clusters cluster_faces(const Surface& surface, const Creases& creases,
                       std::span<const HalfEdge> edges, std::span<const double> lengths,
                       std::span<const HalfEdge> quads) {
  std::vector<bool> taken(surface.face_limit());
  Clusters clusters;
  const auto take = [&](HalfEdge h) {
    for (const HalfEdge side : surface.star(h)) taken[left(side).index()] = true;
    clusters.pairs.push_back(h);
  };
  if (!quads.empty()) {
    for (const HalfEdge h : quads)
      if (!taken[left(h).index()]) take(h);
    std::vector<bool> mixed;  // by component: some face is of no quadrilateral
    const auto of = [&](Face f) -> std::size_t { return surface.component(f).index(); };
    for (const Face f : surface.faces()) {
      if (of(f) >= mixed.size()) mixed.resize(of(f) + 1);
      if (!taken[f.index()]) mixed[of(f)] = true;
    }
    std::erase_if(clusters.pairs, [&](HalfEdge h) { return !mixed[of(left(h))]; });
  }
  std::vector<std::uint32_t> order(edges.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return lengths[a] > lengths[b]; });
  for (const std::uint32_t i : order) {
    const HalfEdge h = edges[i];
    if (creases.is_sharp(surface, h)) continue;
    const Face f = left(h), g = left(surface.sym(h));
    if (f == g || taken[f.index()] || taken[g.index()]) continue;
    take(h);
  }
  for (const Face f : surface.faces())
    if (!taken[f.index()]) clusters.single.push_back(f);
  return clusters;
}

void four_eight_vertex_mask(const Surface& surface, const Creases& creases, Vertex v,
                            std::vector<Term>& mask) {
  mask.clear();
  const SharpEdges sharp = sharp_edges(surface, creases, v);
  if (sharp.smooth()) {
    mask.push_back({v, 0.5});
    for (const HalfEdge h : surface.star(v))
      if (!is_split_edge(surface, h)) mask.push_back({surface.other_end(h, v), 0});
    for (std::size_t i = 1; i < mask.size(); ++i)
      mask[i].weight = 0.5 / static_cast<double>(mask.size() - 1);
  } else if (sharp.curve() && is_split_edge(surface, sharp.edges[0]) &&
             is_split_edge(surface, sharp.edges[1])) {
    mask = {{v, 0.75}, {sharp.ends[0], 0.125}, {sharp.ends[1], 0.125}};
  } else {
    mask = {{v, 1}};
  }
}

void four_eight_edge_mask(const Surface& surface, const Creases& creases, HalfEdge h,
                          std::vector<Term>& mask) {
  edge_mask(surface, creases, h, 0.25, mask);
}

}  // namespace clers

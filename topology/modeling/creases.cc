// Marks by half-edge that follow what refines.
#include "topology/modeling/creases.h"

#include <algorithm>

namespace CLERS_VISIBLE clers {

void Creases::mark(const Surface& surface, HalfEdge h) {
  for (const HalfEdge side : surface.star(h)) {
    if (side.index() >= sharp_.size()) sharp_.resize(surface.half_edge_limit());
    sharp_[side.index()] = 1;
  }
  any_ = true;
}

std::vector<Vertex> Creases::unmark(const Surface& surface, Vertex v) {
  std::vector<Vertex> ends;
  for (const HalfEdge h : surface.star(v)) {
    if (h.index() >= sharp_.size() || sharp_[h.index()] == 0) continue;
    ends.push_back(surface.other_end(h, v));
    for (const HalfEdge side : surface.star(h)) sharp_[side.index()] = 0;
  }
  return ends;
}

void Creases::operator()(const Change& change) {
  std::array<std::uint8_t, 12> now{};
  std::size_t i = 0;
  std::uint32_t limit = 0;
  for (const Change::Slot& slot : change.slots()) {
    if (slot.side && slot.side.index() < sharp_.size()) now[i] = sharp_[slot.side.index()];
    limit = std::max(limit, slot.at.index() + 1);
    ++i;
  }
  if (limit > sharp_.size()) sharp_.resize(limit);
  i = 0;
  for (const Change::Slot& slot : change.slots()) sharp_[slot.at.index()] = now[i++];
}

SharpEdges sharp_edges(const Surface& surface, const Creases& creases, Vertex v) {
  SharpEdges sharp;
  if (!creases.any() && !surface.is_boundary(v)) return sharp;
  for (const HalfEdge h : surface.star(v)) {
    if (!creases.is_sharp(surface, h)) continue;
    if (sharp.count < 2) {
      sharp.edges[sharp.count] = h;
      sharp.ends[sharp.count] = surface.other_end(h, v);
    }
    ++sharp.count;
  }
  return sharp;
}

std::vector<HalfEdge> edges_of(const Surface& surface) {
  std::vector<HalfEdge> edges;
  edges.reserve(static_cast<std::size_t>(surface.characteristic().e));
  for (const HalfEdge h : surface.edges()) edges.push_back(h);
  return edges;
}

std::vector<Face> newest_faces(const Surface& surface) {
  const auto count = static_cast<std::size_t>(surface.characteristic().f);
  std::vector<Face> faces;
  faces.reserve(count);
  std::vector<bool> seen(surface.face_limit());
  // Mostly the vertices of one step, a part of all, have all faces.
  for (std::uint32_t i = surface.vertex_limit(); faces.size() < count && i-- > 0;) {
    if (!surface.is_live(Vertex(i))) continue;
    for (const HalfEdge h : surface.fan(Vertex(i))) {
      if (seen[left(h).index()]) continue;
      seen[left(h).index()] = true;
      faces.push_back(left(h));
    }
  }
  return faces;
}

std::vector<Vertex> vertices_along(const Surface& surface, std::span<const Face> faces) {
  std::vector<Vertex> vertices;
  vertices.reserve(static_cast<std::size_t>(surface.characteristic().v));
  std::vector<bool> seen(surface.vertex_limit());
  for (const Face f : faces) {
    for (const HalfEdge h : surface.star(f)) {
      const Vertex v = surface.org(h);
      if (seen[v.index()]) continue;
      seen[v.index()] = true;
      vertices.push_back(v);
    }
  }
  return vertices;
}

std::vector<HalfEdge> edges_along(const Surface& surface, std::span<const Face> faces) {
  std::vector<HalfEdge> edges;
  edges.reserve(static_cast<std::size_t>(surface.characteristic().e));
  std::vector<bool> seen(surface.half_edge_limit());
  for (const Face f : faces) {
    for (const HalfEdge h : surface.star(f)) {
      const HalfEdge e = surface.edge(h);
      if (seen[e.index()]) continue;
      seen[e.index()] = true;
      edges.push_back(h);
    }
  }
  return edges;
}

}  // namespace clers

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

}  // namespace clers

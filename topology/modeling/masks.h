// The masks that schemes of subdivision share.
#ifndef CLERS_TOPOLOGY_MODELING_MASKS_H
#define CLERS_TOPOLOGY_MODELING_MASKS_H

#include <cstdint>
#include <vector>

#include "topology/modeling/creases.h"
#include "topology/modeling/geometry.h"

namespace clers {

/// Of an old vertex, where all neighbours count alike: if it is smooth they share the weight
/// `ring(degree)`, on a sharp curve the two along it share `along`, and the vertex keeps the rest;
/// a corner stays.
void vertex_mask(const Surface& surface, const Creases& creases, Vertex v,
                 double (*ring)(std::uint32_t degree), double along, std::vector<Term>& mask);

/// Of a vertex put on an edge: `end` for each end and the rest for what opposes it; the middle of a
/// sharp edge.
void edge_mask(const Surface& surface, const Creases& creases, HalfEdge h, double end,
               std::vector<Term>& mask);

}  // namespace clers

#endif

// The mask of an old vertex, in schemes that ask all its neighbours alike.
#ifndef CLERS_TOPOLOGY_MODELING_VERTEX_MASK_H
#define CLERS_TOPOLOGY_MODELING_VERTEX_MASK_H

#include <cstdint>
#include <vector>

#include "topology/modeling/creases.h"
#include "topology/modeling/geometry.h"

namespace clers {

/// Where the surface is smooth the neighbours share the weight `ring(degree)`, on a sharp curve the
/// two along it share `along`, and the vertex keeps the rest; a corner stays.
void vertex_mask(const Surface& surface, const Creases& creases, Vertex v,
                 double (*ring)(std::uint32_t degree), double along, std::vector<Term>& mask);

}  // namespace clers

#endif

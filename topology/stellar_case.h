// The cases of the stellar operators that change the resolution (CAGD 2010, §5.2), as weld finds
// them.
#ifndef CLERS_TOPOLOGY_STELLAR_CASE_H
#define CLERS_TOPOLOGY_STELLAR_CASE_H

#include <cstdint>

#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// What a split did, or a weld undid. In brackets the effect of splitting on (v, e, f, b, g, s).
enum class StellarCase : std::uint8_t {
  interior_edge = 0,  ///< (1,3,2,0,0,0): an edge between two faces (Fig. 4)
  boundary_edge = 1,  ///< (1,2,1,0,0,0): an edge of one face (Fig. 5)
  face = 2,           ///< (1,3,2,0,0,0) (Fig. 3 a)
};

}  // namespace clers

#endif

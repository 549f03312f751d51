// The cases of the handle operators (CAGD 2010, §5.1), as glue and unglue find them.
#ifndef CLERS_TOPOLOGY_HANDLE_CASE_H
#define CLERS_TOPOLOGY_HANDLE_CASE_H

#include <cstdint>

#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// What gluing two boundary edges did, or ungluing an interior edge undid. In brackets the effect
/// of gluing on (v, e, f, b, g, s).
enum class HandleCase : std::uint8_t {
  join_components = 0,  ///< type 1a (-2,-1,0,-1,0,-1): edges of two components
  split_curve = 1,      ///< type 1b (-2,-1,0,+1,0,0): edges of one curve, not adjacent
  join_curves = 2,      ///< type 1c (-2,-1,0,-1,+1,0): edges of two curves of one component
  close = 3,            ///< type 2 (0,-1,0,-1,0,0): the two edges of a curve of two
  zip = 4,              ///< zip (-1,-1,0,0,0,0): adjacent edges of a longer curve
  join_components_at_loops = 5,  ///< (-1,-1,0,-2,0,-1): curves of one edge each, two components
  join_curves_at_loops = 6,      ///< (-1,-1,0,-2,+1,0): curves of one edge each, one component
};

}  // namespace clers

#endif

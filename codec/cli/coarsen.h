// A coarse mesh of the same topology, for a base.
#ifndef CLERS_CODEC_CLI_COARSEN_H
#define CLERS_CODEC_CLI_COARSEN_H

#include <cstdint>
#include <functional>

#include "codec/cli/shape.h"
#include "topology/surface.h"

namespace clers::cli {

/// Collapses edges until at most `faces` faces are left, or nothing more can go: components,
/// boundary curves and handles stay, and no face turns against the shape. The vertices that are
/// left are where they were. Which go first: those that are missed least, by quadrics of the planes
/// around them (Garland and Heckbert 1997), and short edges in what is flat. Cost: O(F log F).
void coarsen(Surface& surface, const Shape& shape, std::int64_t faces,
             const std::function<void(double done)>& progress);

}  // namespace clers::cli

#endif

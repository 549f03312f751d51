// Which faces to turn round so that all run the same way.
#ifndef CLERS_CODEC_ORIENTATION_H
#define CLERS_CODEC_ORIENTATION_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/error.h"

namespace clers {

/// A maximal sequence of faces that are turned round.
struct TurnedRun {
  std::uint32_t first;
  std::uint32_t count;
};

/// For each face whether to exchange its corners 1 and 2, so that any two faces at an edge of two
/// run along it in opposite directions: the fewer faces of each component, not its first if it is a
/// tie. Edges of more faces say nothing. Errors: nonorientable, with the first face, in the order
/// of the search, that contradicts others. Cost: a sort. Throws std::bad_alloc only.
Expected<std::vector<bool>> find_orientation(std::span<const std::uint32_t> corners);

}  // namespace clers

#endif

// What only a decoder's view of the surface shows: where the ends of handles are that Edgebreaker
// found, and the valences where it walked over polygons.
#ifndef CLERS_CODEC_CONNECTIVITY_PLACE_HANDLES_H
#define CLERS_CODEC_CONNECTIVITY_PLACE_HANDLES_H

#include "codec/connectivity/edgebreaker.h"

namespace clers::internal {

/// Builds the surface once more, as a decoder will, and looks up where: so the specials that are no
/// holes get their kind, distance, length and recency. False if the traversal is not one of a
/// surface. Cost: linear, and O(log n) amortised for each handle. Throws std::bad_alloc only.
bool place_handles(Traversal& traversal);

/// The same, and the contexts, which must have none yet, get the valences of their pivots.
bool place_handles_and_count_valences(Traversal& traversal);

}  // namespace clers::internal

#endif

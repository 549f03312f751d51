// The script of a traversal once more, from the operators themselves: the slow and obvious way,
// which the full surface of mirror.h and decode_script.h are held against.
#ifndef CLERS_CODEC_CONNECTIVITY_REPLAYED_SCRIPT_H
#define CLERS_CODEC_CONNECTIVITY_REPLAYED_SCRIPT_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "codec/connectivity/decode_script.h"
#include "topology/mirror.h"

namespace clers::internal {

/// Builds the surface again. `org` is what was unbuilt; `pairing` has room for 3 vertex ids a face.
/// Nothing if the traversal is not one of a surface. Counts of symbols are left out.
std::optional<DecodeScript> replayed_script(std::span<const std::uint32_t> org,
                                            std::uint32_t vertex_count, const Traversal& traversal,
                                            BuildingMirror& pairing);

}  // namespace clers::internal

#endif

// The record of a traversal once more, from the operators themselves: the slow and obvious way,
// which the full surface of mirror.h and record.h are held against.
#ifndef CLERS_CODEC_BUILT_RECORD_H
#define CLERS_CODEC_BUILT_RECORD_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "codec/record.h"
#include "topology/mirror.h"

namespace clers {

/// Builds the surface again. `org` is what was unbuilt; `pairing` has room for 3 vertex ids a face.
/// Nothing if the traversal is not one of a surface. Counts of letters are left out.
std::optional<Record> built_record(std::span<const std::uint32_t> org, std::uint32_t vertex_count,
                                   const Traversal& traversal, BuildingMirror& pairing);

}  // namespace clers

#endif

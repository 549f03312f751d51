// Are two meshes the same up to the order of vertices and faces and the corner a face starts with?
#ifndef CLERS_CODEC_COMPARE_H
#define CLERS_CODEC_COMPARE_H

#include <string>

#include "codec/error.h"
#include "codec/mesh.h"
#include "codec/verdict.h"

namespace clers {

/// Compares without any knowledge of the codec: refines classes of vertices by their values and
/// their neighbourhoods until a renumbering is forced, then checks it. Positions may coincide.
/// Attributes are matched by name and domain; their order does not matter, mesh names and metadata
/// do not either. Errors: inconsistent_mesh, too_large (2^32 - 1 corners or more), out_of_memory.
///
/// Cost: n log n in vertices, corners and values, whether or not vertices have values of their own:
/// duplicates, books, hubs, copies of a component too. Where vertices look alike from everywhere
/// and are not (a regular torus, cut and sewn another way), a search takes some seconds more before
/// it gives up.
Expected<Comparison> compare(const Mesh& a, const Mesh& b);

/// The first difference of their metadata, for people ("metadata 'comment': only the first has
/// it"); empty if there is none. The order of entries does not matter.
std::string metadata_difference(const Mesh& a, const Mesh& b);

}  // namespace clers

#endif

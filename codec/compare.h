// Are two meshes the same up to the order of vertices and faces and the corner a face starts with?
#ifndef CLERS_CODEC_COMPARE_H
#define CLERS_CODEC_COMPARE_H

#include <span>
#include <string>

#include <clers/error.h>
#include <clers/mesh.h>
#include <clers/order.h>
#include <clers/topology/export.h>
#include <clers/verdict.h>

namespace CLERS_VISIBLE clers {

/// Compares without any knowledge of the codec: refines classes of vertices by their values and
/// neighbourhoods until a renumbering is forced, then checks it. Positions may coincide. Attributes
/// are matched by name and domain; neither their order nor names and metadata of the meshes matter.
/// An element without a value agrees with such alone. Where both have values by index, elements
/// must share them in both, whatever the numbers of values are, and those that no element has must
/// be there too; else it is only asked which value each element has.
/// Errors: inconsistent_mesh, too_large (2^32 - 1 corners or more), out_of_memory. Thread safe.
///
/// Cost: n log n in vertices, corners and values, also for duplicate faces, many faces at one edge
/// or vertex, and equal components. Where all that surrounds vertices does not distinguish
/// them, but they are different (a regular torus, cut and sewn another way), a search takes
/// some seconds more before it gives up.
Expected<Comparison> compare(const Mesh& a, const Mesh& b);

/// The same with some attributes compared within a tolerance. A NaN agrees with NaNs only, of any
/// bits, an infinity with itself. Never "same" without a renumbering under which all agree;
/// "undecided" where values are too close to each other to find it. Further error: bad_option, a
/// tolerance that is negative or not finite.
Expected<Comparison> compare(const Mesh& a, const Mesh& b, std::span<const Tolerance> tolerances);

/// The same under the renumbering that is given, that which makes `b` of `a` (Encoded::permutations
/// where `b` is `a` encoded and decoded). Further error: bad_option, no such renumbering.
Expected<Comparison> compare(const Mesh& a, const Mesh& b, std::span<const Tolerance> tolerances,
                             const Permutation& renumbering);

/// The first difference of their metadata, for people ("metadata 'comment': only the first has
/// it"); empty if there is none. The order of entries does not matter.
std::string metadata_difference(const Mesh& a, const Mesh& b);

}  // namespace clers

#endif

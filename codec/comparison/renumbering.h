// The proof of a comparison: does this renumbering carry one mesh onto the other? Knows values,
// and trusts no colour.
#ifndef CLERS_CODEC_COMPARISON_RENUMBERING_H
#define CLERS_CODEC_COMPARISON_RENUMBERING_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "codec/comparison/compared_mesh.h"
#include "codec/error.h"
#include "codec/order.h"

namespace clers::internal {

/// Why a renumbering is none.
struct Mismatch {
  std::string what;
  /// With the same renumbering of vertices, nothing else would do either.
  bool is_certain = true;
};

/// What fails when vertex v of one mesh is vertex image[v] of the other, faces and values compared
/// bit by bit or within their tolerance; nothing: they are the same, and the largest differences
/// are in `errors`, one for each attribute. Faces that values within a tolerance do not tell apart
/// pair off in their order. Cost: that of sorting the faces. Precondition: the same counts and
/// attributes, and colour_values was called with Nearness::linked.
std::optional<Mismatch> renumbering_fails(const ComparedMesh& a, const ComparedMesh& b,
                                          const std::vector<std::uint32_t>& image,
                                          std::vector<double>& errors);

/// The same of one renumbering of everything, that makes `b` of `a`: linear. Error: bad_option, it
/// is none of meshes of these sizes.
Expected<std::optional<std::string>> renumbering_fails(const ComparedMesh& a, const ComparedMesh& b,
                                                       const Permutation& renumbering,
                                                       std::vector<double>& errors);

}  // namespace clers::internal

#endif

// A mesh of fewer faces: between plain arrays and the simplification of topology/modeling.
#ifndef CLERS_CODEC_CLI_SIMPLIFY_H
#define CLERS_CODEC_CLI_SIMPLIFY_H

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "codec/cli/extent.h"
#include "codec/error.h"
#include "codec/mesh.h"
#include "topology/characteristic.h"
#include "topology/modeling/simplify.h"

namespace clers::cli {

/// So many faces, or a share of those that there are.
struct FaceCount {
  std::int64_t count = 0;
  std::optional<double> share;
};

struct Fewer {
  std::optional<FaceCount> faces;
  std::optional<Extent> error;
};

struct SimplifiedMesh {
  Mesh mesh;
  std::uint64_t polygons = 0;    ///< that were cut into triangles
  Characteristic before, after;  ///< of triangles
  std::uint64_t copied = 0;      ///< vertices, where the mesh was cut since it was no manifold,
  std::uint64_t reversed = 0;    ///< and faces that were turned,
  std::uint64_t left_out = 0;    ///< and that no surface has
  std::int64_t asked = 0;        ///< faces
  SimplifyEnd ended = SimplifyEnd::faces;
  double error = 0;     ///< how far the surface has moved, at most or nearly so
  double diagonal = 0;  ///< of the bounding box of the input
  double ratio_before = 0, ratio_after = 0;  ///< 5 % of the faces have a worse radius ratio
  std::vector<std::string> notes;            ///< what was not carried over
};

/// Simplifies a mesh, to half its faces if neither a number nor an error is given. All attributes
/// go along (carried.h), seams of values of corners and faces being creases; metadata stay;
/// polygons become triangles; isolated vertices are left out, which the notes say.
///
/// Errors: unsupported (no positions), not_on_grid (a position that is no number below 1e100),
/// too_large. Throws std::bad_alloc.
Expected<SimplifiedMesh> simplify(const Mesh& mesh, const Fewer& how,
                                  const std::function<void(double done)>& progress);

/// Why there are more faces than were asked for, if that is because no fewer would do; else "".
std::string unreached(const SimplifiedMesh& result);
/// One line: "69,451 -> 34,725 triangles, ..".
std::string describe(const SimplifiedMesh& result);
/// The same as a JSON object, of a mesh of this name.
std::string simplified_json(const std::string& name, const SimplifiedMesh& result);

}  // namespace clers::cli

#endif

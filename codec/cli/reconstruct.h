// A surface through the points of a file: between plain arrays and the advancing front of
// topology/modeling.
#ifndef CLERS_CODEC_CLI_RECONSTRUCT_H
#define CLERS_CODEC_CLI_RECONSTRUCT_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "codec/cli/extent.h"
#include "codec/error.h"
#include "codec/mesh.h"
#include "topology/characteristic.h"

namespace clers::cli {

struct Reconstructing {
  std::vector<Extent> radii;  ///< of balls that are pivoted; none: greedily
};

struct ReconstructedMesh {
  Mesh mesh;
  std::size_t points = 0;      ///< of the input; of them
  std::size_t no_place = 0;    ///< have a coordinate that is no number below 1e100
  std::size_t duplicates = 0;  ///< are at the place of an earlier one
  std::size_t unused = 0;      ///< are left over
  std::size_t removed = 0;     ///< faces that were taken away where the surface met itself
  bool with_normals = false;
  std::vector<double> radii;  ///< in units of the positions
  Characteristic after;
  std::size_t open_edges = 0;  ///< with a face on one side alone
  double median_edge = 0;
  double mean_ratio = 0, low_ratio = 0;  ///< radius ratios of faces: the mean; 5 % have less
  std::vector<std::string> notes;        ///< what was not carried over, and what stays open
};

/// Makes faces for the vertices of a mesh, by `clers::reconstruct`
/// (<clers/modeling/reconstruct.h>). Its own faces are left out, and so are vertices that get no
/// face; values of vertices go along. A vertex attribute `normal` of three components says which
/// side is outside.
///
/// Errors: unsupported (no positions, fewer than three places, all on a line, or nothing that a
/// ball of a radius rests on), too_large. Throws std::bad_alloc.
Expected<ReconstructedMesh> reconstruct(const Mesh& mesh, const Reconstructing& how,
                                        const std::function<void(double done)>& progress);

/// One line: "35,947 points -> 69,649 triangles, .. ".
std::string describe(const ReconstructedMesh& result);
/// The same as a JSON object, of a mesh of this name.
std::string reconstructed_json(const std::string& name, const ReconstructedMesh& result);

}  // namespace clers::cli

#endif

// A mesh, triangulated anew as finely as somebody wants it where: between plain arrays and the
// adaptive mesh of topology/modeling.
#ifndef CLERS_CODEC_CLI_ADAPT_H
#define CLERS_CODEC_CLI_ADAPT_H

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "codec/cli/extent.h"
#include "codec/cli/vec3.h"
#include "codec/error.h"
#include "codec/mesh.h"
#include "topology/characteristic.h"

namespace clers::cli {

/// A ball in which the mesh is to be fine.
struct Brush {
  Vec3 centre;
  double radius = 0;
};

struct Adaptation {
  std::vector<Brush> near;        ///< where `level` is asked for; empty: everywhere
  std::optional<unsigned> level;  ///< each halves faces, two halve edges
  std::optional<Extent> edge_length, error;
  std::uint32_t faces = 10'000'000;  ///< at most
  /// An input of more faces is made a base of about so many; none: it is the base itself.
  std::optional<std::uint32_t> base = 2000;
  bool frames = false;  ///< the brush moves, or the levels come one after the other
};

struct AdaptedMesh {
  Mesh mesh;
  Characteristic before, base, after;  ///< of triangles
  unsigned level = 0;                  ///< the greatest of a vertex
  double diagonal = 0;                 ///< of the bounding box of the input
  double error = 0;           ///< the largest distance of the surface from the middle of an edge
  double longest_edge = 0;    ///< and
  double least_angle = 0;     ///< the smallest of a face, in degrees
  std::size_t turned = 0;     ///< faces that look the other way than the surface there
  std::size_t off_shape = 0;  ///< vertices that are not on the surface
  bool limited = false;       ///< `faces` kept it from being all that was asked for
  std::uint32_t frames = 0;
  std::vector<std::string> notes;  ///< what was not carried over
};

/// Adapts a mesh to criteria: a block of faces is split if any asks for it. The input's surface is
/// the shape, which new vertices are put on; quadrilaterals are blocks of the base. Of values of
/// vertices of any type those at the place of the shape are taken; those of corners and faces, and
/// isolated vertices, are left out, which the notes say.
///
/// `frame(mesh)` is called for each frame but the last; false ends it all, with io_failed.
/// Errors: as subdivide, but that polygons are cut into triangles; not_on_grid (a position that is
/// no number below 1e100), bad_option (a way of too many frames). Throws std::bad_alloc.
Expected<AdaptedMesh> adapt(const Mesh& mesh, const Adaptation& how,
                            const std::function<void(double done)>& progress,
                            const std::function<bool(Mesh)>& frame);

/// One line: "69,451 -> 12,344 triangles, .. ".
std::string describe(const AdaptedMesh& result);
/// The same as a JSON object, of a mesh of this name.
std::string adapted_json(const std::string& name, const AdaptedMesh& result);

}  // namespace clers::cli

#endif

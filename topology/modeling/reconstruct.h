// A surface through points of which nothing is known but where they are (CAGD 2010, §7.1).
#ifndef CLERS_TOPOLOGY_MODELING_RECONSTRUCT_H
#define CLERS_TOPOLOGY_MODELING_RECONSTRUCT_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <clers/topology/export.h>
#include <clers/topology/result.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

struct ReconstructionOptions {
  /// Of balls that are rolled over the points (Bernardini et al. 1999), each going on where the one
  /// before came to rest: without normals in one component after the other. A triangle is
  /// made where a ball of such a radius lies on three points and has none inside, so nothing
  /// bridges gaps that a ball falls through. None: greedily, without a limit.
  std::vector<double> radii;
  /// By point, of any length; empty: none. A triangle looks where those of its corners do.
  std::span<const std::array<double, 3>> normals;
  /// Called now and then with the share of points that are done; false: stop there. May be empty.
  std::function<bool(double)> progress;
};

enum class ReconstructionError : std::uint8_t {
  bad_point,       ///< a coordinate is no number below 1e100
  bad_radius,      ///< a radius is no number above 0 and below 1e100
  bad_normals,     ///< not as many as points, or one is no number below 1e100
  too_many_points  ///< more than max_faces / 2
};
/// In words.
const char* describe(ReconstructionError error);

struct Reconstruction {
  /// Vertex i is point i, if that is used. With faces a plain indexed mesh: a manifold.
  Surface surface;
  std::size_t duplicates = 0;  ///< points at the place of one with a lower number
  std::size_t unused = 0;      ///< points that are no vertex, without the duplicates
  std::size_t removed = 0;     ///< faces that were taken away where the surface met itself
  bool stopped = false;        ///< by `progress`
};

/// Grows an oriented manifold with boundary through the points, which need no order: from
/// each edge of the front to the point whose triangle has the smallest empty ball, at most five
/// times as large as that of the triangle beside it, flat triangles first (Cohen-Steiner, Da 2004;
/// no Delaunay triangulation is made, neighbourhoods are looked at); or, if radii are given, by
/// pivoting balls of these. What it cannot decide stays open: see the surface's boundary curves.
///
/// Without normals orientation spreads from face to face, and each component is turned so that its
/// volume is not negative. Which places the triangles have does not depend on the order of
/// points (of several normals at one place the first counts).
///
/// Errors: as above. Throws std::bad_alloc. Cost: O(n log n) time if no place has points by far
/// denser than their neighbours, times the points that are within two radii of a point if radii are
/// given; some 500 bytes a point.
Result<Reconstruction, ReconstructionError> reconstruct(
    std::span<const std::array<double, 3>> points, const ReconstructionOptions& options = {});

}  // namespace clers

#endif

// The surface that an adaptive mesh follows: a triangle mesh, sampled by projection.
#ifndef CLERS_CODEC_CLI_SHAPE_H
#define CLERS_CODEC_CLI_SHAPE_H

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "codec/cli/nearest.h"
#include "codec/cli/vec3.h"
#include "topology/surface.h"

namespace clers::cli {

/// A point of the shape. `weights` are those of the corners of `face` there.
struct Sample {
  Vec3 at;
  Vec3 normal;  ///< of length 1, between the normals of the corners; or null
  Face face;
  std::array<double, 3> weights{1, 0, 0};
  Curve curve;  ///< of the boundary that it is on; null inside
};

/// A triangulated surface with the places of its vertices.
class Shape {
 public:
  /// Precondition: finite places below 1e100, by vertex. Cost: O(F log F).
  Shape(const Surface& surface, const std::vector<Vec3>& at);

  /// The sample at a vertex of the surface.
  const Sample& at(Vertex v) const { return corners_[v.index()]; }
  const std::array<Vertex, 3>& corners(Face f) const { return of_[f.index()]; }

  /// What is put between two samples when the edge between them is split: the point of the shape
  /// nearest to the middle m of a-b, and of a split on the boundary that of the shape's boundary.
  ///
  ///           q               The surface bulges out of a-b, and q is nearest to m. Where it does
  ///        .-'''-.            not, as across a deep pocket, q may be a itself: so q must be over
  ///      a----m----b          the middle half of a-b, or the nearest point as far from a as from b
  ///                           is taken, which makes the two halves equal.
  ///
  /// So that no vertex jumps to another sheet, only that component, or that boundary curve, is
  /// looked at, and of thin sheets the side that faces as a and b do; all sides if there is none.
  Sample between(const Sample& a, const Sample& b, bool boundary) const;

 private:
  std::optional<Nearest::Found> find(const Nearest& where, const Nearest::Query& query,
                                     const Sample& a, const Sample& b,
                                     const std::vector<std::uint32_t>& classes) const;
  Sample sample(Face f, const std::array<double, 3>& weights, const Vec3& at, Curve curve) const;

  std::vector<Sample> corners_;                // by vertex
  std::vector<std::array<Vertex, 3>> of_;      // by face
  std::vector<std::uint32_t> components_;      // by face
  std::vector<HalfEdge> rim_;                  // half-edges on the boundary
  std::vector<std::uint32_t> curves_;          // of each of these
  std::optional<Nearest> faces_, rim_places_;  // by face; by place in rim_
};

}  // namespace clers::cli

#endif

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
  bool on_shape = true;
  double distance = 0;  ///< of the shape from the middle of the edge that it was sampled for
};

/// A triangulated surface with the places of its vertices.
class Shape {
 public:
  /// Precondition: finite places below 1e100, by vertex. Cost: O(F log F).
  Shape(const Surface& surface, const std::vector<Vec3>& at);

  /// The sample at a vertex of the surface.
  const Sample& at(Vertex v) const { return corners_[v.index()]; }
  const std::array<Vertex, 3>& corners(Face f) const { return of_[f.index()]; }

  /// What is put between two samples when the edge between them is split: the point q of the shape
  /// nearest to the middle m of a-b, and of a split on the boundary that of the shape's boundary.
  ///
  ///           q               So that no vertex jumps to another sheet, only that component, or
  ///        .-'''-.            that boundary curve, is looked at, and of thin sheets the side that
  ///      a----m----b          faces as a and b do.
  ///
  /// Where that is over no middle part of a-b, as across a deep pocket, whose rim a is the nearest
  /// itself, it is the nearest of those as far from a as from b; then of those that face anyhow.
  /// All must be near enough to make the parts of a-b shorter than a-b, so that refinement ends.
  /// Where nothing is, it is m, and not on the shape: a and b are on two sheets.
  Sample between(const Sample& a, const Sample& b, bool boundary) const;

 private:
  Sample sample(Face f, const std::array<double, 3>& weights, const Vec3& at, Curve curve) const;

  /// What a sample may be on: a component or a boundary curve.
  struct Part {
    std::vector<HalfEdge> of;        // of each triangle its half-edge 0; of each segment its own
    std::optional<Nearest> nearest;  // by place in `of`
  };

  std::vector<Sample> corners_;            // by vertex
  std::vector<std::array<Vertex, 3>> of_;  // by face
  std::vector<Component> component_;       // by face
  std::vector<Part> components_, curves_;
};

}  // namespace clers::cli

#endif

// The experiment of Fig. 19 of Topological mesh operators (§7.5): a sphere in the field of Enright
// et al. (2005), on a mesh that adapts.
#ifndef CLERS_TOPOLOGY_FIGURES_DEFORMING_SPHERE_H
#define CLERS_TOPOLOGY_FIGURES_DEFORMING_SPHERE_H

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "topology/modeling/adaptive_mesh.h"
#include "topology/modeling/dynamic_adaptation.h"

namespace clers::figures {

using Vector = std::array<double, 3>;

/// The surface is the image of the sphere of radius 0.15 about (0.35, 0.35, 0.35) under the flow of
/// the field, equation (1). The paper tracks it as a level set; here a vertex moves with the flow,
/// and a new one is sampled where the flow takes the middle of its ends' places on the sphere, so
/// that every vertex is on the surface to the accuracy of the integration (Runge-Kutta, 4th order).
///
/// The mesh wants edges whose normals at the ends differ by `turn` radians, none longer than
/// `longest` or shorter than `shortest`.
class DeformingSphere {
 public:
  static constexpr double step = 0.012;
  static constexpr double radius = 0.15;

  struct Value {
    Vector start;  ///< where the flow has taken it from: on the sphere
    Vector now;
    Vector normal{};       ///< of length 1, of the mesh
    double curvature = 0;  ///< the most that normals turn along an edge here, for its length
  };
  struct Criterion {
    double turn = 0.5, longest = 0.06, shortest = 0.02;
    double keep = 0.6;  ///< an edge is restored if it is shorter than this part of what is wanted

    double length(double curvature) const {
      return std::fmax(shortest, std::fmin(longest, turn / std::fmax(curvature, 1e-9)));
    }
  };
  struct Sample {
    const unsigned* iteration;
    Value operator()(const Value& a, const Value& b) const;
  };
  using Mesh = AdaptiveMesh<Value, Sample>;

  /// At iteration 0, adapted. The base: a cube's six sides as blocks.
  explicit DeformingSphere(Criterion criterion) : DeformingSphere(criterion, 0) {}
  /// The surface of this iteration, on a mesh that is made from the base at once.
  DeformingSphere(Criterion criterion, unsigned iteration);
  DeformingSphere(const DeformingSphere&) = delete;  // the sampling function reads the iteration
  DeformingSphere& operator=(const DeformingSphere&) = delete;

  /// One iteration of the flow.
  void deform();
  /// Adapts the mesh to where it is now.
  Adapted adapt();

  unsigned iteration() const { return iteration_; }
  const Mesh& mesh() const { return mesh_; }
  const Vector& operator[](Vertex v) const { return mesh_[v].now; }

  /// Of the polyhedron; the flow keeps that of the sphere.
  double volume() const;
  /// The greatest ratio of an edge's length to what is wanted there: 1, if only split edges were
  /// asked and all were split.
  double worst_edge() const;

 private:
  struct Priority {
    DeformingSphere* sphere;
    double operator()(const MultiTriangulation& mesh, HalfEdge h) const;
    double operator()(const MultiTriangulation& mesh, Vertex v) const;
  };
  void find_curvature();

  Criterion criterion_;
  unsigned iteration_ = 0;
  Mesh mesh_;
  std::optional<DynamicAdaptation<Priority>> adaptation_;
};

}  // namespace clers::figures

#endif

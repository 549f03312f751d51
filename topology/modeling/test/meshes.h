// Surfaces with positions, for the tests and the bench of subdivision.
#ifndef CLERS_TOPOLOGY_MODELING_TEST_MESHES_H
#define CLERS_TOPOLOGY_MODELING_TEST_MESHES_H

#include <array>
#include <string>
#include <vector>

#include "codec/mesh.h"
#include "topology/modeling/geometry.h"
#include "topology/modeling/test/openmesh_peer.h"
#include "topology/surface.h"

namespace clers::test {

struct Position : std::array<double, 3> {
  Position() : std::array<double, 3>{} {}
  Position(double x, double y, double z) : std::array<double, 3>{x, y, z} {}
  Position& operator+=(const Position& o) {
    for (std::size_t i = 0; i < 3; ++i) (*this)[i] += o[i];
    return *this;
  }
  friend Position operator*(double k, const Position& p) { return {k * p[0], k * p[1], k * p[2]}; }
};
double distance(const std::array<double, 3>& a, const std::array<double, 3>& b);

using Positions = Averaging<Position>;

struct Shape {
  Surface surface;
  Positions positions;
};

/// Of a manifold triangle mesh.
Shape shape_of(const Mesh& mesh);
Plain plain_of(const Shape& shape);

/// The greatest distance between vertices that are the same in both, or a message: every vertex
/// must be within `tolerance` of just one of the other, and the triangles must be the same then.
struct Agreement {
  std::string wrong;
  double distance = 0;
};
Agreement agree(const Plain& a, const Plain& b, double tolerance);

}  // namespace clers::test

#endif

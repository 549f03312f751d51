#include <meshoptimizer.h>

#include <limits>

#include "bench/simplifiers.h"

namespace clers::bench {
namespace {

Triangles run(const Input& input, std::size_t faces) {
  Triangles out;
  out.corners.resize(input.triangles.size());
  const std::size_t left = meshopt_simplify(
      out.corners.data(), input.triangles.data(), input.triangles.size(), input.positions.data(),
      input.vertex_count, 3 * sizeof(float), 3 * faces, std::numeric_limits<float>::max());
  out.corners.resize(left);
  out.points = triangles_of(input).points;  // it leaves them where they are
  return out;
}

}  // namespace

Simplifier meshopt_simplifier() {
  const int version = MESHOPTIMIZER_VERSION;
  return {
      "meshoptimizer " + std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10),
      run};
}

}  // namespace clers::bench

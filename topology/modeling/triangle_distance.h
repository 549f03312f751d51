// How far a point is from a triangle.
#ifndef CLERS_TOPOLOGY_MODELING_TRIANGLE_DISTANCE_H
#define CLERS_TOPOLOGY_MODELING_TRIANGLE_DISTANCE_H

#include <algorithm>

#include "topology/modeling/placement.h"

namespace clers::internal {

/// Of the origin and the segment from a to b. Ends may be equal.
inline double squared_distance(const Vector3& a, const Vector3& b) {
  const Vector3 along = b - a;
  const double size = squared(along), t = -dot(a, along);
  if (!(t > 0)) return squared(a);
  if (t >= size) return squared(b);
  return squared(a + (t / size) * along);
}

/// Of the origin and a triangle, which may have no area.
inline double squared_distance(const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 n = cross(b - a, c - a);
  const double size = squared(n);
  // Inside the prism over the triangle it is the distance of the plane.
  if (size > 0 && dot(n, cross(a, b)) >= 0 && dot(n, cross(b, c)) >= 0 &&
      dot(n, cross(c, a)) >= 0) {
    const double d = dot(a, n);
    return d * d / size;
  }
  return std::min({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
}

}  // namespace clers::internal

#endif

// The smallest ball through three points that has no other point inside.
#ifndef CLERS_TOPOLOGY_MODELING_EMPTY_BALL_H
#define CLERS_TOPOLOGY_MODELING_EMPTY_BALL_H

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace clers::internal {

using Place = std::array<double, 3>;

inline Place operator-(const Place& a, const Place& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Place along(const Place& a, double t, const Place& d) {
  return {a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]};
}
inline double dot(const Place& a, const Place& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Place cross(const Place& a, const Place& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The balls through three points have their centres on a line: circumcentre + t normal. A point
/// inside some of them leaves a ray of that line; where all rays meet are the centres of empty
/// balls, the edge dual to the triangle in Voronoi's diagram. The triangle is one of Delaunay's if
/// there are any. (Cohen-Steiner, Da: A greedy Delaunay-based surface reconstruction algorithm,
/// 2004, call the radius of the smallest one the triangle's.)
class EmptyBall {
 public:
  /// Nothing where the points are on a line, or nearly.
  static std::optional<EmptyBall> through(const Place& a, const Place& b, const Place& c) {
    const Place u = b - a, v = c - a, n = cross(u, v);
    const double uu = dot(u, u), vv = dot(v, v), nn = dot(n, n);
    if (!(nn > 1e-12 * uu * vv) || !(nn > 0)) return {};
    // Circumcentre from a: (vv (u.u - u.v) u + ..) / 2 nn, as a cross product.
    const Place w{uu * v[0] - vv * u[0], uu * v[1] - vv * u[1], uu * v[2] - vv * u[2]};
    const Place to = cross(w, n);
    EmptyBall ball;
    const Place from_a{to[0] / (2 * nn), to[1] / (2 * nn), to[2] / (2 * nn)};
    ball.circumcentre_ = along(a, 1, from_a);
    ball.squared_ = dot(from_a, from_a);
    const double s = 1 / std::sqrt(nn);
    ball.normal_ = {n[0] * s, n[1] * s, n[2] * s};
    ball.slack_ = 1e-7 * std::sqrt(ball.squared_);
    return ball;
  }

  /// Leaves the balls that p is not inside of; false if none is left. Points near the circle of the
  /// three are taken to be on it.
  bool exclude(const Place& p) {
    const Place q = p - circumcentre_;
    const double h = dot(q, normal_), d = (dot(q, q) - squared_) / 2;
    if (std::abs(h) <= slack_) return d >= -2 * slack_ * std::sqrt(squared_);
    const double t = d / h;
    if (h > 0)
      high_ = std::min(high_, t);
    else
      low_ = std::max(low_, t);
    return low_ <= high_ + slack_;
  }

  const Place& normal() const { return normal_; }
  Place centre() const { return along(circumcentre_, offset(), normal_); }
  /// Of the ball of this radius on the side of the normal, whatever is inside; nothing if the
  /// circle is wider.
  std::optional<Place> centre(double radius) const {
    const double square = radius * radius - squared_;
    if (!(square >= 0)) return {};
    return along(circumcentre_, std::sqrt(square), normal_);
  }
  double squared_radius() const { return squared_ + offset() * offset(); }
  double squared_circumradius() const { return squared_; }

 private:
  double offset() const { return std::max(std::min(0., high_), low_); }

  Place circumcentre_, normal_;
  double squared_ = 0, slack_ = 0;
  double low_ = -std::numeric_limits<double>::infinity();
  double high_ = std::numeric_limits<double>::infinity();
};

}  // namespace clers::internal

#endif

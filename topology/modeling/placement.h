// Where the ends of an edge go when it is contracted: sums over their triangles, and least squares.
//
// P. Lindstrom, G. Turk: Fast and memory efficient polygonal simplification (1998). Only triangles
// of the present mesh count, not those it once had: so a vertex needs no history, and the error
// stays local. Where the new vertex may be is a plane: that on which the volume stays what it is.
#ifndef CLERS_TOPOLOGY_MODELING_PLACEMENT_H
#define CLERS_TOPOLOGY_MODELING_PLACEMENT_H

#include <array>
#include <cmath>
#include <cstddef>

namespace clers::internal {

struct Vector3 : std::array<double, 3> {
  Vector3() : std::array<double, 3>{} {}
  Vector3(double x, double y, double z) : std::array<double, 3>{x, y, z} {}
  explicit Vector3(const std::array<double, 3>& a) : std::array<double, 3>(a) {}
};
inline Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector3 operator*(double k, const Vector3& a) {
  return {k * a[0], k * a[1], k * a[2]};
}
inline double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double squared(const Vector3& a) {
  return dot(a, a);
}

/// A symmetric matrix: a sum of squares of planes through the origin, (n y)^2.
struct Squares {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  void add(const Vector3& n, double times) {
    const Vector3 s = times * n;
    xx += s[0] * n[0], xy += s[0] * n[1], xz += s[0] * n[2];
    yy += s[1] * n[1], yz += s[1] * n[2], zz += s[2] * n[2];
  }
  Squares& operator+=(const Squares& o) {
    xx += o.xx, xy += o.xy, xz += o.xz, yy += o.yy, yz += o.yz, zz += o.zz;
    return *this;
  }
  Squares& operator-=(const Squares& o) {
    xx -= o.xx, xy -= o.xy, xz -= o.xz, yy -= o.yy, yz -= o.yz, zz -= o.zz;
    return *this;
  }
  Vector3 times(const Vector3& x) const {
    return {xx * x[0] + xy * x[1] + xz * x[2], xy * x[0] + yy * x[1] + yz * x[2],
            xz * x[0] + yz * x[1] + zz * x[2]};
  }
  double trace() const { return xx + yy + zz; }
};

/// What a star says about a place for its vertex, as seen from where that is: the planes of its
/// triangles go through the origin.
struct StarSums {
  Squares planes;      ///< six times the volume over each triangle, squared
  Vector3 area;        ///< twice the area vectors
  Vector3 ring;        ///< the neighbours, and
  double squares = 0;  ///< their squares,
  double count = 0;    ///< their number

  void add_face(const Vector3& p, const Vector3& q) {
    const Vector3 n = cross(p, q);
    planes.add(n, 1);
    area = area + n;
  }
  void add_neighbour(const Vector3& p) {
    ring = ring + p;
    squares += squared(p);
    count += 1;
  }
};

/// The area that an edge of a curve sweeps, as three planes through a point of it; times a length,
/// to be a volume: |edge x y|^2.
inline void add_curve(Squares& planes, const Vector3& edge, double length) {
  for (std::size_t i = 0; i < 3; ++i) {
    Vector3 axis;
    axis[i] = length;
    planes.add(cross(axis, edge), 1);
  }
}

/// What the stars of an edge's ends say about a place for both. Places are seen from the middle of
/// the edge; `half` leads from there to the second end.
///
///     (y + half)' P1 (y + half) + (y - half)' P2 (y - half) - y' S y
///
/// P1 and P2 are the sums of the two stars. S are the triangles that are in both: their planes
/// contain the edge, so half' S = 0.
class EdgeSums {
 public:
  EdgeSums(const StarSums& first, const StarSums& second, const Vector3& half)
      : planes_(first.planes),
        linear_(first.planes.times(half) - second.planes.times(half)),
        constant_(dot(half, first.planes.times(half)) + dot(half, second.planes.times(half))),
        area_(first.area + second.area),
        volume_(dot(second.area - first.area, half)),
        ring_(first.ring + second.ring + (second.count - first.count) * half),
        squares_(first.squares + second.squares + 2 * dot(second.ring - first.ring, half) +
                 (first.count + second.count - 2) * squared(half)),
        count_(first.count + second.count - 2) {
    planes_ += second.planes;
  }
  /// A triangle of both stars: its third corner, and twice its area vector.
  void remove_face(const Vector3& corner, const Vector3& n) {
    planes_.add(n, -1);
    area_ = area_ - n;
    ring_ = ring_ - corner;
    squares_ -= squared(corner);
    count_ -= 1;
  }
  /// A curve's edge that ends at the first end (sign 1), at the second (-1), or is the edge (0).
  void add_curve(const Vector3& edge, double length, const Vector3& half, double sign) {
    Squares sum;
    internal::add_curve(sum, edge, length);
    planes_ += sum;
    const Vector3 gradient = sum.times(half);
    linear_ = linear_ + sign * gradient;
    constant_ += sign * sign * dot(half, gradient);
  }

  /// `shape` of the mean square of the edges, beside the squares of the distances from the planes.
  double weight(double shape) const { return count_ > 0 ? shape * planes_.trace() / count_ : 0; }
  /// Of the squares of the edges only what is more than in a star of equilateral triangles counts,
  /// 2 / sqrt(3) of twice its area: so faces may be of any size, if they are round.
  double cost(const Vector3& y, double s) const {
    const double squares = count_ * squared(y) - 2 * dot(ring_, y) + squares_;
    return std::fmax(dot(y, planes_.times(y) + 2 * linear_) + constant_, 0) +
           s * std::fmax(squares - 1.1547 * std::sqrt(squared(area_)), 0);
  }
  double trace() const { return planes_.trace(); }
  /// The place of least cost that keeps the volume; the middle where any will do.
  Vector3 best(double s) const {
    const double area2 = squared(area_);
    return area2 > 1e-12 * planes_.trace() ? on_plane(s, area2) : anywhere(s);
  }

 private:
  /// area y = volume; within the plane, two unknowns.
  Vector3 on_plane(double s, double area2) const {
    const Vector3 y0 = (volume_ / area2) * area_;
    const Vector3 n = (1 / std::sqrt(area2)) * area_;
    Vector3 axis;
    axis[std::fabs(n[0]) < 0.6 ? 0 : 1] = 1;
    Vector3 b1 = cross(n, axis);
    b1 = (1 / std::sqrt(squared(b1))) * b1;
    const Vector3 b2 = cross(n, b1);
    const Vector3 h1 = planes_.times(b1), h2 = planes_.times(b2);
    const double m11 = dot(b1, h1) + s * count_, m12 = dot(b1, h2), m22 = dot(b2, h2) + s * count_;
    const Vector3 r = s * (ring_ - count_ * y0) - planes_.times(y0) - linear_;
    const double r1 = dot(b1, r), r2 = dot(b2, r), det = m11 * m22 - m12 * m12;
    if (!(det > 1e-20 * planes_.trace() * planes_.trace())) return y0;
    return y0 + ((m22 * r1 - m12 * r2) / det) * b1 + ((m11 * r2 - m12 * r1) / det) * b2;
  }
  /// No side is outside, as where a surface is folded upon itself.
  Vector3 anywhere(double s) const {
    const Squares& q = planes_;
    const double a = q.xx + s * count_, d = q.yy + s * count_, f = q.zz + s * count_;
    const Vector3 r = s * ring_ - linear_;
    const double c00 = d * f - q.yz * q.yz, c01 = q.xz * q.yz - q.xy * f,
                 c02 = q.xy * q.yz - q.xz * d, det = a * c00 + q.xy * c01 + q.xz * c02;
    const double t = q.trace();
    if (!(det > 1e-20 * t * t * t)) return {};
    const double c11 = a * f - q.xz * q.xz, c12 = q.xy * q.xz - a * q.yz, c22 = a * d - q.xy * q.xy;
    return (1 / det) * Vector3{c00 * r[0] + c01 * r[1] + c02 * r[2],
                               c01 * r[0] + c11 * r[1] + c12 * r[2],
                               c02 * r[0] + c12 * r[1] + c22 * r[2]};
  }

  Squares planes_;
  Vector3 linear_;
  double constant_;
  Vector3 area_;
  double volume_;
  Vector3 ring_;
  double squares_, count_;
};

}  // namespace clers::internal

#endif

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

/// A sum of (n x - d)^2 over planes: x'Hx - 2cx + k.
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0, k = 0;
  Vector3 c;

  void add(const Vector3& n, double d, double times) {
    const Vector3 s = times * n;
    xx += s[0] * n[0], xy += s[0] * n[1], xz += s[0] * n[2];
    yy += s[1] * n[1], yz += s[1] * n[2], zz += s[2] * n[2];
    c = c + d * s;
    k += times * d * d;
  }
  Quadric& operator+=(const Quadric& o) {
    xx += o.xx, xy += o.xy, xz += o.xz, yy += o.yy, yz += o.yz, zz += o.zz, k += o.k;
    c = c + o.c;
    return *this;
  }
  Vector3 times(const Vector3& x) const {
    return {xx * x[0] + xy * x[1] + xz * x[2], xy * x[0] + yy * x[1] + yz * x[2],
            xz * x[0] + yz * x[1] + zz * x[2]};
  }
  double trace() const { return xx + yy + zz; }
  double at(const Vector3& x) const { return dot(x, times(x)) - 2 * dot(c, x) + k; }
};

/// What a star says about a place for its vertex.
struct StarSums {
  Quadric planes;      ///< six times the volume over each triangle, squared
  Vector3 area;        ///< twice the area vectors
  double volume = 0;   ///< six times that of the tetrahedra from the origin over the triangles
  Vector3 ring;        ///< the neighbours, and
  double squares = 0;  ///< their squares,
  double count = 0;    ///< their number

  void add_face(const Vector3& a, const Vector3& b, const Vector3& c, double times) {
    const Vector3 n = cross(b - a, c - a);
    const double d = dot(n, a);
    planes.add(n, d, times);
    area = area + times * n;
    volume += times * d;
  }
  void add_neighbour(const Vector3& p, double times) {
    ring = ring + times * p;
    squares += times * squared(p);
    count += times;
  }
  /// The area that an edge of a curve sweeps, as three planes; times a length, to be a volume.
  void add_curve(const Vector3& a, const Vector3& b, double length) {
    for (std::size_t i = 0; i < 3; ++i) {
      Vector3 axis;
      axis[i] = length;
      const Vector3 n = cross(axis, b - a);
      planes.add(n, dot(n, a), 1);
    }
  }
  StarSums& operator+=(const StarSums& o) {
    planes += o.planes;
    area = area + o.area;
    volume += o.volume;
    ring = ring + o.ring;
    squares += o.squares;
    count += o.count;
    return *this;
  }

  /// `shape` of the mean square of the edges, beside the squares of the distances from the planes.
  double weight(double shape) const { return count > 0 ? shape * planes.trace() / count : 0; }
  double cost(const Vector3& x, double s) const {
    return std::fmax(planes.at(x), 0) + s * (count * squared(x) - 2 * dot(ring, x) + squares);
  }
  /// The place of least cost that keeps the volume; the middle where any will do.
  Vector3 best(double s, const Vector3& middle) const {
    const double area2 = squared(area);
    return area2 > 1e-12 * planes.trace() ? on_plane(s, area2, middle) : anywhere(s, middle);
  }

 private:
  /// area x = volume; within the plane, two unknowns.
  Vector3 on_plane(double s, double area2, const Vector3& middle) const {
    const Vector3 x0 = middle + ((volume - dot(area, middle)) / area2) * area;
    const Vector3 n = (1 / std::sqrt(area2)) * area;
    Vector3 axis;
    axis[std::fabs(n[0]) < 0.6 ? 0 : 1] = 1;
    Vector3 b1 = cross(n, axis);
    b1 = (1 / std::sqrt(squared(b1))) * b1;
    const Vector3 b2 = cross(n, b1);
    const Vector3 h1 = planes.times(b1), h2 = planes.times(b2);
    const double m11 = dot(b1, h1) + s * count, m12 = dot(b1, h2), m22 = dot(b2, h2) + s * count;
    const Vector3 r = planes.c - planes.times(x0) + s * (ring - count * x0);
    const double r1 = dot(b1, r), r2 = dot(b2, r), det = m11 * m22 - m12 * m12;
    if (!(det > 1e-20 * planes.trace() * planes.trace())) return x0;
    return x0 + ((m22 * r1 - m12 * r2) / det) * b1 + ((m11 * r2 - m12 * r1) / det) * b2;
  }
  /// No side is outside, as where a surface is folded upon itself.
  Vector3 anywhere(double s, const Vector3& middle) const {
    const Quadric& q = planes;
    const double a = q.xx + s * count, d = q.yy + s * count, f = q.zz + s * count;
    const Vector3 r = q.c - q.times(middle) + s * (ring - count * middle);
    const double c00 = d * f - q.yz * q.yz, c01 = q.xz * q.yz - q.xy * f,
                 c02 = q.xy * q.yz - q.xz * d, det = a * c00 + q.xy * c01 + q.xz * c02;
    const double t = q.trace();
    if (!(det > 1e-20 * t * t * t)) return middle;
    const double c11 = a * f - q.xz * q.xz, c12 = q.xy * q.xz - a * q.yz, c22 = a * d - q.xy * q.xy;
    return middle + (1 / det) * Vector3{c00 * r[0] + c01 * r[1] + c02 * r[2],
                                        c01 * r[0] + c11 * r[1] + c12 * r[2],
                                        c02 * r[0] + c12 * r[1] + c22 * r[2]};
  }
};

}  // namespace clers::internal

#endif

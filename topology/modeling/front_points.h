// What the policies of a front know of the points.
#ifndef CLERS_TOPOLOGY_MODELING_FRONT_POINTS_H
#define CLERS_TOPOLOGY_MODELING_FRONT_POINTS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "topology/modeling/advancing_front.h"
#include "topology/modeling/empty_ball.h"
#include "topology/modeling/point_index.h"

namespace clers::internal {

/// Distinct points, what is near them, their normals if there are any, and who waits for them.
class FrontPoints {
 public:
  static constexpr double folded = -0.8660254;  // cosine of 150 degrees

  FrontPoints(std::span<const Place> points, std::span<const Place> normals,
              const std::function<bool(double)>& progress)
      : points_(points), normals_(normals), progress_(progress), index_(points, near_count) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }
  const Place& operator[](std::uint32_t p) const { return points_[p]; }
  const Place& operator[](Point p) const { return points_[p.index()]; }
  const PointIndex& index() const { return index_; }
  std::span<const std::uint32_t> near(std::uint32_t p) const { return index_.near(p); }

  bool have_normals() const { return !normals_.empty(); }
  /// Does a triangle of this normal look where its corners do? Normals of length 0 do not say.
  bool looks_right(std::uint32_t a, std::uint32_t b, std::uint32_t c, const Place& normal) const {
    if (normals_.empty()) return true;
    return dot(normals_[a], normal) + dot(normals_[b], normal) + dot(normals_[c], normal) >= 0;
  }

  /// Of the triangle of a half-edge.
  Place normal_of(const AdvancingFront& front, HalfEdge h) const {
    const Place& from = (*this)[front.origin(h)];
    const Place n = cross((*this)[front.destination(h)] - from, (*this)[front.apex(h)] - from);
    const double s = 1 / std::sqrt(dot(n, n));
    return {n[0] * s, n[1] * s, n[2] * s};
  }

  /// Another face is made. False: who waits wants no more.
  bool count() {
    // There are about two faces a point.
    if (++count_ % 4096 == 0 && progress_)
      stopped_ = !progress_(
          std::min(1., static_cast<double>(count_) / (2 * static_cast<double>(points_.size()))));
    return !stopped_;
  }
  bool stopped() const { return stopped_; }

 private:
  static constexpr std::uint32_t near_count = 12;

  std::span<const Place> points_, normals_;
  const std::function<bool(double)>& progress_;
  PointIndex index_;
  std::size_t count_ = 0;
  bool stopped_ = false;
};

}  // namespace clers::internal

#endif

// Ball pivoting: which triangle a ball that rolls over the points comes to rest on next.
#ifndef CLERS_TOPOLOGY_MODELING_PIVOTING_POLICY_H
#define CLERS_TOPOLOGY_MODELING_PIVOTING_POLICY_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "topology/modeling/front_points.h"

namespace clers::internal {

/// A policy of AdvancingFront (§7.1; Bernardini et al., The ball-pivoting algorithm for surface
/// reconstruction, 1999): a ball of given radius rests on a triangle and has no point inside. It
/// turns about an edge until it meets a point, and rests on the next triangle.
///
///          o  ~~>  x          the centre goes from o to x, around the middle of the edge, which is
///         / \     / \         seen along it here: from a (in front) to b (behind)
///        c   a=b     d        next: (b a d)
///
/// What it meets first counts: where no triangle fits there the edge waits for the next radius.
class PivotingPolicy {
 public:
  struct Step {
    HalfEdge edge;
    Point apex;
  };

  /// Precondition: there are radii, all above 0.
  PivotingPolicy(FrontPoints& points, std::vector<double> radii)
      : points_(points), radii_(std::move(radii)), next_seed_(radii_.size()) {
    std::sort(radii_.begin(), radii_.end());
  }

  std::optional<Step> next(const AdvancingFront& front) {
    for (;;) {
      while (!queue_.empty()) {
        const HalfEdge h = queue_.front();
        queue_.pop_front();
        if (!front.is_candidate(h)) continue;
        if (const auto apex = pivot(front, h)) return Step{h, *apex};
        waiting_.push_back(h);
      }
      // Without normals components may turn out to be reversed where they meet, so there are as few
      // as can be: each is grown with all radii before another is begun.
      if (points_.have_normals() && seed(front, at_radius_)) return {};
      if (at_radius_ + 1 == radii_.size()) {
        if (!points_.have_normals()) waiting_.clear();
        return {};
      }
      ++at_radius_;
      for (const HalfEdge h : waiting_) queue_.push_back(h);
      waiting_.clear();
    }
  }

  void refused(const AdvancingFront&, HalfEdge) {}

  std::optional<std::array<Point, 3>> find_seed(const AdvancingFront& front) {
    for (std::size_t k = points_.have_normals() ? at_radius_ : 0; k < radii_.size(); ++k)
      if (const auto s = seed(front, k)) {
        at_radius_ = k;
        ++next_seed_[k];  // whatever becomes of it
        return s;
      }
    return {};
  }

  bool added(const AdvancingFront& front, Face f) {
    made_with_.resize(front.surface().face_limit());
    made_with_[f.index()] = at_radius_;
    for (const HalfEdge h : front.surface().star(f))
      if (front.is_candidate(h)) queue_.push_back(h);
    return points_.count();
  }

 private:
  static constexpr double slack = 1e-9;  // a share of the radius by which a point may be inside

  /// What grows with the angle of (x, y), from 0 to 4; by single operations, the same everywhere.
  /// Angles that rounding made negative count as 0.
  static double turn(double x, double y) {
    if (y < 0 && -y < 1e-6 * x) return 0;
    if (y >= 0) return x >= 0 ? y / (x + y) : 1 - x / (y - x);
    return x < 0 ? 2 + y / (x + y) : 3 + x / (x - y);
  }

  bool is_empty(const Place& centre, double radius, std::uint32_t a, std::uint32_t b,
                std::uint32_t c) {
    points_.index().within(centre, radius * (1 - slack), found_);
    return std::all_of(found_.begin(), found_.end(),
                       [&](std::uint32_t p) { return p == a || p == b || p == c; });
  }

  std::optional<Point> pivot(const AdvancingFront& front, HalfEdge h) {
    const double radius = radii_[at_radius_];
    const std::uint32_t a = front.origin(h).index(), b = front.destination(h).index();
    const std::uint32_t behind = front.apex(h).index();
    const auto rests = EmptyBall::through(points_[a], points_[b], points_[behind]);
    const auto from = rests ? rests->centre(radius) : std::nullopt;
    if (!from) return {};
    if (made_with_[left(h).index()] != at_radius_ && !is_empty(*from, radius, a, b, behind))
      return {};

    const Place edge = points_[b] - points_[a], middle = along(points_[a], 0.5, edge);
    const Place u = *from - middle;
    const double length = std::sqrt(dot(edge, edge));
    points_.index().within(middle, (radius + std::sqrt(dot(u, u))) * (1 + slack), found_);
    std::sort(found_.begin(), found_.end());
    double least = 4;
    std::uint32_t hit = behind;
    Place normal{}, centre{};
    for (const std::uint32_t c : found_) {
      if (c == a || c == b || c == behind) continue;
      const auto ball = EmptyBall::through(points_[b], points_[a], points_[c]);
      const auto to = ball ? ball->centre(radius) : std::nullopt;
      if (!to) continue;
      const Place v = *to - middle;
      const double turned = turn(dot(u, v), dot(edge, cross(u, v)) / length);
      if (turned >= least) continue;
      least = turned;
      hit = c;
      normal = ball->normal();
      centre = *to;
    }
    if (hit == behind || !(dot(normal, points_.normal_of(front, h)) > FrontPoints::folded) ||
        !points_.looks_right(a, b, hit, normal) || !front.fit(h, Point(hit)))
      return {};
    // It is, but for points that the ball has around it and touches already.
    return is_empty(centre, radius, a, b, hit) ? std::optional(Point(hit)) : std::nullopt;
  }

  /// The first point whose neighbours and it can carry the ball, if the surface is not there yet.
  std::optional<std::array<Point, 3>> seed(const AdvancingFront& front, std::size_t k) {
    for (std::uint32_t& p = next_seed_[k]; p < points_.size(); ++p) {
      if (front.is_used(Point(p))) continue;
      const auto near = points_.near(p);
      for (std::size_t i = 0; i < near.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          for (const auto& [q, r] : {std::pair(near[j], near[i]), std::pair(near[i], near[j])})
            if (front.is_apart(Point(p), Point(q), Point(r)) && carries(p, q, r, radii_[k]))
              return std::array{Point(p), Point(q), Point(r)};
    }
    return {};
  }

  bool carries(std::uint32_t p, std::uint32_t q, std::uint32_t r, double radius) {
    const auto ball = EmptyBall::through(points_[p], points_[q], points_[r]);
    const auto centre = ball ? ball->centre(radius) : std::nullopt;
    if (!centre || !points_.looks_right(p, q, r, ball->normal())) return false;
    for (const std::uint32_t o : points_.near(p)) {  // mostly enough to see that it does not
      const Place d = points_[o] - *centre;
      if (o != q && o != r && dot(d, d) < radius * radius * (1 - 2 * slack)) return false;
    }
    return is_empty(*centre, radius, p, q, r);
  }

  FrontPoints& points_;
  std::vector<double> radii_;
  std::size_t at_radius_ = 0;
  std::vector<std::uint32_t> next_seed_;  // by radius
  std::deque<HalfEdge> queue_;
  std::vector<HalfEdge> waiting_;
  std::vector<std::size_t> made_with_;  // by face: the number of the radius
  std::vector<std::uint32_t> found_;
};

}  // namespace clers::internal

#endif

// Which triangle the front of a reconstruction takes next.
#ifndef CLERS_TOPOLOGY_MODELING_GREEDY_POLICY_H
#define CLERS_TOPOLOGY_MODELING_GREEDY_POLICY_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "topology/modeling/advancing_front.h"
#include "topology/modeling/empty_ball.h"
#include "topology/modeling/front_points.h"

namespace clers::internal {

/// A policy of AdvancingFront: from each edge to the point whose triangle has the smallest empty
/// ball; where the surface stays flat the smallest first, then the others by their angle.
/// (Cohen-Steiner, Da 2004, but that neighbourhoods do for Delaunay's triangulation: a ball that is
/// empty of the neighbours is looked at in the index, too.) The points are distinct.
class GreedyPolicy {
 public:
  struct Step {
    HalfEdge edge;
    Point apex;
  };

  explicit GreedyPolicy(FrontPoints& points) : points_(points) { find_seeds(); }

  std::optional<Step> next(const AdvancingFront& front) {
    while (!queue_.empty()) {
      const Candidate best = queue_.top();
      queue_.pop();
      if (!front.is_candidate(best.edge)) continue;
      if (front.fit(best.edge, best.apex)) {
        radius_of_next_ = best.squared_radius;
        return Step{best.edge, best.apex};
      }
      consider(front, best.edge);
    }
    return {};
  }

  void refused(const AdvancingFront&, HalfEdge) {}

  std::optional<std::array<Point, 3>> find_seed(const AdvancingFront& front) {
    while (at_seed_ < seeds_.size()) {
      const Seed& s = seeds_[at_seed_++];
      if (!front.is_apart(s.corners[0], s.corners[1], s.corners[2])) continue;
      radius_of_next_ = s.squared_radius;
      return s.corners;
    }
    return {};
  }

  bool added(const AdvancingFront& front, Face f) {
    squared_radius_.resize(front.surface().face_limit());
    squared_radius_[f.index()] = radius_of_next_;
    for (const HalfEdge h : front.surface().star(f))
      if (front.is_candidate(h)) consider(front, h);
    return points_.count();
  }

 private:
  static constexpr double growth = 5;               // of radii, from a triangle to the next
  static constexpr double flat_enough = 0.8660254;  // of 30: such triangles come first
  struct Candidate {
    double key;  // the higher the sooner
    HalfEdge edge;
    Point apex;
    double squared_radius;
    bool operator<(const Candidate& o) const { return key != o.key ? key < o.key : edge > o.edge; }
  };
  struct Seed {
    double squared_radius;
    std::array<Point, 3> corners;
  };
  using Near = std::pair<double, std::uint32_t>;  // how far, and what
  struct Trial {
    double squared_radius;
    std::uint32_t apex;
    EmptyBall ball;
  };

  /// The points around an edge, nearest first.
  void gather(std::uint32_t a, std::uint32_t b) {
    local_.clear();
    const auto near_a = points_.near(a);
    for (const std::uint32_t end : {a, b})
      for (const std::uint32_t p : points_.near(end)) {
        if (p == a || p == b) continue;
        if (end == b && std::find(near_a.begin(), near_a.end(), p) != near_a.end()) continue;
        const Place u = points_[p] - points_[a], v = points_[p] - points_[b];
        local_.push_back({dot(u, u) + dot(v, v), p});
      }
    std::sort(local_.begin(), local_.end());
  }

  /// Of the points around (a b) that `may(apex, ball)` be its third the one whose triangle
  /// (b a apex) has the smallest empty ball.
  template <class May>
  std::optional<Trial> smallest(std::uint32_t a, std::uint32_t b, double most, May&& may) {
    gather(a, b);
    for (unsigned round = 0; round < 8; ++round) {
      trials_.clear();
      for (const auto& [far, c] : local_) {
        const auto ball = EmptyBall::through(points_[b], points_[a], points_[c]);
        if (ball && ball->squared_circumradius() <= most && may(c, *ball))
          trials_.push_back({ball->squared_circumradius(), c, *ball});
      }
      std::sort(trials_.begin(), trials_.end(), [](const Trial& x, const Trial& y) {
        return x.squared_radius != y.squared_radius ? x.squared_radius < y.squared_radius
                                                    : x.apex < y.apex;
      });
      std::optional<Trial> best;
      for (Trial& t : trials_) {
        if (best && t.squared_radius >= best->squared_radius) break;
        bool empty = true;
        for (const auto& [far, p] : local_)
          if (p != t.apex && !t.ball.exclude(points_[p])) {
            empty = false;
            break;
          }
        if (!empty) continue;
        t.squared_radius = t.ball.squared_radius();
        if (t.squared_radius <= most && (!best || t.squared_radius < best->squared_radius))
          best = t;
      }
      if (!best || !add_inside(*best, a, b)) return best;
    }
    return {};
  }

  /// Adds the points inside a ball that should be empty.
  bool add_inside(const Trial& t, std::uint32_t a, std::uint32_t b) {
    // A ball through a is within twice its radius of it.
    const auto covers = [&](std::uint32_t p) {
      const Place d = points_[points_.near(p).back()] - points_[p];
      return dot(d, d) >= 4 * t.squared_radius;
    };
    if (covers(a) || covers(b)) return false;
    bool more = false;
    const Place centre = t.ball.centre();
    for (const std::uint32_t p : points_.index().nearest(centre, 4)) {
      const Place d = points_[p] - centre;
      if (dot(d, d) < t.squared_radius * (1 - 1e-6) && p != a && p != b && p != t.apex &&
          std::none_of(local_.begin(), local_.end(),
                       [&](const Near& q) { return q.second == p; })) {
        local_.push_back({0, p});
        more = true;
      }
    }
    return more;
  }

  /// Puts the best candidate of an edge of the front into the queue.
  void consider(const AdvancingFront& front, HalfEdge h) {
    const std::uint32_t a = front.origin(h).index(), b = front.destination(h).index();
    const Place n = points_.normal_of(front, h);
    const double most = growth * growth * squared_radius_[left(h).index()];
    const auto best = smallest(a, b, most, [&](std::uint32_t c, const EmptyBall& ball) {
      return dot(ball.normal(), n) > FrontPoints::folded &&
             points_.looks_right(a, b, c, ball.normal()) && front.fit(h, Point(c));
    });
    if (!best) return;
    const double flat = dot(best->ball.normal(), n);
    const double key = flat > flat_enough ? 1 / best->squared_radius : flat - 2;
    queue_.push({key, h, Point(best->apex), best->squared_radius});
  }

  void find_seeds() {
    for (std::uint32_t p = 0; p < points_.size() && points_.size() > 2; ++p) {
      const std::uint32_t q = points_.near(p)[0];
      const double most = std::numeric_limits<double>::infinity();
      const auto best = smallest(p, q, most, [](std::uint32_t, const EmptyBall&) { return true; });
      if (!best) continue;
      Point a(p), b(q);
      if (points_.looks_right(p, q, best->apex, best->ball.normal())) std::swap(a, b);
      seeds_.push_back({best->squared_radius, {a, b, Point(best->apex)}});
    }
    std::sort(seeds_.begin(), seeds_.end(), [](const Seed& x, const Seed& y) {
      return x.squared_radius != y.squared_radius ? x.squared_radius < y.squared_radius
                                                  : x.corners < y.corners;
    });
  }

  FrontPoints& points_;
  std::size_t at_seed_ = 0;
  std::vector<Seed> seeds_;
  std::priority_queue<Candidate> queue_;
  std::vector<double> squared_radius_;  // by face
  double radius_of_next_ = 0;
  std::vector<Near> local_;
  std::vector<Trial> trials_;
};

}  // namespace clers::internal

#endif

// Half-edge collapses by quadrics.
#include "codec/cli/coarsen.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "topology/modeling/dynamic_adaptation.h"
#include "topology/stellar.h"

namespace clers::cli {
namespace {

/// A sum of squared distances from planes, weighted by areas.
class Quadric {
 public:
  Quadric() = default;
  /// Of the plane through p with a normal of length 1.
  Quadric(const Vec3& normal, const Vec3& p, double area) : area_(area) {
    const double d = -dot(normal, p);
    const std::array<double, 4> n{normal.x, normal.y, normal.z, d};
    std::size_t k = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i; j < 4; ++j) m_[k++] = area * n[i] * n[j];
  }
  Quadric& operator+=(const Quadric& o) {
    for (std::size_t i = 0; i < m_.size(); ++i) m_[i] += o.m_[i];
    area_ += o.area_;
    return *this;
  }
  double at(const Vec3& p) const {
    const auto& m = m_;
    return std::max(0., p.x * (m[0] * p.x + 2 * (m[1] * p.y + m[2] * p.z + m[3])) +
                            p.y * (m[4] * p.y + 2 * (m[5] * p.z + m[6])) +
                            p.z * (m[7] * p.z + 2 * m[8]) + m[9]);
  }
  double area() const { return area_; }

 private:
  std::array<double, 10> m_{};
  double area_ = 0;
};

class Coarsening {
 public:
  Coarsening(Surface& surface, const Shape& shape)
      : surface_(surface),
        shape_(shape),
        quadrics_(surface.vertex_limit()),
        cost_(surface.vertex_limit()) {
    for (const Vertex v : surface.vertices()) origin_ = at(v);
    for (const Face f : surface.faces()) {
      const auto [a, b, c] = corners(f);
      const Vec3 across = cross(at(b) - at(a), at(c) - at(a));
      const Vec3 normal = unit(across);
      const Quadric plane(normal, at(a) - origin_, length(across) / 2);
      for (const Vertex v : {a, b, c}) quadrics_[v.index()] += plane;
      for (const HalfEdge h : surface.star(f)) {
        if (!surface.is_boundary(h)) continue;
        // The rim keeps its shape by a wall that stands on it.
        const Vec3 along = at(surface.dest(h)) - at(surface.org(h));
        const Quadric wall(unit(cross(along, normal)), at(surface.org(h)) - origin_,
                           squared(along));
        quadrics_[surface.org(h).index()] += wall;
        quadrics_[surface.dest(h).index()] += wall;
      }
    }
    for (const Vertex v : surface.vertices()) put(v);
  }

  /// Collapses one edge; false if none can be.
  bool step() {
    internal::Waiting::Entry next;
    while (waiting_.take(next)) {
      const Vertex u(next.id);
      if (!surface_.is_live(u)) continue;
      const auto best = cheapest_allowed(u);
      if (!best) continue;
      if (best->first > cost_[u.index()]) {
        put(u, best->first);
        continue;
      }
      const Vertex w = surface_.dest(best->second);
      quadrics_[w.index()] += quadrics_[u.index()];
      (void)collapse(surface_, best->second);
      put(w);
      for (const Vertex v : surface_.adjacent_vertices(w)) put(v);
      return true;
    }
    return false;
  }

 private:
  using Candidate = std::pair<double, HalfEdge>;

  const Vec3& at(Vertex v) const { return shape_.at(v).at; }
  std::array<Vertex, 3> corners(Face f) const {
    return {surface_.org(half_edge(f, 0)), surface_.org(half_edge(f, 1)),
            surface_.org(half_edge(f, 2))};
  }

  void put(Vertex v, double cost) {
    cost_[v.index()] = cost;
    waiting_.put(v.index(), -cost);
  }
  void put(Vertex v) {
    std::optional<double> least;
    for (const HalfEdge h : surface_.fan(v))
      if (may_move_along(h)) least = std::min(least.value_or(cost(h)), cost(h));
    if (least) put(v, *least);
  }

  /// A vertex of the rim stays on it.
  bool may_move_along(HalfEdge h) const {
    return surface_.is_boundary(h) || !surface_.is_boundary(surface_.org(h));
  }
  /// Of moving the origin to the destination: how far from its planes that is, and, where planes
  /// say little, how far.
  double cost(HalfEdge h) const {
    const Vertex u = surface_.org(h), w = surface_.dest(h);
    const Vec3 p = at(w) - origin_;
    const Quadric &of_u = quadrics_[u.index()], &of_w = quadrics_[w.index()];
    constexpr double share = 1e-3;
    return of_u.at(p) + of_w.at(p) + share * squared(at(u) - at(w)) * (of_u.area() + of_w.area());
  }

  std::optional<Candidate> cheapest_allowed(Vertex u) {
    candidates_.clear();
    for (const HalfEdge h : surface_.fan(u))
      if (may_move_along(h)) candidates_.emplace_back(cost(h), h);
    std::sort(candidates_.begin(), candidates_.end());
    for (const Candidate& c : candidates_)
      if (keeps_shapes(c.second) && !refuse_collapse(surface_, c.second)) return c;
    return std::nullopt;
  }
  /// Does no face turn over, or against the shape at a corner, or become a sliver that none was?
  bool keeps_shapes(HalfEdge h) const {
    const Vertex u = surface_.org(h), w = surface_.dest(h);
    double worst = good;
    for (const HalfEdge side : surface_.fan(u))
      worst =
          std::min(worst, quality(at(u), at(surface_.dest(side)), at(surface_.dest(lnext(side)))));
    for (const HalfEdge side : surface_.fan(u)) {
      const Vertex b = surface_.dest(side), c = surface_.dest(lnext(side));
      if (b == w || c == w) continue;
      const Vec3 edge = at(c) - at(b);
      const Vec3 before = cross(at(b) - at(u), edge), after = cross(at(b) - at(w), edge);
      const double size = length(after);
      if (!(dot(before, after) > 0.2 * length(before) * size) && length(before) > 0) return false;
      if (quality(at(w), at(b), at(c)) < worst) return false;
      for (const Vertex v : {w, b, c}) {
        const Vec3& normal = shape_.at(v).normal;
        if (squared(normal) > 0 && !(dot(after, normal) > 0.1 * size)) return false;
      }
    }
    return true;
  }

  /// Of a triangle as good as a base needs.
  static constexpr double good = 0.4;
  /// 1 of an equilateral triangle, 0 of one without area.
  static double quality(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double sides = squared(b - a) + squared(c - b) + squared(a - c);
    return sides > 0 ? 2 * std::sqrt(3.) * length(cross(b - a, c - a)) / sides : 0;
  }

  Surface& surface_;
  const Shape& shape_;
  Vec3 origin_;  // near all planes
  std::vector<Quadric> quadrics_;
  std::vector<double> cost_;   // by which a vertex waits
  internal::Waiting waiting_;  // vertices
  std::vector<Candidate> candidates_;
};

}  // namespace

void coarsen(Surface& surface, const Shape& shape, std::int64_t faces,
             const std::function<void(double done)>& progress) {
  const std::int64_t before = surface.characteristic().f;
  if (before <= faces) return;
  Coarsening coarsening(surface, shape);
  for (std::uint32_t i = 0; surface.characteristic().f > faces && coarsening.step(); ++i)
    if (i % 4096 == 0 && progress)
      progress(static_cast<double>(before - surface.characteristic().f) /
               static_cast<double>(before - faces));
}

}  // namespace clers::cli

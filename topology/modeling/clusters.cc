// Algorithm 5: quadrics, independent vertices, and the roundest triangles for a hole.
//
// M. Garland, P. Heckbert: Surface simplification using quadric error metrics (1997). L. Velho:
// Mesh simplification using four-face clusters (2001).
#include "topology/modeling/clusters.h"

#include <algorithm>
#include <cmath>

#include "topology/modeling/placement.h"

namespace CLERS_VISIBLE clers {

using internal::Squares;
using internal::Vector3;

namespace {

/// The squares of the distances from planes, each weighted by an area: x'Ax - 2bx + c.
struct Quadric {
  Squares a;
  Vector3 b;
  double c = 0, weight = 0;

  /// Through p, with this normal, which is as long as the weight is large.
  void add(const Vector3& p, const Vector3& normal) {
    const double length = std::sqrt(squared(normal));
    if (!(length > 0)) return;
    const double d = dot(normal, p) / length;
    a.add(normal, 1 / length);
    b = b + d * normal;
    c += d * d * length;
    weight += length;
  }
  Quadric& operator+=(const Quadric& o) {
    a += o.a, b = b + o.b, c += o.c, weight += o.weight;
    return *this;
  }
  double at(const Vector3& x) const { return std::fmax(dot(x, a.times(x)) - 2 * dot(b, x) + c, 0); }
};

/// How round a triangle is: 1 equilateral, 0 without area.
double roundness(const Vector3& a, const Vector3& b, const Vector3& c) {
  const double squares = squared(b - a) + squared(c - b) + squared(a - c);
  return squares > 0 ? 2 * std::sqrt(3 * squared(cross(b - a, c - a))) / squares : 0;
}

}  // namespace

class ClusterSimplification::State {
 public:
  State(const Surface& surface, std::span<const Position3> positions, const Creases& creases,
        const ClusterOptions& options)
      : surface_(surface),
        creases_(creases),
        options_(options),
        at_(positions.begin(), positions.begin() + surface.vertex_limit()),
        quadrics_(surface.vertex_limit()),
        marked_(surface.vertex_limit()) {
    for (const Face f : surface.faces()) {
      const Vector3 n = normal(half_edge(f, 0));
      for (const HalfEdge h : surface.star(f)) {
        quadrics_[surface.org(h).index()].add(at(surface.org(h)), n);
        if (!surface.is_boundary(h)) continue;
        // A wall along the boundary, as large as the face.
        const Vector3 along = at(surface.dest(h)) - at(surface.org(h));
        if (const double length = squared(along); length > 0)
          for (const Vertex v : {surface.org(h), surface.dest(h)})
            quadrics_[v.index()].add(at(v), (1 / std::sqrt(length)) * cross(along, n));
      }
    }
    begin_step();
  }

  std::optional<Removal> next() {
    while (surface_.characteristic().f > options_.faces) {
      if (queue_.empty()) {
        if (gone_ == 0 && all_) {
          result_.ended = too_far_ ? SimplifyEnd::error : SimplifyEnd::smallest;
          return std::nullopt;
        }
        all_ = gone_ == 0;
        begin_step();
        continue;
      }
      std::pop_heap(queue_.begin(), queue_.end());
      const Entry entry = queue_.back();
      queue_.pop_back();
      if (marked_[entry.vertex.index()] == step_) continue;
      std::optional<Removal> r = plan(entry.vertex);
      if (!r) continue;
      // What the new edges cost shows only now.
      const double cost = std::max(entry.cost, cost_);
      const double weight = quadrics_[entry.vertex.index()].weight;
      r->error = weight > 0 ? std::sqrt(cost / weight) : 0;
      if (r->error > options_.error) {
        too_far_ = true;
        continue;
      }
      if (cost <= entry.cost || queue_.empty() || cost <= queue_.front().cost) return r;
      queue_.push_back({cost, entry.vertex});
      std::push_heap(queue_.begin(), queue_.end());
    }
    result_.ended = SimplifyEnd::faces;
    return std::nullopt;
  }

  /// Its quadric goes to the neighbour on which it is least.
  void removed(const Removal& r) {
    for (const Vertex u : rim_) marked_[u.index()] = step_;
    quadrics_[nearest(r.vertex, rim_).index()] += quadrics_[r.vertex.index()];
    result_.error = std::max(result_.error, r.error);
    ++result_.contracted, ++gone_;
  }

  const SimplifyResult& result() const { return result_; }
  std::uint32_t steps() const { return step_; }

 private:
  struct Entry {
    double cost;
    Vertex vertex;
    bool operator<(const Entry& o) const {  // the least last
      return cost != o.cost ? cost > o.cost : vertex > o.vertex;
    }
  };

  const Vector3& at(Vertex v) const { return at_[v.index()]; }
  Vector3 normal(HalfEdge h) const {
    const Vector3 &a = at(surface_.org(h)), &b = at(surface_.dest(h));
    return cross(b - a, at(surface_.org(lprev(h))) - a);
  }
  template <class Vertices>
  Vertex nearest(Vertex v, const Vertices& vertices) const {
    Vertex best;
    double least = 0;
    for (const Vertex u : vertices)
      if (const double e = quadrics_[v.index()].at(at(u)); !best || e < least) best = u, least = e;
    return best;
  }

  /// V^j: the half of the least errors, or all that may go if that was for nothing.
  void begin_step() {
    ++step_;
    gone_ = 0;
    queue_.clear();
    too_far_ = false;
    for (const Vertex v : surface_.vertices()) {
      if (refuse_remove(surface_, v, surface_.is_boundary(v) ? 3 : smallest(v))) continue;
      const Quadric& q = quadrics_[v.index()];
      const Vertex u = nearest(v, surface_.adjacent_vertices(v));
      const double cost = q.at(at(u));
      if (!std::isfinite(cost)) continue;
      if (!(cost > options_.error * options_.error * q.weight))
        queue_.push_back({cost, v});
      else
        too_far_ = true;
    }
    if (!all_) {
      const auto middle = queue_.begin() + static_cast<std::ptrdiff_t>(queue_.size() / 2);
      std::nth_element(queue_.begin(), middle, queue_.end(),
                       [](const Entry& a, const Entry& b) { return b < a; });
      queue_.erase(middle, queue_.end());
    }
    std::make_heap(queue_.begin(), queue_.end());
  }
  std::uint32_t smallest(Vertex v) const { return surface_.degree(v) == 3 ? 3 : 4; }

  /// The neighbours of v in rim_, without those whose edges were flipped; ears are cut off until a
  /// weld leaves one triangle or two.
  std::optional<Removal> plan(Vertex v) {
    const bool boundary = surface_.is_boundary(v);
    Removal r;
    r.vertex = v;
    r.degree = boundary ? 3 : smallest(v);
    rim_.clear();
    up_ = Vector3();
    for (const HalfEdge h : surface_.star(v)) {
      if (!surface_.is_boundary(h) && creases_.is_sharp(surface_, h)) return std::nullopt;
      rim_.push_back(surface_.other_end(h, v));
    }
    for (const HalfEdge h : surface_.fan(v)) up_ = up_ + normal(h);
    for (std::size_t i = 0; i < rim_.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (rim_[i] == rim_[k]) return std::nullopt;

    rest_ = rim_;
    cost_ = 0;
    while (rest_.size() > r.degree) {
      std::size_t best = rest_.size();
      double most = 0;
      for (std::size_t i = boundary ? 1 : 0; i + (boundary ? 1 : 0) < rest_.size(); ++i) {
        const Vertex a = around(i, -1), b = rest_[i], c = around(i, 1);
        const double round =
            std::min(worth(a, b, c), roundness(at(a), at(c), at(v))) * nearness(v, a, c);
        if (round > most && !joined(a, c)) best = i, most = round;
      }
      if (best == rest_.size()) return std::nullopt;
      r.ears.push_back(rest_[best]);
      cost_ = std::max(cost_, off(v, around(best, -1), around(best, 1)));
      rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(best));
    }
    if (r.degree == 3) {
      if (!(worth(rest_[0], rest_[1], rest_[2]) > 0)) return std::nullopt;
      if (boundary && joined(rest_[0], rest_[2])) return std::nullopt;
      // Nothing would be left of a surface that is one more triangle.
      if (!boundary && other_side(rest_)) return std::nullopt;
      return r;
    }
    double most = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const Vertex a = rest_[i], b = rest_[i + 1], c = rest_[i + 2], d = rest_[(i + 3) % 4];
      const double round = std::min(worth(a, b, c), worth(c, d, a)) * nearness(v, a, c);
      if (round > most && !joined(a, c)) r.diagonal = {a, c}, most = round;
    }
    if (!(most > 0)) return std::nullopt;
    cost_ = std::max(cost_, off(v, r.diagonal[0], r.diagonal[1]));
    return r;
  }
  /// What the vertex's quadric says of the middle of a new edge.
  double off(Vertex v, Vertex a, Vertex c) const {
    return quadrics_[v.index()].at(0.5 * (at(a) + at(c)));
  }
  /// 1 for an edge on the planes, a half for one that is off by a seventeenth of its length: so
  /// that no round triangle cuts a corner off.
  double nearness(Vertex v, Vertex a, Vertex c) const {
    const double scale = quadrics_[v.index()].weight * squared(at(a) - at(c));
    return scale > 0 ? 1 / (1 + 300 * off(v, a, c) / scale) : 1;
  }
  Vertex around(std::size_t i, int by) const {
    return rest_[(i + rest_.size() + static_cast<std::size_t>(by)) % rest_.size()];
  }
  bool joined(Vertex a, Vertex b) const {
    for (const Vertex u : surface_.adjacent_vertices(a))
      if (u == b) return true;
    return false;
  }
  /// Is there a triangle on these three already, not at the vertex that goes?
  bool other_side(const std::vector<Vertex>& rim) const {
    for (const HalfEdge h : surface_.fan(rim[0])) {
      const Vertex p = surface_.dest(h), q = surface_.org(lprev(h));
      if ((p == rim[1] && q == rim[2]) || (p == rim[2] && q == rim[1])) return true;
    }
    return false;
  }
  /// How round a triangle of the hole is; 0 if it would be turned away.
  double worth(Vertex a, Vertex b, Vertex c) const {
    const Vector3 n = cross(at(b) - at(a), at(c) - at(a));
    const double d = dot(n, up_);
    if (!(d > 0) || !(d * d > 0.04 * squared(n) * squared(up_))) return 0;
    return roundness(at(a), at(b), at(c));
  }

  const Surface& surface_;
  const Creases& creases_;
  ClusterOptions options_;
  std::vector<Vector3> at_;
  std::vector<Quadric> quadrics_;
  std::vector<std::uint32_t> marked_;  // the last step in which a neighbour went
  std::vector<Entry> queue_;
  std::vector<Vertex> rim_, rest_;
  Vector3 up_;
  double cost_ = 0;  // of what plan() makes
  std::uint32_t step_ = 0;
  std::uint64_t gone_ = 0;  // in this step
  bool all_ = false, too_far_ = false;
  SimplifyResult result_;
};

std::optional<SimplifyFault> ClusterSimplification::refuse(const Surface& surface,
                                                           std::span<const Position3> positions,
                                                           const ClusterOptions& options) {
  return Simplification::refuse(surface, positions,
                                {.faces = options.faces, .error = options.error});
}

ClusterSimplification::ClusterSimplification(const Surface& surface,
                                             std::span<const Position3> positions,
                                             const Creases& creases, const ClusterOptions& options)
    : state_(std::make_unique<State>(surface, positions, creases, options)) {}
ClusterSimplification::ClusterSimplification(ClusterSimplification&&) noexcept = default;
ClusterSimplification& ClusterSimplification::operator=(ClusterSimplification&&) noexcept = default;
ClusterSimplification::~ClusterSimplification() = default;

std::optional<Removal> ClusterSimplification::next() {
  return state_->next();
}
void ClusterSimplification::removed(const Removal& r) {
  state_->removed(r);
}
const SimplifyResult& ClusterSimplification::result() const {
  return state_->result();
}
std::uint32_t ClusterSimplification::steps() const {
  return state_->steps();
}

}  // namespace clers

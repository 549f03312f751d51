// Which edge goes next, and where the vertex that stays is put.
#include "topology/modeling/simplify.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "topology/modeling/placement.h"

namespace CLERS_VISIBLE clers {

using internal::StarSums;
using internal::Vector3;

/// Edges wait with the end of the lower id, each vertex with the cheapest of its own. What changes
/// around a vertex is looked at when its turn comes, not before: costs mostly rise.
class Simplification::State {
 public:
  State(const Surface& surface, std::vector<Position3>& positions, const Creases& creases,
        const SimplifyOptions& options)
      : surface_(surface), positions_(positions), creases_(creases), options_(options) {
    const std::size_t n = surface.vertex_limit();
    at_.resize(n);
    best_.resize(n);
    stars_.resize(n);
    off_.resize(n);
    evaluated_.resize(n);
    touched_.resize(n);
    star_made_.resize(n);
    turn_.resize(n);
    move_to_origin();
    heap_.reserve(static_cast<std::size_t>(surface.characteristic().v));
    for (const Vertex v : surface.vertices()) {
      evaluate(v);
      if (best_[v.index()].with) heap_.push_back({best_[v.index()].cost, v.index(), 0});
    }
    std::make_heap(heap_.begin(), heap_.end());
  }

  std::optional<Contraction> next() {
    while (surface_.characteristic().f > options_.faces) {
      if (heap_.empty() && !look_again()) {
        result_.ended = too_far_ ? SimplifyEnd::error : SimplifyEnd::smallest;
        return std::nullopt;
      }
      std::pop_heap(heap_.begin(), heap_.end());
      const Entry entry = heap_.back();
      heap_.pop_back();
      const Vertex v(entry.vertex);
      if (!surface_.is_live(v) || turn_[v.index()] != entry.turn) continue;
      if (stale(v)) {
        evaluate(v);
        const Best& b = best_[v.index()];
        if (!b.with) continue;
        if (!heap_.empty() && b.cost > heap_.front().cost) {
          put(v);
          continue;
        }
      }
      return contraction(v, best_[v.index()]);
    }
    result_.ended = SimplifyEnd::faces;
    return std::nullopt;
  }

  void contracted(const Contraction& c) {
    const std::uint32_t kept = c.kept.index();
    if (positions_[kept] != c.place) {
      positions_[kept] = c.place;
      at_[kept] = local(c.place);
    }
    off_[kept] = c.error * scale_;
    result_.error = std::max(result_.error, c.error);
    ++result_.contracted;
    touched_[kept] = ++now_;
    for (const Vertex u : surface_.adjacent_vertices(c.kept)) touched_[u.index()] = now_;
    evaluate(c.kept);
    ++turn_[kept];  // what it waited with before counts no more
    if (best_[kept].with) put(c.kept);
  }

  const SimplifyResult& result() const { return result_; }

 private:
  struct Best {
    Vertex with;
    double cost = 0, off = 0;
    Vector3 place;
  };
  struct Entry {
    double cost;
    std::uint32_t vertex, turn;
    bool operator<(const Entry& o) const {
      return cost != o.cost ? cost > o.cost : vertex > o.vertex;
    }
  };

  /// Near the origin and of size 1, so that sixth powers of lengths are numbers.
  void move_to_origin() {
    constexpr double far = std::numeric_limits<double>::infinity();
    Vector3 low{far, far, far}, high{-far, -far, -far};
    for (const Vertex v : surface_.vertices())
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], positions_[v.index()][i]);
        high[i] = std::max(high[i], positions_[v.index()][i]);
      }
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i)
      if (high[i] >= low[i]) {
        centre_[i] = low[i] / 2 + high[i] / 2;
        size = std::max(size, high[i] - low[i]);
      }
    int exponent = 0;
    if (size > 0) (void)std::frexp(size, &exponent);
    scale_ = std::ldexp(1, -std::max(exponent, -1000));
    for (const Vertex v : surface_.vertices()) at_[v.index()] = local(positions_[v.index()]);
  }
  Vector3 local(const Position3& p) const { return scale_ * (Vector3(p) - centre_); }

  const Vector3& at(Vertex v) const { return at_[v.index()]; }
  void put(Vertex v) {
    heap_.push_back({best_[v.index()].cost, v.index(), ++turn_[v.index()]});
    std::push_heap(heap_.begin(), heap_.end());
  }
  bool stale(Vertex v) const {
    const std::uint32_t then = evaluated_[v.index()];
    if (touched_[v.index()] > then) return true;
    for (const Vertex u : surface_.adjacent_vertices(v))
      if (touched_[u.index()] > then) return true;
    return false;
  }
  /// Vertices that had no edge to contract when they were asked may have one now.
  bool look_again() {
    too_far_ = false;
    for (const Vertex v : surface_.vertices()) {
      if (stale(v)) evaluate(v);
      if (best_[v.index()].with)
        put(v);
      else
        too_far_ = too_far_ || best_[v.index()].off > 0;
    }
    return !heap_.empty();
  }

  const StarSums& star(Vertex v) {
    StarSums& sums = stars_[v.index()];
    if (star_made_[v.index()] > touched_[v.index()]) return sums;
    star_made_[v.index()] = now_ + 1;
    sums = StarSums();
    for (const HalfEdge f : surface_.fan(v))
      sums.add_face(at(v), at(surface_.dest(f)), at(surface_.org(lprev(f))), 1);
    for (const Vertex u : surface_.adjacent_vertices(v)) sums.add_neighbour(at(u), 1);
    return sums;
  }

  /// The cheapest edge from v to a vertex of a greater id that may be contracted. Without one,
  /// `off` says whether one was too far.
  void evaluate(Vertex v) {
    candidates_.clear();
    const SharpEdges sharp = sharp_edges(surface_, creases_, v);
    for (const HalfEdge h : surface_.star(v)) {
      Best b;
      b.with = surface_.other_end(h, v);
      if (b.with > v && place(h, v, sharp, b)) candidates_.emplace_back(b, h);
    }
    Best best;
    bool too_far = false;
    for (; !candidates_.empty(); candidates_.pop_back()) {
      for (auto& c : candidates_)
        if (cheaper(c.first, candidates_.back().first)) std::swap(c, candidates_.back());
      auto& [b, h] = candidates_.back();
      if (!keeps_sides(h, b) || !link_condition(surface_, h)) continue;
      if (b.off <= options_.error * scale_) {
        best = b;
        break;
      }
      too_far = true;
    }
    if (!best.with) best.off = too_far ? 1 : 0;
    best_[v.index()] = best;
    evaluated_[v.index()] = now_;
  }
  static bool cheaper(const Best& a, const Best& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.with < b.with;
  }

  /// Where the ends of h, v and another, go together, and what that costs. Creases stay curves: a
  /// vertex of one may only go along it, and a smooth one only to it.
  bool place(HalfEdge h, Vertex v, const SharpEdges& at_v, Best& b) {
    const Vertex w = b.with;
    const SharpEdges at_w = sharp_edges(surface_, creases_, w);
    const bool along = creases_.is_sharp(surface_, h);
    if (at_v.count != 0 && at_w.count != 0) {
      if (!along || (!at_v.curve() && !at_w.curve())) return false;
      for (const HalfEdge side :
           surface_.star(h))  // nothing would be left of a curve around a face
        if (creases_.is_sharp(surface_, lnext(side)) && creases_.is_sharp(surface_, lprev(side)))
          return false;
    }
    StarSums both = star(v);
    both += star(w);
    both.add_neighbour(at(v), -1);
    both.add_neighbour(at(w), -1);
    for (const HalfEdge side : surface_.star(h)) {  // counted twice
      const Vector3& c = at(surface_.org(lprev(side)));
      both.add_face(at(surface_.org(side)), at(surface_.dest(side)), c, -1);
      both.add_neighbour(c, -1);
    }
    if (at_v.curve() || at_w.curve()) {
      const double length = std::sqrt(squared(at(v) - at(w)));
      for (const auto& [x, sharp] : {std::pair(v, &at_v), std::pair(w, &at_w)})
        if (sharp->curve())
          for (const Vertex end : sharp->ends)
            if (x == v || end != v) both.add_curve(at(x), at(end), length);
    }
    const double s = both.weight(options_.shape);
    const bool v_stays = fixed(at_v, along), w_stays = fixed(at_w, along);
    b.place = v_stays ? at(v) : w_stays ? at(w) : both.best(s, 0.5 * (at(v) + at(w)));
    b.cost = both.cost(b.place, s);
    return std::isfinite(b.cost);
  }
  /// Does an end stay where it is, if the edge is sharp or not?
  static bool fixed(const SharpEdges& sharp, bool along) {
    return sharp.count != 0 && !(along && sharp.curve());
  }

  /// Does no face that stays turn over? Finds how far the surface moves.
  bool keeps_sides(HalfEdge h, Best& b) const {
    const Vertex u = surface_.org(h), w = surface_.dest(h);
    double farthest = 0;  // squared
    for (const auto& [x, y] : {std::pair(u, w), std::pair(w, u)})
      for (const HalfEdge f : surface_.fan(x)) {
        const Vertex p = surface_.dest(f), r = surface_.org(lprev(f));
        const Vector3 before = cross(at(p) - at(x), at(r) - at(x));
        const double size = squared(before);
        if (size > 0) {
          const double d = dot(before, b.place - at(x));
          farthest = std::max(farthest, d * d / size);
        }
        if (p == y || r == y) continue;
        const Vector3 after = cross(at(p) - b.place, at(r) - b.place);
        if (size > 0 && !(dot(before, after) > 0.2 * std::sqrt(size * squared(after))))
          return false;
      }
    for (const Vertex x : {u, w}) farthest = std::max(farthest, off_curve(x, b.place));
    b.off = std::max(off_[u.index()], off_[w.index()]) + std::sqrt(farthest);
    return true;
  }
  /// The square of the distance of a place from the lines of a curve through x.
  double off_curve(Vertex x, const Vector3& place) const {
    const SharpEdges sharp = sharp_edges(surface_, creases_, x);
    double farthest = 0;
    if (sharp.curve())
      for (const Vertex end : sharp.ends) {
        const Vector3 along = at(end) - at(x);
        if (const double size = squared(along); size > 0)
          farthest = std::max(farthest, squared(cross(along, place - at(x))) / size);
      }
    return farthest;
  }

  Contraction contraction(Vertex v, const Best& b) const {
    Contraction c;
    for (const HalfEdge h : surface_.star(v))
      if (surface_.other_end(h, v) == b.with) c.edge = h;
    // The vertex on the boundary keeps its id, else the one that stays where it is.
    const bool from = surface_.is_boundary(surface_.org(c.edge)),
               to = surface_.is_boundary(surface_.dest(c.edge));
    if (const HalfEdge other = surface_.sym(c.edge);
        other && (from != to ? from : b.place == at(surface_.org(c.edge))))
      c.edge = other;
    c.kept = surface_.dest(c.edge), c.gone = surface_.org(c.edge);
    const Vector3 edge = at(c.gone) - at(c.kept);
    const double length = squared(edge);
    if (length > 0) c.weight = std::clamp(dot(b.place - at(c.kept), edge) / length, 0., 1.);
    c.place = b.place == at(c.kept)   ? positions_[c.kept.index()]
              : b.place == at(c.gone) ? positions_[c.gone.index()]
                                      : Position3((1 / scale_) * b.place + centre_);
    c.error = b.off / scale_;
    return c;
  }

  const Surface& surface_;
  std::vector<Position3>& positions_;
  const Creases& creases_;
  SimplifyOptions options_;
  Vector3 centre_;
  double scale_ = 1;
  std::vector<Vector3> at_;
  std::vector<Best> best_;
  std::vector<StarSums> stars_;
  std::vector<double> off_;  // how far the surface has moved at a vertex
  std::vector<std::uint32_t> evaluated_, touched_, star_made_, turn_;
  std::vector<std::pair<Best, HalfEdge>> candidates_;
  std::uint32_t now_ = 0;
  std::vector<Entry> heap_;
  bool too_far_ = false;
  SimplifyResult result_;
};

std::optional<SimplifyFault> Simplification::refuse(const Surface& surface,
                                                    std::span<const Position3> positions,
                                                    const SimplifyOptions& options) {
  if (options.faces < 0 || !(options.error >= 0) || !(options.shape >= 0) ||
      !std::isfinite(options.shape))
    return SimplifyFault{SimplifyRule::option};
  if (positions.size() < surface.vertex_limit()) return SimplifyFault{SimplifyRule::position_count};
  for (const Vertex v : surface.vertices())
    for (const double x : positions[v.index()])
      if (!(std::fabs(x) < 1e100)) return SimplifyFault{SimplifyRule::position_in_range, v.index()};
  return std::nullopt;
}

Simplification::Simplification(const Surface& surface, std::vector<Position3>& positions,
                               const Creases& creases, const SimplifyOptions& options)
    : state_(std::make_unique<State>(surface, positions, creases, options)) {}
Simplification::Simplification(Simplification&&) noexcept = default;
Simplification& Simplification::operator=(Simplification&&) noexcept = default;
Simplification::~Simplification() = default;

std::optional<Contraction> Simplification::next() {
  return state_->next();
}
void Simplification::contracted(const Contraction& c) {
  state_->contracted(c);
}
const SimplifyResult& Simplification::result() const {
  return state_->result();
}

}  // namespace clers

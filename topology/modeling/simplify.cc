// Which edge goes next, and where the vertex that stays is put.
#include "topology/modeling/simplify.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <utility>

#include "topology/modeling/placement.h"

namespace CLERS_VISIBLE clers {

using internal::EdgeSums;
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
    of_.resize(n);
    move_to_origin();
    heap_.reserve(static_cast<std::size_t>(surface.characteristic().v));
    for (const Vertex v : surface.vertices()) {
      evaluate(v);
      if (of_[v.index()].best.with) heap_.push_back({rank(of_[v.index()].best.cost), v.index(), 0});
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
      if (!surface_.is_live(v) || of_[v.index()].turn != entry.turn) continue;
      Best& best = of_[v.index()].best;
      if (changed(v)) {
        evaluate(v);
        if (put_back(v)) continue;
      }
      if (!best.checked && !may_go(edge(v, best.with), best)) {
        evaluate_all(v);
        if (put_back(v)) continue;
      }
      return contraction(v, best);
    }
    result_.ended = SimplifyEnd::faces;
    return std::nullopt;
  }

  void contracted(const Contraction& c) {
    const std::uint32_t kept = c.kept.index();
    if (positions_[kept] != c.place) {
      positions_[kept] = c.place;
      of_[kept].at = local(c.place);
    }
    of_[kept].off = c.error * scale_;
    result_.error = std::max(result_.error, c.error);
    ++result_.contracted;
    of_[kept].touched = ++now_;
    for (const Vertex u : surface_.adjacent_vertices(c.kept)) of_[u.index()].touched = now_;
    evaluate(c.kept);
    ++of_[kept].turn;  // what it waited with before counts no more
    if (of_[kept].best.with) put(c.kept);
  }

  const SimplifyResult& result() const { return result_; }

 private:
  struct Best {
    Vertex with;
    bool checked = false;
    double cost = 0, off = 0;
    Vector3 place;
  };
  struct Entry {
    std::uint32_t cost, vertex, turn;
    bool operator<(const Entry& o) const {
      return cost != o.cost ? cost > o.cost : vertex > o.vertex;
    }
  };
  /// Costs that differ by less than a fifth are one: of these the lowest ids go first, which are
  /// near each other in memory. That halves the time, and the error does not notice.
  static std::uint32_t rank(double cost) {
    return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(cost) >> 50);
  }

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
    for (const Vertex v : surface_.vertices()) of_[v.index()].at = local(positions_[v.index()]);
  }
  Vector3 local(const Position3& p) const { return scale_ * (Vector3(p) - centre_); }

  const Vector3& at(Vertex v) const { return of_[v.index()].at; }
  void put(Vertex v) {
    heap_.push_back({rank(of_[v.index()].best.cost), v.index(), ++of_[v.index()].turn});
    std::push_heap(heap_.begin(), heap_.end());
  }
  /// Is the cheapest edge not what it was? Another of the vertex may be cheaper now; it waits.
  bool changed(Vertex v) const {
    const std::uint32_t then = of_[v.index()].evaluated;
    return of_[v.index()].touched > then || of_[of_[v.index()].best.with.index()].touched > then;
  }
  /// Has v no edge, or one that others come before?
  bool put_back(Vertex v) {
    const Best& b = of_[v.index()].best;
    if (!b.with) return true;
    if (heap_.empty() || rank(b.cost) <= heap_.front().cost) return false;
    put(v);
    return true;
  }
  HalfEdge edge(Vertex v, Vertex w) const {
    HalfEdge edge;
    for (const HalfEdge h : surface_.star(v))
      if (surface_.other_end(h, v) == w) edge = h;
    return edge;
  }
  bool stale(Vertex v) const {
    const std::uint32_t then = of_[v.index()].evaluated;
    if (of_[v.index()].touched > then) return true;
    for (const Vertex u : surface_.adjacent_vertices(v))
      if (of_[u.index()].touched > then) return true;
    return false;
  }
  /// Vertices that had no edge to contract when they were asked may have one now.
  bool look_again() {
    too_far_ = false;
    for (const Vertex v : surface_.vertices()) {
      if (stale(v)) evaluate(v);
      if (of_[v.index()].best.with)
        put(v);
      else
        too_far_ = too_far_ || of_[v.index()].best.off > 0;
    }
    return !heap_.empty();
  }

  const StarSums& star(Vertex v) {
    StarSums& sums = of_[v.index()].star;
    if (of_[v.index()].star_made > of_[v.index()].touched) return sums;
    of_[v.index()].star_made = now_ + 1;
    sums = StarSums();
    const Vector3& x = at(v);
    for (const HalfEdge f : surface_.fan(v)) {
      const Vector3 p = at(surface_.dest(f)) - x;
      sums.add_face(p, at(surface_.org(lprev(f))) - x);
      sums.add_neighbour(p);
    }
    if (surface_.is_boundary(v))
      for (const HalfEdge h : surface_.star(v))
        if (surface_.dest(h) == v) sums.add_neighbour(at(surface_.org(h)) - x);
    return sums;
  }

  /// The cheapest edge from v to a vertex of a greater id, which mostly may be contracted: whether
  /// it may is asked when its turn comes.
  void evaluate(Vertex v) {
    Best best;
    for_each_edge(v, [&](const Best& b, HalfEdge) {
      if (!best.with || cheaper(b, best)) best = b;
    });
    of_[v.index()].best = best;
    of_[v.index()].evaluated = now_;
  }
  /// The cheapest that may be contracted. Without one, `off` says whether one was too far.
  void evaluate_all(Vertex v) {
    Best best;
    bool too_far = false;
    for_each_edge(v, [&](Best& b, HalfEdge h) {
      if (best.with && cheaper(best, b)) return;
      if (may_go(h, b)) best = b;
      too_far = too_far || b.off > options_.error * scale_;
    });
    if (!best.with) best.off = too_far ? 1 : 0;
    of_[v.index()].best = best;
    of_[v.index()].evaluated = now_;
  }
  template <class Call>
  void for_each_edge(Vertex v, Call call) {
    const SharpEdges sharp = sharp_edges(surface_, creases_, v);
    for (const HalfEdge h : surface_.star(v)) {
      Best b;
      b.with = surface_.other_end(h, v);
      if (b.with > v && place(h, v, sharp, b)) call(b, h);
    }
  }
  bool may_go(HalfEdge h, Best& b) const {
    b.checked =
        keeps_sides(h, b) && link_condition(surface_, h) && b.off <= options_.error * scale_;
    return b.checked;
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
    const Vector3 half = 0.5 * (at(w) - at(v)), middle = 0.5 * (at(v) + at(w));
    const StarSums& first = star(v);
    EdgeSums both(first, star(w), half);
    for (const HalfEdge side : surface_.star(h)) {
      const Vector3& x = at(surface_.org(side));
      const Vector3& c = at(surface_.org(lprev(side)));
      both.remove_face(c - middle, cross(at(surface_.dest(side)) - x, c - x));
    }
    if (at_v.curve() || at_w.curve()) {
      const double length = 2 * std::sqrt(squared(half));
      if (along) both.add_curve(half + half, length, half, 0);
      for (const auto& [x, sharp, sign] : {std::tuple(v, &at_v, 1.), std::tuple(w, &at_w, -1.)})
        if (sharp->curve())
          for (const Vertex end : sharp->ends)
            if (end != v && end != w) both.add_curve(at(end) - at(x), length, half, sign);
    }
    const double s = both.weight(options_.shape);
    const bool v_stays = fixed(at_v, along), w_stays = fixed(at_w, along);
    const Vector3 y = v_stays ? -1 * half : w_stays ? half : both.best(s);
    b.place = v_stays ? at(v) : w_stays ? at(w) : middle + y;
    b.cost = both.cost(y, s);
    // What is forgotten at each step is remembered a little: an edge goes later where the surface
    // has moved already, so that it moves nowhere much farther than elsewhere.
    const double moved = std::max(of_[v.index()].off, of_[w.index()].off);
    b.cost += 0.01 * moved * moved * both.trace();
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
        if (const double d = dot(before, after);
            size > 0 && !(d > 0 && d * d > 0.04 * size * squared(after)))
          return false;
      }
    for (const Vertex x : {u, w}) farthest = std::max(farthest, off_curve(x, b.place));
    b.off = std::max(of_[u.index()].off, of_[w.index()].off) + std::sqrt(farthest);
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
    c.edge = edge(v, b.with);
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
  struct alignas(64) OfVertex {
    Vector3 at;
    double off = 0;  // how far the surface has moved there
    std::uint32_t touched = 0, star_made = 0, evaluated = 0, turn = 0;
    Best best;
    StarSums star;
  };
  std::vector<OfVertex> of_;
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

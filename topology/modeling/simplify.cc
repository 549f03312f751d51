// Which edge goes next, and where the vertex that stays is put.
#include "topology/modeling/simplify.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <utility>

#include "topology/modeling/edge_costs.h"

namespace CLERS_VISIBLE clers {

using internal::Vector3;

/// Edges wait with the end of the lower id, each vertex with the cheapest of its own. What changes
/// around a vertex is looked at when its turn comes, not before: costs mostly rise.
class Simplification::State : internal::EdgeCosts {
 public:
  State(const Surface& surface, std::vector<Position3>& positions, const Creases& creases,
        const SimplifyOptions& options)
      : EdgeCosts(surface, positions, creases, options.shape),
        positions_(positions),
        options_(options) {
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
  struct Entry {
    std::uint32_t cost, vertex, turn;
    bool operator<(const Entry& o) const {
      return cost != o.cost ? cost > o.cost : vertex > o.vertex;
    }
  };
  /// Four ranks to a doubling: of one rank the lowest ids go first, which are near each other in
  /// memory. That takes a third of the time off, and the error does not notice.
  static std::uint32_t rank(double cost) {
    return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(cost) >> 50);
  }

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
        too_far_ = too_far_ || of_[v.index()].best.too_far;
    }
    return !heap_.empty();
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
  /// The cheapest that may be contracted. Without one, `too_far` says whether one was.
  void evaluate_all(Vertex v) {
    Best best;
    bool too_far = false;
    for_each_edge(v, [&](Best& b, HalfEdge h) {
      if (best.with && cheaper(best, b)) return;
      if (may_go(h, b))
        best = b;
      else
        too_far = too_far || b.too_far;
    });
    if (!best.with) best.too_far = too_far;
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
    if (!keeps_sides(h, b) || !link_condition(surface_, h)) return false;
    b.too_far = b.off > options_.error * scale_;
    b.checked = !b.too_far;
    return b.checked;
  }
  static bool cheaper(const Best& a, const Best& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.with < b.with;
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

  std::vector<Position3>& positions_;
  SimplifyOptions options_;
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

// Which vertex goes next, and where the one that stays is put (Lindstrom, Turk 1998, memoryless).
#include "topology/modeling/simplify.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "topology/stellar.h"

namespace CLERS_VISIBLE clers {
namespace {

using V = Position3;

V operator+(const V& a, const V& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
V operator-(const V& a, const V& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
V operator*(double k, const V& a) { return {k * a[0], k * a[1], k * a[2]}; }
double dot(const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
V cross(const V& a, const V& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// x' H x - 2 c x + k.
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0, k = 0;
  V c{};

  void plane(const V& a, double d, double sign) {
    const V s = sign * a;
    xx += s[0] * a[0], xy += s[0] * a[1], xz += s[0] * a[2];
    yy += s[1] * a[1], yz += s[1] * a[2], zz += s[2] * a[2];
    c = c + d * s;
    k += sign * d * d;
  }
  V times(const V& x) const {
    return {xx * x[0] + xy * x[1] + xz * x[2], xy * x[0] + yy * x[1] + yz * x[2],
            xz * x[0] + yz * x[1] + zz * x[2]};
  }
  Quadric& operator+=(const Quadric& o) {
    xx += o.xx, xy += o.xy, xz += o.xz, yy += o.yy, yz += o.yz, zz += o.zz, k += o.k;
    c = c + o.c;
    return *this;
  }
  double trace() const { return xx + yy + zz; }
  double at(const V& x) const { return dot(x, times(x)) - 2 * dot(c, x) + k; }
};

class Simplifier {
 public:
  Simplifier(Surface& surface, std::vector<V>& at, const SimplifyOptions& options)
      : s_(surface), at_(at), options_(options), best_(surface.vertex_limit()),
        evaluated_(surface.vertex_limit()), touched_(surface.vertex_limit()),
        turn_(surface.vertex_limit()), star_made_(surface.vertex_limit()), off_(surface.vertex_limit()), stars_(surface.vertex_limit()) {}

  SimplifyReport run() {
    SimplifyReport report;
    for (const Vertex v : s_.vertices()) {
      evaluate(v);
      if (best_[v.index()].with) heap_.push_back({best_[v.index()].cost, v.index(), 0});
    }
    std::make_heap(heap_.begin(), heap_.end());
    while (!heap_.empty() && s_.characteristic().f > options_.faces) {
      std::pop_heap(heap_.begin(), heap_.end());
      const Entry entry = heap_.back();
      heap_.pop_back();
      const Vertex v(entry.vertex);
      if (!s_.is_live(v) || turn_[v.index()] != entry.turn) continue;
      if (stale(v)) {
        evaluate(v);
        const Best& b = best_[v.index()];
        if (!b.with) continue;
        if (!heap_.empty() && b.cost > heap_.front().cost) {
          put(v);
          continue;
        }
      }
      const Best b = best_[v.index()];
      HalfEdge h = edge(v, b.with);
      const double error = b.off;
      const auto kept = collapse(s_, h);
      if (!kept) continue;
      at_[kept->index()] = b.place;
      off_[kept->index()] = error;
      report.error = std::max(report.error, error);
      ++report.removed;
      ++now_;
      touched_[kept->index()] = now_;
      for (const Vertex u : s_.adjacent_vertices(*kept)) touched_[u.index()] = now_;
      evaluate(*kept);
      if (best_[kept->index()].with) put(*kept);
      const Vertex other = *kept == v ? b.with : v;
      (void)other;
      if (*kept != v) ++turn_[v.index()];
    }
    return report;
  }

 private:
  struct Best {
    Vertex with;
    double cost = 0, off = 0;
    V place{};
  };
  struct Entry {
    double cost;
    std::uint32_t vertex, turn;
    bool operator<(const Entry& o) const {
      return cost != o.cost ? cost > o.cost : vertex > o.vertex;
    }
  };

  const V& at(Vertex v) const { return at_[v.index()]; }
  void put(Vertex v) {
    heap_.push_back({best_[v.index()].cost, v.index(), ++turn_[v.index()]});
    std::push_heap(heap_.begin(), heap_.end());
  }
  HalfEdge edge(Vertex v, Vertex w) const {
    for (const HalfEdge h : s_.star(v))
      if (s_.other_end(h, v) == w) return h;
    return {};
  }
  bool stale(Vertex v) const {
    const std::uint32_t t = evaluated_[v.index()];
    if (touched_[v.index()] > t) return true;
    for (const Vertex u : s_.adjacent_vertices(v))
      if (touched_[u.index()] > t) return true;
    return false;
  }

  /// What the triangles around a vertex want, and its neighbours.
  struct Star {
    Quadric planes;    // squares of volumes over each triangle, six times
    V area{};          // sum of the triangles' area vectors, twice
    double volume = 0; // of the tetrahedra from the origin over them, six times
    V ring{};          // sum of neighbours
    double ring2 = 0, count = 0;
  };
  void add_face(Star& star, const V& p, const V& a, const V& b, double sign) const {
    const V n = cross(a - p, b - p);
    const double d = dot(n, p);
    star.planes.plane(n, d, sign);
    star.area = star.area + sign * n;
    star.volume += sign * d;
  }
  const Star& star(Vertex v) {
    Star& star = stars_[v.index()];
    if (star_made_[v.index()] > touched_[v.index()]) return star;
    star_made_[v.index()] = now_ + 1;
    star = Star();
    for (const HalfEdge f : s_.fan(v))
      add_face(star, at(v), at(s_.dest(f)), at(s_.org(lprev(f))), 1);
    for (const Vertex u : s_.adjacent_vertices(v)) {
      star.ring = star.ring + at(u);
      star.ring2 += dot(at(u), at(u));
      star.count += 1;
    }
    return star;
  }

  /// The cheapest edge from v to a vertex of a greater id that may be collapsed.
  void evaluate(Vertex v) {
    candidates_.clear();
    for (const HalfEdge h : s_.star(v)) {
      Best b;
      b.with = s_.other_end(h, v);
      if (b.with > v && place(h, b)) candidates_.emplace_back(b, h);
    }
    std::sort(candidates_.begin(), candidates_.end(), [](const auto& a, const auto& b) {
      return a.first.cost != b.first.cost ? a.first.cost < b.first.cost : a.first.with < b.first.with;
    });
    Best best;
    for (const auto& [b, h] : candidates_)
      if (legal(h, b)) {
        best = b;
        break;
      }
    best_[v.index()] = best;
    evaluated_[v.index()] = now_;
  }

  /// Where the ends of h go together, and what that costs.
  bool place(HalfEdge h, Best& b) {
    const Vertex u = s_.org(h), w = s_.dest(h);
    Star both = star(u);
    {
      const Star& other = star(w);
      both.planes += other.planes;
      both.area = both.area + other.area;
      both.volume += other.volume;
      both.ring = both.ring + other.ring - at(u) - at(w);
      both.ring2 += other.ring2 - dot(at(u), at(u)) - dot(at(w), at(w));
      both.count += other.count - 2;
    }
    for (const HalfEdge side : s_.star(h)) {  // counted twice
      const V& c = at(s_.org(lprev(side)));
      add_face(both, at(s_.org(side)), at(s_.dest(side)), c, -1);
      both.ring = both.ring - c;
      both.ring2 -= dot(c, c);
      both.count -= 1;
    }
    Quadric& q = both.planes;
    const V& area = both.area;
    const double volume = both.volume, count = both.count;
    const V& ring = both.ring;
    const double ring2 = both.ring2;
    // Boundary edges at u and w: areas that the curve sweeps.
    if (s_.is_boundary(u) || s_.is_boundary(w)) {
      const double k = std::sqrt(dot(at(u) - at(w), at(u) - at(w)));
      for (const Vertex x : {u, w}) {
        if (!s_.is_boundary(x)) continue;
        const HalfEdge out = s_.star_half_edge(x), in = s_.boundary_prev(out);
        for (const HalfEdge e : {in, out}) {
          if (x == w && (s_.org(e) == u || s_.dest(e) == u)) continue;
          const V p = at(s_.org(e)), t = at(s_.dest(e)) - p;
          // |t x (x - p)|^2 as planes with normals e_i x t.
          for (std::size_t i = 0; i < 3; ++i) {
            V axis{};
            axis[i] = k;
            const V n = cross(axis, t);
            q.plane(n, dot(n, p), 1);
          }
        }
      }
    }
    const double s = options_.shape * q.trace() / std::max(count, 1.);
    const double area2 = dot(area, area);
    V x;
    if (area2 > 1e-12 * q.trace()) {
      // On the plane that keeps the volume; there 2 by 2.
      const V x0 = (volume / area2) * area;
      const V n = (1 / std::sqrt(area2)) * area;
      V e{};
      e[std::fabs(n[0]) < 0.6 ? 0 : 1] = 1;
      V b1 = cross(n, e);
      b1 = (1 / std::sqrt(dot(b1, b1))) * b1;
      const V b2 = cross(n, b1);
      const V h1 = q.times(b1), h2 = q.times(b2);
      const double m11 = dot(b1, h1) + s * count, m12 = dot(b1, h2), m22 = dot(b2, h2) + s * count;
      const V r = q.c - q.times(x0) + s * (ring - count * x0);
      const double r1 = dot(b1, r), r2 = dot(b2, r), det = m11 * m22 - m12 * m12;
      if (!(det > 0)) return false;
      x = x0 + ((m22 * r1 - m12 * r2) / det) * b1 + ((m11 * r2 - m12 * r1) / det) * b2;
    } else {
      // No side is outside: the least of the sum alone.
      const double a = q.xx + s * count, d = q.yy + s * count, f = q.zz + s * count;
      const V r = q.c + s * ring;
      const double c00 = d * f - q.yz * q.yz, c01 = q.xz * q.yz - q.xy * f,
                   c02 = q.xy * q.yz - q.xz * d;
      const double det = a * c00 + q.xy * c01 + q.xz * c02;
      if (!(std::fabs(det) > 0)) {
        x = 0.5 * (at(u) + at(w));
      } else {
        const double c11 = a * f - q.xz * q.xz, c12 = q.xy * q.xz - a * q.yz,
                     c22 = a * d - q.xy * q.xy;
        x = {(c00 * r[0] + c01 * r[1] + c02 * r[2]) / det,
             (c01 * r[0] + c11 * r[1] + c12 * r[2]) / det,
             (c02 * r[0] + c12 * r[1] + c22 * r[2]) / det};
      }
    }
    const double error = std::max(q.at(x), 0.);
    b.cost = error + s * (count * dot(x, x) - 2 * dot(ring, x) + ring2);
    // As a distance: the mean square of distances from planes, weighted by squared areas.
    b.off = std::max(off_[u.index()], off_[w.index()]) + std::sqrt(error / std::max(q.trace(), 1e-300));
    b.place = x;
    return b.off <= options_.error && std::isfinite(b.cost);
  }

  /// No face that stays turns over, and the surface stays what it is.
  bool legal(HalfEdge h, const Best& b) const {
    const Vertex u = s_.org(h), w = s_.dest(h);
    for (const Vertex x : {u, w})
      for (const HalfEdge f : s_.fan(x)) {
        const Vertex p = s_.dest(f), r = s_.org(lprev(f)), y = x == u ? w : u;
        if (p == y || r == y) continue;
        const V before = cross(at(p) - at(x), at(r) - at(x)),
                after = cross(at(p) - b.place, at(r) - b.place);
        if (!(dot(before, after) > 0.2 * std::sqrt(dot(before, before) * dot(after, after))))
          return false;
      }
    return link_condition(s_, h);
  }

  Surface& s_;
  std::vector<V>& at_;
  const SimplifyOptions& options_;
  std::vector<Best> best_;
  std::vector<std::uint32_t> evaluated_, touched_, turn_, star_made_;
  std::vector<double> off_;
  std::vector<Star> stars_;
  std::vector<std::pair<Best, HalfEdge>> candidates_;
  std::uint32_t now_ = 0;
  std::vector<Entry> heap_;
};

}  // namespace

SimplifyReport simplify(Surface& surface, std::vector<V>& at, const SimplifyOptions& options) {
  return Simplifier(surface, at, options).run();
}

}  // namespace clers

// What it costs to contract an edge, and what it does to the faces around.
#ifndef CLERS_TOPOLOGY_MODELING_EDGE_COSTS_H
#define CLERS_TOPOLOGY_MODELING_EDGE_COSTS_H

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "topology/modeling/creases.h"
#include "topology/modeling/placement.h"
#include "topology/modeling/simplify.h"
#include "topology/modeling/triangle_distance.h"
#include "topology/surface.h"

namespace clers::internal {

/// Sums by vertex, made again where the surface was touched, and the costs that follow from them.
class EdgeCosts {
 protected:
  EdgeCosts(const Surface& surface, std::span<const Position3> positions, const Creases& creases,
            double shape)
      : surface_(surface), creases_(creases), shape_(shape), of_(surface.vertex_limit()) {
    move_to_origin(positions);
  }

  /// The cheapest edge of a vertex, by its other end.
  struct Best {
    Vertex with;
    bool checked = false, too_far = false;
    double cost = 0, off = 0;
    Vector3 place;
  };
  /// Near the origin and of size 1, so that sixth powers of lengths are numbers.
  void move_to_origin(std::span<const Position3> positions) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Vector3 low{far, far, far}, high{-far, -far, -far};
    for (const Vertex v : surface_.vertices())
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], positions[v.index()][i]);
        high[i] = std::max(high[i], positions[v.index()][i]);
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
    for (const Vertex v : surface_.vertices()) of_[v.index()].at = local(positions[v.index()]);
  }
  Vector3 local(const Position3& p) const { return scale_ * (Vector3(p) - centre_); }

  const Vector3& at(Vertex v) const { return of_[v.index()].at; }
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
    const double s = both.weight(shape_);
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
    // Planes and lines go on for ever, and what stays does not: the ends must be near that, too.
    for (const Vertex x : {u, w})
      farthest = std::max(farthest, off_star(x, u, w, b.place, farthest));
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

  /// The square of the distance of x from the triangles that stay when u and w are put at a place;
  /// not looked at where it is no more than `enough`.
  double off_star(Vertex x, Vertex u, Vertex w, const Vector3& place, double enough) const {
    double nearest = squared(place - at(x));
    for (const auto& [v, other] : {std::pair(u, w), std::pair(w, u)})
      for (const HalfEdge f : surface_.fan(v)) {
        if (nearest <= enough) return enough;
        const Vertex p = surface_.dest(f), r = surface_.org(lprev(f));
        if (p == other || r == other) continue;
        nearest = std::min(nearest, squared_distance(place - at(x), at(p) - at(x), at(r) - at(x)));
      }
    return nearest;
  }

  const Surface& surface_;
  const Creases& creases_;
  double shape_;
  Vector3 centre_;
  double scale_ = 1;
  struct OfVertex {
    Vector3 at;
    double off = 0;  // how far the surface has moved there
    std::uint32_t touched = 0, star_made = 0, evaluated = 0, turn = 0;
    Best best;
    StarSums star;
  };
  std::vector<OfVertex> of_;
  std::uint32_t now_ = 0;
};

}  // namespace clers::internal

#endif

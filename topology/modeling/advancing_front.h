// Surfaces that grow over given points, triangle by triangle (CAGD 2010, §7.1, Algorithm 1).
#ifndef CLERS_TOPOLOGY_MODELING_ADVANCING_FRONT_H
#define CLERS_TOPOLOGY_MODELING_ADVANCING_FRONT_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <clers/topology/export.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// A surface whose boundary is a front that moves over points 0 .. n-1. It is valid at all times,
/// and as triangles over points it has at most two faces at an edge, which agree in orientation.
/// Where the front meets itself a point may have several vertices, each with a fan of its own,
/// until the surface is glued between them; `part_fans` ends what is left of that.
///
/// Costs are in terms of the fans at a point, `max_fans` at most, and of their corners.
class CLERS_VISIBLE AdvancingFront {
 public:
  static constexpr unsigned max_fans = 4;

  /// Memory: 4 bytes a point beside the surface, 12 a face.
  explicit AdvancingFront(std::uint32_t points) : corner_at_(points) {}

  const Surface& surface() const { return surface_; }
  /// Ends the front.
  Surface take() && { return std::move(surface_); }

  bool is_used(Point p) const { return bool(corner_at_[p.index()]); }
  Point origin(HalfEdge h) const { return surface_.point(surface_.org(h)); }
  Point destination(HalfEdge h) const { return origin(lnext(h)); }
  Point apex(HalfEdge h) const { return origin(lprev(h)); }
  /// Is it on the front, where a triangle can be added?
  bool is_candidate(HalfEdge h) const { return surface_.is_live(h) && surface_.is_boundary(h); }

  /// Where a triangle would be glued besides the edge that it is for; null: nowhere.
  ///
  ///             c             new: (b a c) at h, which runs from a to b
  ///           /   \           .
  ///    after /     \ before   after: runs from c to a, glued to a-c
  ///         a --h-> b         before: runs from b to c, glued to c-b
  struct Fit {
    HalfEdge after, before;
  };
  /// How the triangle of the edge and c fits; nothing if an edge of it is taken, if c lies inside
  /// the surface, or has too many fans. Precondition: is_candidate(h); c is a point.
  std::optional<Fit> fit(HalfEdge h, Point c) const;
  /// Would the triangle of these points touch the surface nowhere?
  bool is_apart(Point a, Point b, Point c) const {
    return a != b && b != c && c != a && !is_used(a) && !is_used(b) && !is_used(c);
  }

  /// A new component: create. Nothing if it is not apart, or if no id is left.
  std::optional<Face> new_front(Point a, Point b, Point c);
  /// Attaches a triangle, and glues it where it meets the front (which Algorithm 1 leaves out:
  /// errata.md). Its half-edge 0 is at h. Nothing if it does not fit, or if no id is left.
  std::optional<Face> attach(HalfEdge h, Point c);

  /// Removes faces so that each point has one fan: of those at a point the one with most corners
  /// stays (the oldest if equal). Returns how many were removed. Where that
  /// parts a fan elsewhere it begins anew. Cost: O(n) each time, mostly once or twice.
  std::size_t part_fans();

 private:
  template <class Visit>
  void for_each_fan(Point p, Visit&& visit) const;
  std::optional<HalfEdge> boundary_edge(Point from, Point to) const;
  bool has_edge(Point from, Point to) const;
  void add_corner(HalfEdge h);
  void remove_fan(Vertex v);

  Surface surface_;
  // Some half-edge that leaves each fan of a point: a list by half-edge. Fans that were glued
  // occur twice in it.
  std::vector<HalfEdge> corner_at_, next_corner_;
};

/// Algorithm 1: grows the surface as the policy wants it, until it names neither edge nor seed. A
/// Policy has
///
///     struct Step { HalfEdge edge; Point apex; };
///     std::optional<Step> next(const AdvancingFront&);     // the next candidate edge, its vertex
///     void refused(const AdvancingFront&, HalfEdge edge);  // it did not fit
///     std::optional<std::array<Point, 3>> find_seed(const AdvancingFront&);
///     bool added(const AdvancingFront&, Face);             // false: stop
///
/// and ends: it names no step or seed for ever that is refused.
template <class Policy>
void advance(AdvancingFront& front, Policy& policy) {
  for (;;) {
    while (const auto step = policy.next(front)) {
      if (const auto f = front.attach(step->edge, step->apex)) {
        if (!policy.added(front, *f)) return;
      } else {
        policy.refused(front, step->edge);
      }
    }
    const auto seed = policy.find_seed(front);
    if (!seed) return;
    if (const auto f = front.new_front((*seed)[0], (*seed)[1], (*seed)[2]))
      if (!policy.added(front, *f)) return;
  }
}

}  // namespace clers

#endif

// Flips and welds as they were applied, to be undone and applied again: to the last id.
//
// A sequence of stellar operators takes one triangulation to another, and back (Topological mesh
// operators, §5.2 and §7.4). Backwards, a weld is a split and a flip three more of it. That makes
// the same triangles; `turn` and `begin_star` make them the same corners and stars (surface.h). Ids
// come back by themselves, as long as the last operator is undone first.
#ifndef CLERS_TOPOLOGY_MODELING_OPERATOR_LOG_H
#define CLERS_TOPOLOGY_MODELING_OPERATOR_LOG_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <clers/topology/export.h>
#include <clers/topology/follow.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// Observes flips and welds (follow.h) and takes a surface back and forth along them. Nothing else
/// may change the surface. `place()` operators are applied, `size() - place()` undone; what is
/// observed comes after the applied ones, and those undone are forgotten.
///
/// Memory: 8 bytes an operator, 4 more a weld, 4 for each star half-edge that comes to lie
/// elsewhere: some 50 bytes for each edge that simplify() contracts. Undoing and applying again
/// allocates nothing, if nothing is attached to the surface.
class OperatorLog {
 public:
  std::size_t size() const { return operators_.size(); }
  std::size_t place() const { return place_; }

  /// Room for so many operators more, which then are observed without an allocation.
  void reserve(std::size_t more) {
    internal::reserve_more(operators_, more);
    internal::reserve_more(points_, more);
    internal::reserve_more(stars_, max_stars * more);
  }
  /// An operator that was applied to the surface, a flip or a weld.
  void operator()(const Change& change);

  /// Undoes the last operator that is applied. Precondition: place() > 0. `observer` is called for
  /// each flip, split and turn that this takes: up to nine. Cost: O(1).
  template <class Observer = NoObserver>
  void undo(Surface& surface, Observer&& observer = {}) {
    const Operator& o = operators_[--place_];
    if (o.kind == Kind::flip)
      for (int i = 0; i < 3; ++i) (void)flip(surface, o.at, observer);
    else
      unweld(surface, o, observer);
    for (unsigned i = 0; i < o.stars; ++i) (void)surface.begin_star(stars_[--star_place_]);
  }
  /// Applies the next operator again. Precondition: place() < size(). Cost: O(1).
  template <class Observer = NoObserver>
  void redo(Surface& surface, Observer&& observer = {}) {
    const Operator& o = operators_[place_++];
    star_place_ += o.stars;
    if (o.kind == Kind::flip) {
      (void)flip(surface, o.at, observer);
    } else {
      ++point_place_;
      HalfEdge h = half_edge(left(o.at), o.corner(0));
      if (o.kind == Kind::weld_interior_edge) h = surface.sym(lprev(h));
      (void)weld(surface, h, observer);
    }
  }

 private:
  static constexpr std::size_t max_stars = 4;
  enum class Kind : std::uint8_t { flip, weld_interior_edge, weld_boundary_edge, weld_face };
  struct Operator {
    HalfEdge at;  // the edge that turns, or Welded::at
    Kind kind = Kind::flip;
    std::uint8_t stars = 0;
    std::uint8_t corners = 0;  // that of the welded vertex in each face it had, two bits a face

    unsigned corner(unsigned face) const { return corners >> 2 * face & 3; }
  };

  template <class Observer>
  void unweld(Surface& surface, const Operator& o, Observer&& observer) {
    const Point p = points_[--point_place_];
    const Vertex v = o.kind == Kind::weld_face ? *split(surface, left(o.at), p, observer)
                                               : *split(surface, o.at, p, observer);
    // In the order of o.corners: as Change::of_weld goes.
    std::array<Face, 4> faces{left(o.at)};
    unsigned count = 1;
    if (o.kind == Kind::weld_face) {
      for (const HalfEdge h : surface.fan(v))
        if (left(h) != faces[0]) faces[count++] = left(h);
    } else {
      faces[count++] = left(surface.sym(half_edge(faces[0], 0)));
    }
    if (o.kind == Kind::weld_interior_edge) {
      faces[3] = left(surface.sym(half_edge(faces[0], 2)));
      faces[2] = left(surface.sym(half_edge(faces[3], 2)));
      count = 4;
    }
    for (unsigned i = 0; i < count; ++i)
      for (unsigned k = 0; k < o.corner(i); ++k) (void)turn(surface, faces[i], observer);
  }

  std::vector<Operator> operators_;
  std::vector<Point> points_;    // of welded vertices
  std::vector<HalfEdge> stars_;  // Change::stars()
  std::size_t place_ = 0, point_place_ = 0, star_place_ = 0;
};

}  // namespace clers

#endif

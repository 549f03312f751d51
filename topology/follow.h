// What a stellar operator changed, for whoever keeps values by element: observers of operators.
//
// Values that need no more than to stay with their elements: element_data.h.
#ifndef CLERS_TOPOLOGY_FOLLOW_H
#define CLERS_TOPOLOGY_FOLLOW_H

#include <array>
#include <span>
#include <type_traits>

#include <clers/topology/export.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// What a stellar operator did to the elements around it, for values that callers keep by corner,
/// side, face or vertex. What it does not name is unchanged. All moves happen at once: a half-edge
/// may be named both as an old one and as a new one.
class Change {
 public:
  /// A half-edge of a face that has changed. As a corner (of left(at), at org(at)) its value is the
  /// mean of the old values of `corners()`: one, or the two or three between which a new vertex was
  /// put. As a side it has the old value of `side`, null if its edge is new; a welded edge has that
  /// of its half at the origin of Welded::at.
  struct Slot {
    HalfEdge at, side;
    std::array<HalfEdge, 3> from;
    std::uint8_t count = 1;
    std::span<const HalfEdge> corners() const { return std::span(from).first(count); }
  };
  /// A face that is new, and the one it is a part of.
  struct Part {
    Face face, of;
  };

  std::span<const Slot> slots() const { return std::span(slots_).first(slot_count_); }
  std::span<const Part> parts() const { return std::span(parts_).first(part_count_); }
  /// Of a split: the new vertex, and the ends or corners between which it was put. Else null and
  /// none.
  Vertex made() const { return made_; }
  std::span<const Vertex> between() const { return std::span(between_).first(between_count_); }
  /// Of a weld: the vertex and the faces that were removed, and the vertex's point. Else null and
  /// none.
  Vertex gone() const { return gone_; }
  Point gone_point() const { return gone_point_; }
  std::span<const Face> gone_faces() const { return std::span(gone_faces_).first(gone_count_); }

  /// Of a flip or weld: the half-edges that were star half-edges of interior vertices and that its
  /// inverse does not make so again. Of the vertex that a weld of h removes h is taken for it.
  std::span<const HalfEdge> stars() const { return std::span(stars_).first(star_count_); }

  static Change of_flip(const Surface& before, HalfEdge h);
  static Change of_split(const Surface& after, HalfEdge h, HalfEdge twin, Vertex v);
  static Change of_split(const Surface& after, Face f, Vertex v);
  static Change of_weld(const Surface& before, HalfEdge h);
  static Change of_turn(Face f);

 private:
  void slot(HalfEdge at, HalfEdge side, HalfEdge corner) {
    slots_[slot_count_++] = {at, side, {corner}, 1};
  }
  void star(const Surface& before, HalfEdge h) {
    const Vertex v = before.org(h);
    if (before.star_half_edge(v) == h && !before.is_boundary(v)) stars_[star_count_++] = h;
  }

  std::array<Slot, 12> slots_;
  std::array<Part, 2> parts_;
  std::array<Vertex, 3> between_;
  std::array<Face, 2> gone_faces_;
  std::array<HalfEdge, 4> stars_;
  Vertex made_, gone_;
  Point gone_point_;
  std::uint8_t slot_count_ = 0, part_count_ = 0, between_count_ = 0, gone_count_ = 0,
               star_count_ = 0;
};

/// Observes nothing, and costs nothing: the operators below then are those of the surface.
struct NoObserver {};

template <class Observer>
inline constexpr bool observes = !std::is_same_v<std::remove_cvref_t<Observer>, NoObserver>;

/// The stellar operators of the surface. `observer` is called with the Change after each that was
/// not refused. If it throws, the operator has been applied all the same.
template <class Observer = NoObserver>
Result<Done, Violation> flip(Surface& surface, HalfEdge h, Observer&& observer = {}) {
  if constexpr (observes<Observer>) {
    const bool can = surface.is_live(h) && surface.sym(h);
    const Change change = can ? Change::of_flip(surface, h) : Change();
    const Result<Done, Violation> done = surface.flip(h);
    if (done) observer(change);
    return done;
  } else {
    return surface.flip(h);
  }
}
template <class Observer = NoObserver>
Result<Vertex, Violation> split(Surface& surface, HalfEdge h, Point p, Observer&& observer = {}) {
  if constexpr (observes<Observer>) {
    const HalfEdge twin = surface.is_live(h) ? surface.sym(h) : HalfEdge();
    const Result<Vertex, Violation> v = surface.split(h, p);
    if (v) observer(Change::of_split(surface, h, twin, *v));
    return v;
  } else {
    return surface.split(h, p);
  }
}
template <class Observer = NoObserver>
Result<Vertex, Violation> split(Surface& surface, Face f, Point p, Observer&& observer = {}) {
  const Result<Vertex, Violation> v = surface.split(f, p);
  if constexpr (observes<Observer>)
    if (v) observer(Change::of_split(surface, f, *v));
  return v;
}
template <class Observer = NoObserver>
Result<Welded, Violation> weld(Surface& surface, HalfEdge h, Observer&& observer = {}) {
  if constexpr (observes<Observer>) {
    const Change change = surface.can_weld(h) ? Change::of_weld(surface, h) : Change();
    const Result<Welded, Violation> done = surface.weld(h);
    if (done) observer(change);
    return done;
  } else {
    return surface.weld(h);
  }
}

/// turn(), observed in the same way.
template <class Observer = NoObserver>
Result<Done, Violation> turn(Surface& surface, Face f, Observer&& observer = {}) {
  const Result<Done, Violation> done = surface.turn(f);
  if constexpr (observes<Observer>)
    if (done) observer(Change::of_turn(f));
  return done;
}

}  // namespace clers

#endif

// Attributes that follow the stellar operators.
#ifndef CLERS_TOPOLOGY_FOLLOW_H
#define CLERS_TOPOLOGY_FOLLOW_H

#include <array>
#include <span>
#include <type_traits>

#include "topology/surface.h"

namespace clers {

/// What a stellar operator did to the elements around it, for values that callers keep by corner,
/// side, face or vertex. What it does not name is as it was. All of it happens at once: a half-edge
/// may be named both as what was and as what is.
class Change {
 public:
  /// A half-edge of a face that has changed. As a corner (of left(at), at org(at)) its value is the
  /// mean of those that the corners in `corners()` had: one, or the two or three amid which a new
  /// vertex lies. As a side it lies along what was `side`, null if its edge is new;
  /// a welded edge takes after its half at the origin of Welded::at.
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
  /// Of a split: the new vertex, and the ends or corners amid which it lies. Null, and none.
  Vertex made() const { return made_; }
  std::span<const Vertex> amid() const { return std::span(amid_).first(amid_count_); }
  /// Of a weld: the vertex and the faces that are no more. Null, and none.
  Vertex gone() const { return gone_; }
  std::span<const Face> gone_faces() const { return std::span(gone_faces_).first(gone_count_); }

  static Change of_flip(HalfEdge h, HalfEdge twin);
  static Change of_split(const Surface& after, HalfEdge h, HalfEdge twin, Vertex v);
  static Change of_split(const Surface& after, Face f, Vertex v);
  static Change of_weld(const Surface& before, HalfEdge h);

 private:
  void slot(HalfEdge at, HalfEdge side, HalfEdge corner) {
    slots_[slot_count_++] = {at, side, {corner}, 1};
  }

  std::array<Slot, 12> slots_;
  std::array<Part, 2> parts_;
  std::array<Vertex, 3> amid_;
  std::array<Face, 2> gone_faces_;
  Vertex made_, gone_;
  std::uint8_t slot_count_ = 0, part_count_ = 0, amid_count_ = 0, gone_count_ = 0;
};

/// Follows nothing, and costs nothing: the operators below then are those of the surface.
struct Alone {};

template <class Follow>
inline constexpr bool follows = !std::is_same_v<std::remove_cvref_t<Follow>, Alone>;

/// The stellar operators of the surface; `follow` is called with the Change once each is done.
/// Refusals are not told. What a Follow throws, the operator has happened.
template <class Follow = Alone>
Result<Done, Violation> flip(Surface& surface, HalfEdge h, Follow&& follow = {}) {
  const Result<Done, Violation> done = surface.flip(h);
  if constexpr (follows<Follow>)
    if (done) follow(Change::of_flip(h, surface.sym(h)));
  return done;
}
template <class Follow = Alone>
Result<Vertex, Violation> split(Surface& surface, HalfEdge h, Point p, Follow&& follow = {}) {
  if constexpr (follows<Follow>) {
    const HalfEdge twin = surface.is_live(h) ? surface.sym(h) : HalfEdge();
    const Result<Vertex, Violation> v = surface.split(h, p);
    if (v) follow(Change::of_split(surface, h, twin, *v));
    return v;
  } else {
    return surface.split(h, p);
  }
}
template <class Follow = Alone>
Result<Vertex, Violation> split(Surface& surface, Face f, Point p, Follow&& follow = {}) {
  const Result<Vertex, Violation> v = surface.split(f, p);
  if constexpr (follows<Follow>)
    if (v) follow(Change::of_split(surface, f, *v));
  return v;
}
template <class Follow = Alone>
Result<Welded, Violation> weld(Surface& surface, HalfEdge h, Follow&& follow = {}) {
  if constexpr (follows<Follow>) {
    const Change change = surface.can_weld(h) ? Change::of_weld(surface, h) : Change();
    const Result<Welded, Violation> done = surface.weld(h);
    if (done) follow(change);
    return done;
  } else {
    return surface.weld(h);
  }
}

}  // namespace clers

#endif

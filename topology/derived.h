// Operators composed of others (Topological mesh operators, §6.4).
#ifndef CLERS_TOPOLOGY_DERIVED_H
#define CLERS_TOPOLOGY_DERIVED_H

#include <array>
#include <span>

#include <clers/topology/export.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// Adds a triangle to the boundary: create on the points of h's destination and origin and on
/// `apex`, then glue of h to its half-edge 0.
///
///          apex                        The new face's corners are dest(h), org(h) and the apex.
///         2    1
///     org --0<-- dest
///         --h-->
///
/// Preconditions: `live_half_edge`, `boundary_edge`, `ids_left`. Effect on (v,e,f,b,g,s):
/// (1,2,1,0,0,0), type 0 and type 1a. Inverse: detach(lnext or lprev of the new half-edge 0).
/// Cost: O(log n). Ids: all stay valid, those of h's ends too.
Result<Face, Violation> attach(Surface& surface, HalfEdge h, Point apex);

/// One unglue that detach did, to be undone by glue(h, twin).
struct Unglued {
  HandleCase undone = HandleCase::zip;
  HalfEdge h, twin;
};

/// What detach did, in this order; then it destroyed the face.
class Detached {
 public:
  std::span<const Unglued> unglued() const { return std::span(unglued_).first(count_); }
  const std::array<Point, 3>& points() const { return points_; }  ///< of corners 0, 1, 2

 private:
  friend Result<Detached, Violation> detach(Surface&, HalfEdge);
  std::array<Unglued, 3> unglued_;
  unsigned count_ = 0;
  std::array<Point, 3> points_;
};

/// Removes the face left of h, wherever it is: unglues its interior edges in the order h, lnext(h),
/// lprev(h), then destroys it. The order decides which cases the unglues are (not their sum): if
/// the first edge has both ends inside, it opens a curve that the next one lengthens. (The paper
/// destroys inside the loop: errata.md.)
///
/// Precondition: `live_half_edge`. Effect: the negative of the glues' and of create's. Inverse:
/// create on points(), then the glues of unglued(), last first. Cost: up to three unglues. Ids:
/// those of the face, and of vertices that no other face has, are freed; else as unglue says.
Result<Detached, Violation> detach(Surface& surface, HalfEdge h);

/// The same from the face's corner 0.
inline Result<Detached, Violation> detach(Surface& surface, Face f) {
  if (!surface.is_live(f)) return Failure{Violation{Precondition::live_face, f.index()}};
  return detach(surface, half_edge(f, 0));
}

}  // namespace clers

#endif

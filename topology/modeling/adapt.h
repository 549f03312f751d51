// Adaptation of a whole mesh to two tests (Dynamic adaptive meshes, Programs 3 and 4).
//
// Where little changes from one time to the next: dynamic_adaptation.h.
#ifndef CLERS_TOPOLOGY_MODELING_ADAPT_H
#define CLERS_TOPOLOGY_MODELING_ADAPT_H

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <clers/modeling/multi_triangulation.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// Where refinement ends if the tests do not end it. A test that is never satisfied is the caller's
/// mistake; the limits see to it that it costs no more than this.
struct AdaptationLimits {
  unsigned level = MultiTriangulation::max_level;  ///< of vertices made
  std::uint32_t faces = max_faces;
};

/// What adaptation did. Where a limit kept it from a split that a test asked for, it says so: the
/// mesh is valid then, but not what the tests want.
struct Adapted {
  std::uint64_t refined = 0;  ///< vertices made, those of neighbours that had to be split first too
  std::uint64_t simplified = 0;  ///< vertices welded
  bool level_limit = false;
  bool face_limit = false;

  bool complete() const { return !level_limit && !face_limit; }
};

namespace internal {

/// An observer that counts what goes on beside another.
template <class Observer>
struct Counting {
  static_assert(hears<Observer>);
  Adapted& done;
  Observer& next;

  void reserve(const Surface& surface) requires requires { next.reserve(surface); }
  { next.reserve(surface); }
  void operator()(const Change& change) requires std::is_invocable_v<Observer&, const Change&> {
    next(change);
  }
  void operator()(const Refined& refined) {
    ++done.refined;
    if constexpr (std::is_invocable_v<Observer&, const Refined&>) next(refined);
  }
  void operator()(const Simplified& simplified) {
    ++done.simplified;
    if constexpr (std::is_invocable_v<Observer&, const Simplified&>) next(simplified);
  }
};

/// Do the limits allow refine(h)? If not, `done` says which.
inline bool within(const AdaptationLimits& limits, const MultiTriangulation& mesh, HalfEdge h,
                   Adapted& done) {
  if (mesh.level(left(h)) >= std::min(limits.level, MultiTriangulation::max_level)) {
    done.level_limit = true;
    return false;
  }
  const std::int64_t limit = std::min(limits.faces, max_faces);
  if (mesh.makes_more_faces(h, limit - mesh.surface().characteristic().f)) {
    done.face_limit = true;
    return false;
  }
  return true;
}

}  // namespace internal

/// Refines split edges for which `need(mesh, h)` is true until there are none (Program 3): h is
/// half-edge 1 of its face, which is of the edge's level, the greater of the two. A new vertex has
/// the next level: `mesh.level(left(h)) < J` leads to level J.
///
/// Observer: as refine's. Cost: passes over all faces until one changes nothing, mostly two; the
/// test once for every split edge in each, and again for edges made.
template <class Need, class Observer = NoObserver>
Adapted adapt_refine(MultiTriangulation& mesh, Need&& need, const AdaptationLimits& limits = {},
                     Observer&& observer = {}) {
  Adapted done;
  const Surface& surface = mesh.surface();
  bool changed = true;
  while (changed) {
    changed = false;
    for (std::uint32_t i = 0; i < surface.face_limit();) {
      const Face f(i);
      const HalfEdge h = MultiTriangulation::split_edge(f);
      const bool ask = surface.is_live(f) && !(mesh.is_block(h) && surface.edge(h) != h);
      if (ask && need(std::as_const(mesh), h) && internal::within(limits, mesh, h, done)) {
        (void)mesh.refine(h, internal::Counting<std::remove_reference_t<Observer>>{done, observer});
        changed = true;  // f is a part of itself now: it is asked again
      } else {
        ++i;
      }
    }
  }
  return done;
}

/// Welds vertices that need no other weld first and for which `need(mesh, v)` is true until there
/// are none (Program 4). A vertex with finer neighbours is asked once they are gone, so that none
/// is welded that was not asked: `mesh.level(v) > J` leads to level J.
///
/// Observer: as simplify's. Cost: passes over all vertices until one changes nothing, from the last
/// to the first, which often is from the finest to the coarsest.
template <class Need, class Observer = NoObserver>
Adapted adapt_simplify(MultiTriangulation& mesh, Need&& need, Observer&& observer = {}) {
  Adapted done;
  const Surface& surface = mesh.surface();
  bool changed = true;
  while (changed) {
    changed = false;
    for (std::uint32_t i = surface.vertex_limit(); i-- > 0;) {
      const Vertex v(i);
      if (!surface.is_live(v) || !mesh.can_weld(v) || !need(std::as_const(mesh), v)) continue;
      (void)mesh.simplify(v, internal::Counting<std::remove_reference_t<Observer>>{done, observer});
      changed = true;
    }
  }
  return done;
}

/// Refines, then simplifies. The tests must be parts of one criterion: a vertex that was needed
/// must not be asked away, or each call undoes the other.
template <class NeedRefine, class NeedSimplify, class Observer = NoObserver>
Adapted adapt(MultiTriangulation& mesh, NeedRefine&& need_refine, NeedSimplify&& need_simplify,
              const AdaptationLimits& limits = {}, Observer&& observer = {}) {
  Adapted done = adapt_refine(mesh, need_refine, limits, observer);
  done.simplified = adapt_simplify(mesh, need_simplify, observer).simplified;
  return done;
}

}  // namespace clers

#endif

// Adaptation that touches only what changed (Topological mesh operators, Algorithm 6).
#ifndef CLERS_TOPOLOGY_MODELING_DYNAMIC_ADAPTATION_H
#define CLERS_TOPOLOGY_MODELING_DYNAMIC_ADAPTATION_H

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <clers/modeling/adapt.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// Split edges above `refine` are split, vertices below `simplify` welded. Between the two lies
/// what stays as it is (hysteresis): with simplify < refine a value that trembles changes nothing.
struct Thresholds {
  double refine = 0, simplify = 0;
};

/// Which goes first. Algorithm 6 simplifies first: the mesh is never larger than it must be. The
/// other paper refines first.
enum class AdaptationOrder : std::uint8_t { simplify_first, refine_first };

namespace internal {

/// Ids waiting by priority, the greatest first, equal ones by id. An id that is put in again takes
/// its new priority; the old entry is skipped when it comes to the top.
class Waiting {
 public:
  void put(std::uint32_t id, double priority) {
    if (id >= turn_.size())
      turn_.resize(std::max<std::size_t>(id + std::size_t{1}, 2 * turn_.size()));
    heap_.push_back({priority, id, ++turn_[id]});
    std::push_heap(heap_.begin(), heap_.end());
  }
  struct Entry {
    double priority = 0;
    std::uint32_t id = 0, turn = 0;
    bool operator<(const Entry& o) const {
      return priority != o.priority ? priority < o.priority : id > o.id;
    }
  };
  /// Takes the next out; false if there is none.
  bool take(Entry& next) {
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end());
      next = heap_.back();
      heap_.pop_back();
      if (turn_[next.id] == next.turn) return true;
    }
    return false;
  }
  /// Forgets the id's entry.
  void drop(std::uint32_t id) {
    if (id < turn_.size()) ++turn_[id];
  }

 private:
  std::vector<Entry> heap_;
  std::vector<std::uint32_t> turn_;  // by id
};

/// A set of ids, emptied in O(1).
class Seen {
 public:
  void clear(std::size_t limit) {
    if (turn_.size() < limit) turn_.resize(limit);
    if (++now_ == 0) {
      std::fill(turn_.begin(), turn_.end(), 0u);
      now_ = 1;
    }
  }
  bool first_time(std::uint32_t id) { return std::exchange(turn_[id], now_) != now_; }

 private:
  std::vector<std::uint32_t> turn_;  // by id
  std::uint32_t now_ = 0;
};

}  // namespace internal

/// A mesh that follows a priority: the two queues of Algorithm 6, kept from one call to the next.
/// Only edges and vertices beyond their threshold are in the queues, so what does not change costs
/// nothing, and the queues are as short as the work.
///
/// `Priority` is callable with (mesh, HalfEdge), a split edge as in adapt_refine: how much its
/// block wants to be split; and with (mesh, Vertex), one that can_weld: that of the block its weld
/// would restore, so that what was split for the one is not welded for the other. It may depend on
/// values at the corners of the edge's one or two faces, or at the vertex and its neighbours. After
/// such a value has changed, call `changed`. NaN: neither split nor welded.
///
/// The mesh must not be refined or simplified but through this object as long as it lives. After an
/// exception from `adapt` everything counts as changed.
template <class Priority>
class DynamicAdaptation {
 public:
  /// Everything counts as changed. Cost: none until adapt.
  DynamicAdaptation(MultiTriangulation& mesh, Priority priority, Thresholds thresholds)
      : mesh_(mesh), priority_(std::move(priority)), thresholds_(thresholds) {}

  Thresholds thresholds() const { return thresholds_; }
  /// Everything counts as changed: what is in between may be beyond now.
  void set_thresholds(Thresholds thresholds) {
    thresholds_ = thresholds;
    all_changed();
  }

  /// The vertex has another value than at the last call of adapt. Cost: O(1).
  void changed(Vertex v) {
    if (!all_) changed_.push_back(v);
  }
  void all_changed() { all_ = true, changed_.clear(); }

  /// Simplifies and refines until no edge is above its threshold and no vertex that can be welded
  /// below (Algorithm 6), or a limit stands against it. What a limit stopped is tried again in the
  /// next call. Where the priority of a vertex is not that of the block its weld restores, vertices
  /// just made may be below: the next call welds them, or this one if it refines first.
  ///
  /// Observer: as MultiTriangulation's. Cost: a priority for every split edge and vertex around a
  /// vertex reported as changed and around a split or weld, O(log n) for each that is waiting, of n
  /// that are. If nothing was reported and no limit stopped the last call, O(1).
  template <class Observer = NoObserver>
  Adapted adapt(const AdaptationLimits& limits = {}, Observer&& observer = {},
                AdaptationOrder order = AdaptationOrder::simplify_first) {
    Adapted done;
    if (std::exchange(unfinished_, true)) all_changed();
    look();
    if (order == AdaptationOrder::refine_first) refine(limits, done, observer);
    simplify(done, observer);
    refine(limits, done, observer);
    unfinished_ = false;
    return done;
  }

 private:
  const Surface& surface() const { return mesh_.surface(); }

  /// What stands for the split edge of a face in the queue: the side with the lower id where it is
  /// that of both faces.
  HalfEdge standing_for(Face f) const {
    const HalfEdge h = MultiTriangulation::split_edge(f);
    return mesh_.is_block(h) ? surface().edge(h) : h;
  }
  // Puts an element into its queue if it is beyond the threshold now, else out of it.
  void look_at(HalfEdge h) {
    const double p = priority_(std::as_const(mesh_), h);
    p > thresholds_.refine ? to_split_.put(left(h).index(), p) : to_split_.drop(left(h).index());
  }
  void look_at(Vertex v) {
    const double p = mesh_.can_weld(v) ? priority_(std::as_const(mesh_), v) : thresholds_.simplify;
    p < thresholds_.simplify ? to_weld_.put(v.index(), -p) : to_weld_.drop(v.index());
  }

  /// Looks at all whose priority may depend on a value reported since the last call.
  void look() {
    if (all_) {
      for (const Vertex v : surface().vertices()) look_at(v);
      for (const Face f : surface().faces())
        if (const HalfEdge h = standing_for(f); left(h) == f) look_at(h);
    } else {
      if (!changed_.empty()) begin_seeing();
      for (const Vertex v : changed_)
        if (surface().is_live(v)) look_around(v);
    }
    all_ = false;
    changed_.clear();
  }
  void look_around(Vertex v) {
    see(v);
    for (const Vertex u : surface().adjacent_vertices(v)) see(u);
    for (const HalfEdge h : surface().fan(v)) {
      see(left(h));
      // v is a corner of the face beyond the edge opposite, too.
      see_beyond(lnext(h));
    }
  }
  // Each once since begin_seeing.
  void begin_seeing() {
    seen_faces_.clear(surface().face_limit());
    seen_vertices_.clear(surface().vertex_limit());
  }
  void see(Vertex v) {
    if (seen_vertices_.first_time(v.index())) look_at(v);
  }
  void see(Face f) {
    if (const HalfEdge h = standing_for(f); seen_faces_.first_time(left(h).index())) look_at(h);
  }
  void see_beyond(HalfEdge h) {
    const HalfEdge beyond = surface().sym(h);
    if (beyond && corner(beyond) == 1) see(left(beyond));
  }

  template <class Observer>
  void simplify(Adapted& done, Observer& observer) {
    internal::Waiting::Entry next;
    while (to_weld_.take(next)) {
      const Vertex v(next.id);
      if (!surface().is_live(v) || !mesh_.can_weld(v)) continue;
      const HalfEdge edge = *mesh_.simplify(v, internal::Counting<Observer>{done, observer});
      // Its block; those on its sides, which are no blocks any more; and corners.
      look_at(surface().edge(edge));
      for (const HalfEdge side : surface().star(edge)) {
        look_at(surface().org(side));
        look_at(surface().org(lprev(side)));
        if (surface().is_boundary(side)) look_at(surface().dest(side));
        for (const HalfEdge rim : {lnext(side), lprev(side)}) {
          const HalfEdge beyond = surface().sym(rim);
          if (beyond && corner(beyond) == 1) look_at(beyond);
        }
      }
    }
  }

  template <class Observer>
  void refine(const AdaptationLimits& limits, Adapted& done, Observer& observer) {
    std::vector<internal::Waiting::Entry> stopped;
    internal::Waiting::Entry next;
    while (to_split_.take(next)) {
      const Face f(next.id);
      if (!surface().is_live(f)) continue;
      const HalfEdge h = MultiTriangulation::split_edge(f);
      if (standing_for(f) != h) continue;  // it waits as its other side
      if (!internal::within(limits, mesh_, h, done)) {
        stopped.push_back(next);
        continue;
      }
      made_.clear();
      auto note = [&](const Refined& refined) { made_.push_back(refined.made); };
      (void)mesh_.refine(h, Both<Observer, decltype(note)>(done, observer, note));
      begin_seeing();
      for (const Vertex v : made_) {
        see(v);
        for (const HalfEdge side : surface().fan(v)) see(left(side));
      }
    }
    for (const internal::Waiting::Entry& entry : stopped) to_split_.put(entry.id, entry.priority);
  }

  template <class Observer, class Note>
  struct Both : internal::Counting<Observer> {
    Note& note;
    Both(Adapted& count, Observer& observer, Note& n)
        : internal::Counting<Observer>{count, observer}, note(n) {}
    using internal::Counting<Observer>::operator();
    void operator()(const Refined& refined) {
      internal::Counting<Observer>::operator()(refined);
      note(refined);
    }
  };

  MultiTriangulation& mesh_;
  Priority priority_;
  Thresholds thresholds_;
  internal::Waiting to_split_, to_weld_;  // by face, by vertex
  std::vector<Vertex> changed_;
  std::vector<Vertex> made_;
  internal::Seen seen_faces_, seen_vertices_;
  bool all_ = true;
  bool unfinished_ = false;  // an exception ended the last call
};

}  // namespace clers

#endif

// Spirale Reversi (CAGD 2010, §7.2, Algorithm 3): builds a surface from its CLERS string read
// backwards.
//
// One driver for the decoder, which takes symbols from a stream, and for the encoder where it
// builds a surface again: to count along curves (place_handles.cc) and to look around a gate. The
// printed algorithm only attaches; what C, S, holes, handles and the closing edge need besides is
// in topology/errata.md.
//
// Faces are written last to first, so that they come out in the order in which the encoder met
// them; side 0 of each is its gate.
#ifndef CLERS_CODEC_CONNECTIVITY_SPIRALE_REVERSI_H
#define CLERS_CODEC_CONNECTIVITY_SPIRALE_REVERSI_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/base/portable.h"
#include "codec/connectivity/curve_index.h"
#include "codec/connectivity/waiting_curves.h"
#include "codec/symbols/symbol.h"
#include "topology/front.h"

namespace clers::internal {

/// Which rule a string of symbols breaks.
enum class StreamFault : std::uint8_t {
  none,
  too_many_vertices,  ///< more than were declared
  too_many_merges,    ///< more S than there is room for
  c_on_two_edges,     ///< C where the curve has two edges: its triangle would repeat a vertex
  s_without_gate,     ///< S joins to a pending gate, and there is none
  curve_too_short,    ///< a special S on a curve without room for it
  position,           ///< a special S glues outside the curve
  waiting_curve,      ///< a component ends while a curve waits to be joined, or none waits
  gate_left,          ///< the string ends while gates are pending
  vertex_count,       ///< fewer vertices were made than declared
};

/// What builds up while decoding. All memory is the caller's.
struct Building {
  std::span<std::uint32_t>
      corners;                 ///< 3 a face; on return ids of the construction, not yet numbers
  std::span<FrontLink> links;  ///< one for each vertex id that will be made
  std::vector<std::uint32_t>
      merged;  ///< vertices that S merged away, in order; links[x].prev = into what
  std::uint32_t merges = 0xffffffffu;  ///< how many there may be
  std::uint32_t finished = 0;  ///< vertices that will not change; links[v].prev = how many before v
};

/// Where a string of symbols failed.
struct StreamError {
  StreamFault broken = StreamFault::none;
  std::uint64_t symbol = 0;
};

/// Where a special S glues, from a source that knows.
struct SpecialVertex {
  bool there = false;  ///< on a curve that the S may glue to
  SpecialS kind = SpecialS::hole;
  std::uint32_t q = 0;  ///< end of the edge
};

/// Valence in links of vertices that were merged away, for those who must distinguish them.
inline constexpr std::uint32_t merged_away = 0xffffffffu;

/// Runs the string that `source` gives. A Source answers the questions of codec/format.md:
/// StreamSource from a stream, EventWriter from what was recorded. One that `knows_vertices` finds
/// the vertex that a special S glues to itself: PlacingSource (place_handles.cc), RecordingSource
/// (replayed_script.cc).
///
/// Cost: linear, and O(log n) amortised for every handle.
template <class Pairing, class Source>
class SpiraleReversi {
 public:
  using Gate = typename Front<Pairing>::Gate;
  using Corners = typename Front<Pairing>::Corners;

  SpiraleReversi(Building& to, Pairing& pairing, Source& source)
      : to_(to),
        front_(to.links.data(), pairing),
        source_(source),
        curves_(to.links.data(), to.links.size()) {}

  StreamError run() {
    const std::uint32_t faces = static_cast<std::uint32_t>(to_.corners.size() / 3);
    const std::uint32_t ids = static_cast<std::uint32_t>(to_.links.size());
    if (faces == 0) return {};
    std::uint32_t* out = to_.corners.data() + to_.corners.size();
    FrontLink* const links = to_.links.data();
    std::uint32_t made = 0, finished = 0;
    Corners c;
    Front<Pairing> front = front_;

    if (ids < 3) return {StreamFault::too_many_vertices, 0};
    source_.first();
    Gate gate = front.create(Face(0), 0, c);
    made = 3;
    write(out -= 3, c);

    for (std::uint32_t i = 1; i < faces; ++i) {
      const StreamFault broken =
          source_.symbol(front, gate, pending_.size(), [&](auto symbol) CLERS_INLINE_LAMBDA {
            if constexpr (symbol() == Clers::C) {
              const std::uint32_t x = gate.x;
              if (front.prev(x) == gate.y) return StreamFault::c_on_two_edges;
              gate = front.attach_zip(gate, Face(i), c);
              links[x].prev = finished++;
            } else if constexpr (symbol() == Clers::R) {
              if (made == ids) return StreamFault::too_many_vertices;
              gate = front.attach_keep_right(gate, Face(i), made++, c);
            } else if constexpr (symbol() == Clers::L) {
              if (made == ids) return StreamFault::too_many_vertices;
              gate = front.attach_keep_left(gate, Face(i), made++, c);
            } else if constexpr (symbol() == Clers::S) {
              if (to_.merged.size() == to_.merges) return StreamFault::too_many_merges;
              if (!pending_.empty() && !source_.special()) {
                const Gate left = pending_.back();
                pending_.pop_back();
                gate = glue(gate, Face(i), left.x, left.kx, left.y, left.ky, left.edge,
                            HandleCase::join_components, c);
              } else {
                const Step step = special(gate, Face(i));
                if (step.broken != StreamFault::none) return step.broken;
                gate = step.gate;
                c = step.corners;
              }
            } else {
              if (ids - made < 3) return StreamFault::too_many_vertices;
              if (!pending_.empty() || !source_.new_component(front.prev(gate.x) == gate.y)) {
                if (pending_.size() == to_.merges) return StreamFault::gate_left;  // an S for each
                pending_.push_back(Gate(gate));  // a copy: the gate stays in registers
              } else if (!nothing_waits()) {
                return StreamFault::waiting_curve;
              } else {
                finished = end_component(gate, finished);
              }
              gate = front.create(Face(i), made, c);
              made += 3;
            }
            return StreamFault::none;
          });
      if (broken != StreamFault::none) return {broken, i};
      write(out -= 3, c);
    }
    if (!pending_.empty()) return {StreamFault::gate_left, faces};
    if (!nothing_waits()) return {StreamFault::waiting_curve, faces};
    to_.finished = end_component(gate, finished);
    return {};
  }

 private:
  static void write(std::uint32_t* out, Corners c) {
    out[0] = c.a;
    out[1] = c.b;
    out[2] = c.v;
  }

  struct Step {
    StreamFault broken = StreamFault::none;
    Gate gate;
    Corners corners;
  };

  /// S that does not join to the last pending gate: to an edge of the same curve (1b), or to one
  /// of a curve split off before (1c). Rare and long, so it works on copies.
  CLERS_NEVER_INLINE Step special(Gate gate, Face f) {
    std::uint32_t q = 0;
    HandleCase as = HandleCase::split_curve;
    const StreamFault broken = special_vertex(gate, q, as);
    if (broken != StreamFault::none) return {broken, gate, {}};
    const std::uint32_t p = to_.links[q].prev;
    Step step;
    step.gate = glue(gate, f, p, to_.links[p].valence, q, to_.links[q].valence, front_.edge_into(q),
                     as, step.corners);
    return step;
  }

  /// The end q of the edge that a special S glues to.
  StreamFault special_vertex(Gate gate, std::uint32_t& q, HandleCase& as) {
    if constexpr (Source::knows_vertices) {
      const SpecialVertex found = source_.special_vertex(gate.x, gate.y);
      if (!found.there) return StreamFault::position;
      q = found.q;
      if (found.kind == SpecialS::hole) holes_.push_back(q);
      if (found.kind == SpecialS::join) as = HandleCase::join_curves;
      return StreamFault::none;
    } else {
      switch (source_.kind(!waiting_.empty())) {
        case SpecialS::hole: {
          const StreamFault broken = back(gate, source_.hole_length(), q);
          if (broken == StreamFault::none) holes_.push_back(q);
          return broken;
        }
        case SpecialS::split: {
          CurveIndex::Curve curve = curves_.gather(gate.x, gate.y);
          const std::uint32_t n = curves_.length(curve);
          if (n < 5) return StreamFault::curve_too_short;
          const std::uint64_t d = source_.split_distance(n);
          if (d < 2 || d > n - 3) return StreamFault::position;
          q = curves_.vertex(curve, static_cast<std::uint32_t>(d));
          waiting_.put(curves_.split_off(curve, static_cast<std::uint32_t>(d)));
          return StreamFault::none;
        }
        case SpecialS::join: {
          if (waiting_.empty()) return StreamFault::waiting_curve;
          const std::uint32_t recency = source_.join_curve(waiting_.size());
          if (recency >= waiting_.size()) return StreamFault::position;
          CurveIndex::Curve ring = waiting_.take(recency);
          const std::uint32_t n = curves_.length(ring), position = source_.join_position(n);
          if (position >= n) return StreamFault::position;
          // It is counted from the vertex of the split, which is the last of the ring.
          const std::uint32_t place = (position + n - 1) % n;
          q = curves_.vertex(ring, place);
          curves_.join(curves_.gather(gate.x, gate.y), ring, place);
          as = HandleCase::join_curves;
          return StreamFault::none;
        }
      }
      return StreamFault::position;
    }
  }

  /// q = the vertex d edges before x. The triangle {prev(q), y, x} must not repeat a vertex, and
  /// the curve q .. x must have two edges at least. What is walked here is a hole, and never again.
  StreamFault back(Gate gate, std::uint64_t d, std::uint32_t& q) {
    if (d < 2) return StreamFault::position;
    q = gate.x;
    for (std::uint64_t k = 0; k < d; ++k) {
      q = to_.links[q].prev;
      if (q == gate.y) return StreamFault::position;
    }
    return to_.links[q].prev == gate.y ? StreamFault::position : StreamFault::none;
  }

  Gate glue(Gate gate, Face f, std::uint32_t p, std::uint32_t kp, std::uint32_t q, std::uint32_t kq,
            typename Pairing::Edge pq, HandleCase as, Corners& c) {
    const Gate next = front_.attach_glue(gate, f, p, kp, q, kq, pq, as, c);
    to_.links[gate.x] = {q, merged_away};
    to_.merged.push_back(std::uint32_t(gate.x));
    return next;
  }

  /// Whether every curve split off for a handle has been joined.
  bool nothing_waits() {
    if constexpr (Source::knows_vertices)
      return source_.nothing_waits(holes_);
    else
      return waiting_.empty();
  }

  /// What is left of the boundary is final: the holes, and the curve of the gate. Returns how many
  /// vertices are finished now.
  CLERS_NEVER_INLINE std::uint32_t end_component(Gate gate, std::uint32_t finished) {
    front_.end_component(gate, holes_);
    if (front_.prev(gate.x) == gate.y && source_.closed()) front_.close(gate);
    for (const std::uint32_t hole : holes_) finished = finish_curve(hole, hole, finished);
    holes_.clear();
    finished = finish_curve(gate.x, gate.y, finished);
    to_.links[gate.y].prev = finished++;
    source_.component_ended();
    return finished;
  }

  /// Finishes the vertices from v back to `last`, which is finished only when v is `last` itself.
  std::uint32_t finish_curve(std::uint32_t v, std::uint32_t last, std::uint32_t finished) {
    do {
      const std::uint32_t before = to_.links[v].prev;
      to_.links[v].prev = finished++;
      v = before;
    } while (v != last);
    return finished;
  }

  Building& to_;
  Front<Pairing> front_;
  Source& source_;
  std::vector<Gate> pending_;  ///< gates of parts to be joined by a later S
  CurveIndex curves_;
  WaitingCurves waiting_;             ///< curves split off for a handle
  std::vector<std::uint32_t> holes_;  ///< a vertex of each hole of this component
};

/// Afterwards links[v].prev = how many finished before v, of merged vertices too.
inline void resolve_merges(Building& b) {
  FrontLink* const links = b.links.data();
  for (std::size_t i = b.merged.size(); i-- > 0;) {
    FrontLink& gone = links[b.merged[i]];
    gone.prev =
        links[gone.prev].prev;  // what it merged into died later or never: it has its number
  }
}

/// Turns the ids of the construction into vertex numbers, 0 .. finished-1: latest finished first,
/// so that numbers grow along the faces. `introduced_by`, when not empty, takes the face that
/// introduces each (coded_surface.h): it is written last to first, so the first stays. Cost: one
/// look-up a corner, and one store for who wants those.
inline void number_vertices(Building& b, std::span<std::uint32_t> introduced_by = {}) {
  resolve_merges(b);
  const FrontLink* const links = b.links.data();
  const std::uint32_t last = b.finished - 1;
  if (introduced_by.empty()) {
    for (std::uint32_t& corner : b.corners) corner = last - links[corner].prev;
    return;
  }
  for (std::size_t h = b.corners.size(); h > 0; h -= 3)
    for (std::uint32_t& corner : b.corners.subspan(h - 3, 3)) {
      corner = last - links[corner].prev;
      introduced_by[corner] = static_cast<std::uint32_t>(h / 3 - 1);
    }
}

}  // namespace clers::internal

#endif

// Edgebreaker (CAGD 2010, §7.2, Algorithm 2): unbuilds a surface and names every triangle C, L, E,
// R or S.
//
// A polygon entered through the edge a -> b is a fan of triangles around b, from a on. The right
// side of each but the last is a diagonal, and always the one through which the walk goes on:
// nothing behind it is visited yet, and the right side goes first. So the triangles of a polygon
// follow each other, and all that is left to code of polygons is how many corners each has.
#ifndef CLERS_CODEC_CONNECTIVITY_EDGEBREAKER_H
#define CLERS_CODEC_CONNECTIVITY_EDGEBREAKER_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/base/portable.h"
#include "codec/symbols/symbol.h"
#include "topology/unbuild.h"

namespace clers::internal {

/// An oriented 2-manifold as arrays by half-edge, those of a face consecutive. Vertices are one fan
/// each; surfaces that are no simplicial complexes are allowed, but no face repeats a vertex.
struct SurfaceArrays {
  std::span<const std::uint32_t> org;  ///< origin, below vertex_count
  std::span<HalfEdge> twins;           ///< null on a boundary
  std::uint32_t vertex_count = 0;
  std::span<const std::uint32_t> sizes = {};  ///< of the faces; empty: all are triangles
};

/// The order in which a surface was unbuilt.
struct Traversal {
  /// An S that does not part the surface: a hole, or an end of a handle. What it is called is what
  /// it does in the decoder's order: the end of a handle that comes later here is the `split`.
  struct Special {
    std::uint32_t index;  ///< of the S among the triangles
    HalfEdge left;        ///< the boundary edge that its left side is glued to
    HalfEdge visited;     ///< not of holes: the same edge as a side of a triangle in the order of
                          ///< the walk; side 0 is its gate
    SpecialS kind;        ///< of ends of handles Edgebreaker does not know which: place_handles.h
    /// hole: its edges. split: edges back from the gate. join: edges back from the vertex of the
    /// split.
    std::uint32_t distance = 0;
    std::uint32_t length = 0;   ///< split, join: edges of the curve that distance is counted on
    std::uint32_t recency = 0;  ///< join: how many curves wait that were split off later
  };
  struct Start {
    std::uint32_t index;  ///< of the component's first triangle
    bool closed;          ///< it was opened by ungluing the gate's edge
  };
  enum class Trouble : std::uint8_t {
    none,
    several_fans,  ///< the faces of some vertex form more than one
  };

  std::vector<HalfEdge> gates;         ///< through which each face was entered: a half-edge of it
  std::vector<std::uint8_t> contexts;  ///< in the order of decoding: valence of the pivot << 3 |
                                       ///< symbol. Valences, up to max_valence, if asked for
  static constexpr std::uint32_t max_valence = 15;
  std::vector<Special> specials;  ///< by index
  bool handles = false;           ///< there are some among them
  std::vector<Start> starts;
  std::vector<std::uint32_t> vertices;  ///< vertices[n] = the vertex that a decoder will number n
  /// Of the triangles in the order of the walk, if they are wanted: vertices, or parts of them that
  /// an S has cut off. Those from the number of vertices on are parts of parts_of[0] and so on.
  std::vector<std::uint32_t> corners, parts_of;
  Trouble trouble = Trouble::none;  ///< with any nothing else holds

  Clers symbol(std::uint32_t index) const {
    return static_cast<Clers>(contexts[contexts.size() - 1 - index] & 7);
  }
};

/// A component with boundary starts at its longest curve, at that curve's smallest half-edge; such
/// components come first, by decreasing length and then by that half-edge. A closed one starts at
/// side 0 of its first face. Destroys all faces of the surface. Cost: linear, and for every S the
/// shorter way round its vertex. Precondition: the arrays are a valid surface, but for vertices of
/// several fans. Throws std::bad_alloc only.
///
/// The decoder goes the same way backwards. So the triangles that a vertex has in the part that is
/// left to unbuild are those that it has when the decoder comes there, and the last vertex to be
/// met is the first to be finished. As in the decoder, the two parts that an S leaves of a vertex
/// are two vertices (of one point, CAGD 2010, Appendix A).
///
/// Faces are those of unbuild.h. How many triangles a polygon gives a vertex shows only when it is
/// entered, so valences are not to be had of polygons here.
template <class Faces, class Witness, bool valences>
class Edgebreaker {
  static_assert(!valences || Faces::only_triangles);

 public:
  Edgebreaker(SurfaceArrays surface, Witness& witness, bool with_corners)
      : points_(surface.org),
        org_(surface.org.begin(), surface.org.end()),
        unbuilding_(surface.twins, surface.sizes, witness),
        triangles_(unbuilding_.triangles()),
        with_corners_(with_corners) {
    vertices_.reserve(surface.vertex_count + surface.vertex_count / 8);  // and parts of some
    vertices_.resize(surface.vertex_count);
    result_.corners.resize(3 * (with_corners ? std::size_t(triangles_) : 1));
    result_.gates.resize(unbuilding_.faces());
    result_.contexts.resize(triangles_ + std::size_t(1));  // the first gate has no symbol before it
    result_.vertices.resize(surface.vertex_count);
    if constexpr (valences)
      for (const std::uint32_t v : org_) vertices_[v] += one_triangle;
  }

  Traversal run() {
    for (const HalfEdge start : curves_by_length())
      if (fine() && !unbuilding_.is_destroyed(start)) component(start, false);
    HalfEdge gate(0);
    for (std::uint32_t f = 0; count_ < triangles_ && fine();
         gate = HalfEdge(gate.index() + unbuilding_.size(f++))) {
      if (unbuilding_.is_destroyed(gate)) continue;
      unbuilding_.unglue(gate, 0);
      visit(org(gate), visited);
      visit(org(unbuilding_.next(gate)), visited);
      if (fine()) component(gate, true);
    }
    result_.contexts.resize(triangles_);
    if (triangles_ > 0) result_.contexts[0] = static_cast<std::uint8_t>(last_);
    result_.vertices.resize(numbered_);
    if (!with_corners_) result_.corners.clear();
    std::sort(result_.specials.begin(), result_.specials.end(),
              [](const auto& a, const auto& b) { return a.index < b.index; });
    return std::move(result_);
  }

 private:
  /// Of a vertex of the surface, or of a part of one that an S has cut: visited, on_hole, and how
  /// many triangles are left of it.
  using VertexState = std::uint32_t;
  static constexpr std::uint32_t visited = 1, on_hole = 2, one_triangle = 4;

  /// What the left side of an S leads to, to be visited later.
  struct Pending {
    std::uint32_t index;  ///< of the S
    HalfEdge gate;
  };

  std::uint32_t org(HalfEdge h) const { return org_[h.index()]; }

  bool fine() const { return result_.trouble == Traversal::Trouble::none; }
  void several_fans() { result_.trouble = Traversal::Trouble::several_fans; }

  /// A vertex comes onto a boundary curve for the first time.
  void visit(std::uint32_t v, std::uint32_t as) {
    if (vertices_[v] & visited) several_fans();
    vertices_[v] |= as;
  }

  /// The next half-edge of a boundary curve.
  HalfEdge next_on_boundary(HalfEdge h) const {
    h = unbuilding_.next(h);
    while (!unbuilding_.is_boundary(h)) h = unbuilding_.next(unbuilding_.sym(h));
    return h;
  }

  /// Smallest half-edge of every boundary curve, longest curve first. Marks the vertices on them.
  std::vector<HalfEdge> curves_by_length() {
    const std::span<const HalfEdge> twins = unbuilding_.twins();
    struct BoundaryCurve {
      std::uint64_t length;
      HalfEdge first;
    };
    std::vector<BoundaryCurve> curves;
    std::vector<bool> seen;
    for (auto at = twins.begin(); (at = std::find(at, twins.end(), HalfEdge())) != twins.end();
         ++at) {
      const HalfEdge first(static_cast<std::uint32_t>(at - twins.begin()));
      if (seen.empty()) seen.resize(twins.size());
      if (seen[first.index()]) continue;
      std::uint64_t length = 0;
      HalfEdge h = first;
      do {
        seen[h.index()] = true;
        visit(org(h), visited | on_hole);
        ++length;
        h = next_on_boundary(h);
      } while (h != first);
      curves.push_back({length, first});
    }
    std::sort(curves.begin(), curves.end(), [](const BoundaryCurve& a, const BoundaryCurve& b) {
      return a.length != b.length ? a.length > b.length : a.first < b.first;
    });
    std::vector<HalfEdge> firsts;
    firsts.reserve(curves.size());
    for (const BoundaryCurve& c : curves) firsts.push_back(c.first);
    return firsts;
  }

  /// Unbuilds the component of a boundary edge.
  void component(HalfEdge gate, bool closed) {
    result_.starts.push_back({count_, closed});
    Unbuilding<Faces, Witness>& surface = unbuilding_;
    HalfEdge h = gate;
    do {
      h = next_on_boundary(h);
      vertices_[org(h)] &= ~on_hole;
      result_.vertices[numbered_++] = org(h);
    } while (h != gate);
    const std::uint32_t inside = numbered_;

    const std::uint32_t* const org = org_.data();
    VertexState* vertices = vertices_.data();
    HalfEdge* const gates = result_.gates.data();
    std::uint32_t* const numbers = result_.vertices.data();
    std::uint8_t* const contexts_end = result_.contexts.data() + triangles_;
    const std::size_t next_corners = with_corners_ ? 3 : 0;  // else they are written over
    std::uint32_t* corners = result_.corners.data() + next_corners * count_;
    std::uint32_t count = count_, entered = entered_, numbered = numbered_;
    bool enters = true;  // the gate is one of a face that is whole
    Clers symbol = last_;
    for (;;) {
      const HalfEdge right_side = surface.next(gate), left_side = surface.prev(gate);
      if (enters) gates[Faces::only_triangles ? count : entered++] = gate;
      enters = surface.is_triangle(gate);
      // Beyond a diagonal is what is left of the face.
      const HalfEdge right = enters ? surface.sym(right_side) : left_side;
      const HalfEdge left_gate = surface.sym(left_side);
      const std::uint32_t v = org[left_side.index()];
      corners[0] = org[gate.index()];
      corners[1] = org[right_side.index()];
      corners[2] = v;
      corners += next_corners;
      // The symbol before is the one that a decoder will meet at this gate.
      std::uint32_t valence = 0;
      if constexpr (valences) {
        std::uint32_t& at_x = vertices[org[gate.index()]];
        valence = std::min(at_x / one_triangle, Traversal::max_valence);
        at_x -= one_triangle;
        vertices[org[right_side.index()]] -= one_triangle;
        vertices[v] -= one_triangle;
      }
      contexts_end[-std::ptrdiff_t(count)] =
          static_cast<std::uint8_t>(valence << 3 | static_cast<unsigned>(symbol));
      HalfEdge next = right;
      if (!(vertices[v] & visited)) {
        vertices[v] |= visited;
        numbers[numbered++] = v;
        symbol = Clers::C;
      } else if (!right) {
        symbol = left_gate ? Clers::R : Clers::E;
        next = left_gate;
      } else if (!left_gate) {
        symbol = Clers::L;
      } else {
        symbol = Clers::S;
        part(gate, left_gate, right, count);
        if (!fine()) return;
        vertices = vertices_.data();
      }
      surface.detach(gate, count);
      ++count;
      if (symbol == Clers::E) {
        // What is left to do is pending, unless the walk came there another way: then the S did
        // not part the surface, and is an end of a handle.
        for (;;) {
          if (pending_.empty()) {
            count_ = count;
            entered_ = entered;
            numbered_ = numbered;
            last_ = symbol;
            number_holes(inside);
            return;
          }
          const Pending part = pending_.back();
          pending_.pop_back();
          next = part.gate;
          if (!surface.is_destroyed(next)) break;
          result_.specials.push_back(
              {part.index, next, surface.detached_side(next), SpecialS::split});
          result_.handles = true;
        }
      }
      gate = next;
    }
  }

  /// An S parts the triangles that its vertex v has left, and one part becomes a vertex of its own.
  ///
  ///            left part  v  right part
  ///           . . . . .  / \  . . . . .
  ///          left_gate  /   \  right
  CLERS_NEVER_INLINE void part(HalfEdge gate, HalfEdge left_gate, HalfEdge right,
                               std::uint32_t index) {
    const std::uint32_t v = org(right);
    // The part where the boundary shows first, looking from both sides in turn, is the smaller one.
    HalfEdge r = right, l = left_gate, next;
    std::uint32_t n = 1;
    bool right_is_smaller = true;
    for (;; ++n) {
      next = unbuilding_.sym(unbuilding_.prev(r));
      if (!next) break;
      if (next == unbuilding_.prev(gate))
        return several_fans();  // no boundary: v has one elsewhere
      r = next;
      next = unbuilding_.sym(unbuilding_.next(l));
      if (!next) {
        right_is_smaller = false;
        break;
      }
      l = next;
    }
    const std::uint32_t w = static_cast<std::uint32_t>(vertices_.size());
    const std::uint32_t triangles = valences ? n * one_triangle : 0;
    vertices_.push_back(triangles | visited);
    result_.parts_of.push_back(points_[right.index()]);
    vertices_[v] -= triangles;
    for (HalfEdge h = right_is_smaller ? right : unbuilding_.next(left_gate); h;
         h = right_is_smaller ? unbuilding_.sym(unbuilding_.prev(h)) : around_left(h))
      org_[h.index()] = w;

    if (vertices_[v] & on_hole) {
      vertices_[v] &= ~on_hole;
      const std::uint32_t length =
          join_hole(right_is_smaller ? next_on_boundary(unbuilding_.prev(r)) : unbuilding_.next(l));
      result_.specials.push_back({index, left_gate, HalfEdge(), SpecialS::hole, length});
    } else {
      pending_.push_back({index, left_gate});
    }
  }

  /// From a half-edge out of v to the one of the triangle before.
  HalfEdge around_left(HalfEdge h) const {
    const HalfEdge s = unbuilding_.sym(h);
    return s ? unbuilding_.next(s) : HalfEdge();
  }

  /// The hole that starts with half-edge `from` becomes part of the gate's curve. Returns its
  /// length.
  std::uint32_t join_hole(HalfEdge from) {
    std::uint32_t length = 0;
    HalfEdge h = from;
    do {
      ++length;
      vertices_[org(h)] &= ~on_hole;
      h = next_on_boundary(h);
      hole_vertices_.push_back(points_[h.index()]);
    } while (h != from);
    return length;
  }

  /// A decoder finishes holes after all that is inside.
  void number_holes(std::uint32_t inside) {
    if (hole_vertices_.empty()) return;
    const auto begin = result_.vertices.begin() + static_cast<std::ptrdiff_t>(inside);
    const auto end = result_.vertices.begin() + static_cast<std::ptrdiff_t>(numbered_);
    std::copy_backward(begin, end, end + static_cast<std::ptrdiff_t>(hole_vertices_.size()));
    std::copy(hole_vertices_.begin(), hole_vertices_.end(), begin);
    numbered_ += static_cast<std::uint32_t>(hole_vertices_.size());
    hole_vertices_.clear();
  }

  std::span<const std::uint32_t> points_;  ///< origins as they were
  std::vector<std::uint32_t> org_;
  Unbuilding<Faces, Witness> unbuilding_;
  std::uint32_t triangles_;
  std::vector<VertexState> vertices_;
  bool with_corners_;
  std::vector<Pending> pending_;
  std::vector<std::uint32_t> hole_vertices_;  ///< of this component, in the order of their numbers
  std::uint32_t count_ = 0, entered_ = 0, numbered_ = 0;  ///< triangles, faces, vertices
  Clers last_ = Clers::E;                                 ///< symbol
  Traversal result_;
};

}  // namespace clers::internal

#endif

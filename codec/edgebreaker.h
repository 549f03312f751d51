// Edgebreaker (paper §7.2, Algorithm 2): unbuilds a surface and names every triangle C, L, E, R or
// S.
#ifndef CLERS_CODEC_EDGEBREAKER_H
#define CLERS_CODEC_EDGEBREAKER_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/clers.h"
#include "topology/unbuild.h"

namespace clers {

/// A triangulated oriented 2-manifold as arrays by half-edge. Vertices are one fan each; surfaces
/// that are no simplicial complexes are allowed, but no face repeats a vertex.
struct SurfaceArrays {
  std::span<const std::uint32_t> org;  ///< origin, below vertex_count
  std::span<HalfEdge> twins;           ///< null on a boundary
  std::uint32_t vertex_count = 0;
};

/// The order in which a surface was unbuilt.
struct Traversal {
  /// An S whose left gate was gone when its turn came: a hole or an end of a handle.
  struct Special {
    std::uint32_t index;  ///< of the S in `gates`
    HalfEdge left;        ///< the boundary edge that its left side is glued to
  };
  struct Start {
    std::uint32_t index;  ///< of the component's first triangle in `gates`
    bool closed;          ///< it was opened by ungluing the gate's edge
  };
  std::vector<HalfEdge> gates;    ///< the gate of each triangle, which is a half-edge of it
  std::vector<Clers> letters;     ///< the letter of each triangle
  std::vector<Special> specials;  ///< by index
  std::vector<Start> starts;

  /// Where there are no specials, what a decoder knows when it meets each letter, in its order:
  /// valence of the pivot << 3 | letter. Valences, up to max_valence, are there if asked for.
  std::vector<std::uint8_t> contexts;
  static constexpr std::uint32_t max_valence = 15;
  /// Where there are no specials: vertices[n] = the vertex that a decoder will number n.
  std::vector<std::uint32_t> vertices;
  /// The faces of some vertex form more than one fan: nothing else holds then. False does not say
  /// the opposite where there are specials.
  bool several_fans = false;
};

/// A component with boundary starts at its longest curve, at that curve's smallest half-edge; such
/// components come first, by decreasing length and then by that half-edge. A closed one starts at
/// side 0 of its first face. Destroys all faces of the surface. Cost: linear, and for every S with
/// valences the shorter way round its vertex. Precondition: the arrays are a valid surface, but for
/// vertices of several fans. Throws std::bad_alloc only.
///
/// The decoder goes the same way backwards. So the triangles that a vertex has in the part that is
/// left to unbuild are those that it has when the decoder comes there, and the last vertex to be
/// met is the first to be finished.
template <class Witness, bool valences>
class Edgebreaker {
 public:
  Edgebreaker(SurfaceArrays surface, Witness& witness)
      : surface_(surface), unbuilding_(surface.twins, witness), state_(surface.vertex_count) {
    const std::size_t faces = surface.twins.size() / 3;
    result_.gates.resize(faces);
    result_.letters.resize(faces);
    result_.contexts.resize(faces);
    result_.vertices.resize(surface.vertex_count);
    if constexpr (valences)
      for (const std::uint32_t v : surface.org) state_[v] += one_triangle;
  }

  Traversal run() {
    const std::vector<HalfEdge> firsts = curves_by_length();
    if (result_.several_fans) return std::move(result_);
    for (const HalfEdge start : firsts)
      if (!unbuilding_.is_destroyed(left(start))) component(start, false);
    const std::uint32_t faces = static_cast<std::uint32_t>(surface_.twins.size() / 3);
    for (std::uint32_t f = 0; f < faces && count_ < faces; ++f) {
      if (unbuilding_.is_destroyed(Face(f))) continue;
      const HalfEdge gate = half_edge(Face(f), 0);
      unbuilding_.unglue(gate);
      if (!visit(org(gate)) || !visit(org(lnext(gate)))) {
        result_.several_fans = true;
        return std::move(result_);
      }
      component(gate, true);
    }
    if (faces > 0) result_.contexts[0] = static_cast<std::uint8_t>(last_);
    result_.vertices.resize(numbered_);
    std::sort(result_.specials.begin(), result_.specials.end(),
              [](const auto& a, const auto& b) { return a.index < b.index; });
    return std::move(result_);
  }

 private:
  struct Aside {
    std::uint32_t index;  ///< of the S
    HalfEdge gate;
    std::uint32_t triangles;  ///< of the vertex of the S that are on the gate's side
  };

  std::uint32_t org(HalfEdge h) const { return surface_.org[h.index()]; }

  /// False if it was visited before.
  bool visit(std::uint32_t v) {
    const bool first = !(state_[v] & visited);
    state_[v] |= visited;
    return first;
  }

  /// The next half-edge of a boundary curve.
  HalfEdge next_on_boundary(HalfEdge h) const {
    h = lnext(h);
    while (!unbuilding_.is_boundary(h)) h = lnext(unbuilding_.sym(h));
    return h;
  }

  /// An S will part the triangles that its vertex has left, `all` of them. How many are right?
  /// Looks from both sides in turn; the answer does not matter where they hang together.
  ///
  ///            left part  v  right part
  ///           . . . . .  / \  . . . . .
  ///          left_gate  /   \  right
  std::uint32_t triangles_right(HalfEdge left_gate, HalfEdge right, std::uint32_t all) const {
    HalfEdge l = left_gate, r = right;
    for (std::uint32_t n = 1;; ++n) {
      r = unbuilding_.sym(lprev(r));
      if (!r || r == right) return n;
      l = unbuilding_.sym(lnext(l));
      if (!l) return all - n;
    }
  }

  /// Smallest half-edge of every boundary curve, longest curve first. Marks the vertices on them.
  std::vector<HalfEdge> curves_by_length() {
    struct BoundaryCurve {
      std::uint64_t length;
      HalfEdge first;
    };
    std::vector<BoundaryCurve> curves;
    const std::uint32_t n = static_cast<std::uint32_t>(surface_.twins.size());
    std::vector<bool> seen;
    for (std::uint32_t i = 0; i < n; ++i) {
      const HalfEdge first(i);
      if (!unbuilding_.is_boundary(first)) continue;
      if (seen.empty()) seen.resize(n);
      if (seen[i]) continue;
      std::uint64_t length = 0;
      HalfEdge h = first;
      do {
        seen[h.index()] = true;
        if (!visit(org(h))) result_.several_fans = true;
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
    Unbuilding<Witness>& surface = unbuilding_;
    const std::uint32_t* const org = surface_.org.data();
    std::uint32_t* const state = state_.data();
    std::uint8_t* const contexts_end = result_.contexts.data() + result_.contexts.size();
    HalfEdge h = gate;
    do {
      h = next_on_boundary(h);
      result_.vertices[numbered_++] = org[h.index()];
    } while (h != gate);
    std::uint32_t count = count_, numbered = numbered_;
    Clers letter = last_;
    for (;;) {
      const HalfEdge right_side = lnext(gate), left_side = lprev(gate);
      const HalfEdge right = surface.sym(right_side), left_gate = surface.sym(left_side);
      const std::uint32_t v = org[left_side.index()];
      result_.gates[count] = gate;
      // The letter before is the one that a decoder will meet at this gate.
      std::uint32_t valence = 0;
      if constexpr (valences) {
        std::uint32_t& at_x = state[org[gate.index()]];
        valence = std::min(at_x / one_triangle, Traversal::max_valence);
        at_x -= one_triangle;
        state[org[right_side.index()]] -= one_triangle;
        state[v] -= one_triangle;
      }
      if (count > 0)
        contexts_end[-std::ptrdiff_t(count)] =
            static_cast<std::uint8_t>(valence << 3 | static_cast<unsigned>(letter));
      HalfEdge next;
      if (!(state[v] & visited)) {
        state[v] |= visited;
        result_.vertices[numbered++] = v;
        letter = Clers::C;
        next = right;
      } else if (!right) {
        letter = left_gate ? Clers::R : Clers::E;
        next = left_gate;
      } else if (!left_gate) {
        letter = Clers::L;
        next = right;
      } else {
        letter = Clers::S;
        next = right;
        std::uint32_t on_left = 0;
        if constexpr (valences) {
          const std::uint32_t all = state[v] / one_triangle;
          const std::uint32_t on_right = triangles_right(left_gate, right, all);
          state[v] = on_right * one_triangle | visited;
          on_left = all - on_right;
        }
        aside_.push_back({count, left_gate, on_left});
      }
      result_.letters[count] = letter;
      ++count;
      surface.detach(gate);
      if (letter == Clers::E) {
        // The gate put aside last is what is left to do, unless the walk came to its triangle
        // another way round: then the S did not disconnect.
        for (;;) {
          if (aside_.empty()) {
            count_ = count;
            numbered_ = numbered;
            last_ = letter;
            return;
          }
          const Aside a = aside_.back();
          aside_.pop_back();
          if (!surface.is_destroyed(clers::left(a.gate))) {
            next = a.gate;
            if constexpr (valences)
              state[org[lnext(next).index()]] = a.triangles * one_triangle | visited;
            break;
          }
          result_.specials.push_back({a.index, a.gate});
        }
      }
      gate = next;
    }
  }

  SurfaceArrays surface_;
  Unbuilding<Witness> unbuilding_;
  static constexpr std::uint32_t visited = 1, one_triangle = 2;
  /// Of each vertex: whether it was visited, and the triangles that it has left. A vertex that is
  /// on several curves has those of the curve that is being unbuilt; the others are put aside.
  std::vector<std::uint32_t> state_;
  std::vector<Aside> aside_;
  std::uint32_t count_ = 0, numbered_ = 0;
  Clers last_ = Clers::E;  ///< letter
  Traversal result_;
};

}  // namespace clers

#endif

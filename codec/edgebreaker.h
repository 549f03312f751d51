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
};

/// A component with boundary starts at its longest curve, at that curve's smallest half-edge; such
/// components come first, by decreasing length and then by that half-edge. A closed one starts at
/// side 0 of its first face. Destroys all faces of the surface. Cost: linear. Precondition: the
/// arrays are a valid surface. Throws std::bad_alloc only.
template <class Witness>
class Edgebreaker {
 public:
  Edgebreaker(SurfaceArrays surface, Witness& witness)
      : surface_(surface), unbuilding_(surface.twins, witness), visited_(surface.vertex_count) {
    const std::size_t faces = surface.twins.size() / 3;
    result_.gates.resize(faces);
    result_.letters.resize(faces);
  }

  Traversal run() {
    for (const HalfEdge start : curves_by_length())
      if (!unbuilding_.is_destroyed(left(start))) component(start, false);
    const std::uint32_t faces = static_cast<std::uint32_t>(surface_.twins.size() / 3);
    for (std::uint32_t f = 0; f < faces && count_ < faces; ++f) {
      if (unbuilding_.is_destroyed(Face(f))) continue;
      const HalfEdge gate = half_edge(Face(f), 0);
      unbuilding_.unglue(gate);
      visited_[surface_.org[gate.index()]] = visited_[surface_.org[lnext(gate).index()]] = true;
      component(gate, true);
    }
    std::sort(result_.specials.begin(), result_.specials.end(),
              [](const auto& a, const auto& b) { return a.index < b.index; });
    return std::move(result_);
  }

 private:
  struct Aside {
    std::uint32_t index;  ///< of the S
    HalfEdge gate;
  };

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
        visited_[surface_.org[h.index()]] = true;
        ++length;
        h = lnext(h);
        while (!unbuilding_.is_boundary(h)) h = lnext(unbuilding_.sym(h));
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
    std::uint32_t count = count_;
    for (;;) {
      const HalfEdge right_side = lnext(gate), left_side = lprev(gate);
      const HalfEdge right = surface.sym(right_side), left_gate = surface.sym(left_side);
      const std::uint32_t v = org[left_side.index()];
      result_.gates[count] = gate;
      Clers letter;
      HalfEdge next;
      if (!visited_[v]) {
        visited_[v] = true;
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
        aside_.push_back({count, left_gate});
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
            return;
          }
          const Aside a = aside_.back();
          aside_.pop_back();
          if (!surface.is_destroyed(clers::left(a.gate))) {
            next = a.gate;
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
  std::vector<std::uint8_t> visited_;  ///< vertices on the boundary of what is left
  std::vector<Aside> aside_;
  std::uint32_t count_ = 0;
  Traversal result_;
};

}  // namespace clers

#endif

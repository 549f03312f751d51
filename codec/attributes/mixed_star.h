// What is known around a vertex when its value is coded: ring, parallelograms, lines. It knows the
// surface, but no values.
#ifndef CLERS_CODEC_ATTRIBUTES_MIXED_STAR_H
#define CLERS_CODEC_ATTRIBUTES_MIXED_STAR_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/attributes/parallelograms.h"
#include "codec/connectivity/coded_surface.h"
#include "topology/ids.h"

namespace clers::internal::mixed {

inline constexpr std::uint32_t no_vertex = CodedSurface::nothing;

/// Known vertices around v, the first ones of the walk around it that begins at a half-edge first.
///
///          v             ring: a, b, and other neighbours that are known
///         / \            parallelogram: a, b, c; that of `first`, the gate, is the first, if any
///        a---b
///         \ /
///          c
struct Star {
  static constexpr unsigned most_ring = 12, most_parallelograms = 6;
  struct Parallelogram {
    std::uint32_t a, b, c;
  };
  /// From a neighbour to the vertex across from v in its own ring; two where its degree is odd.
  ///
  ///     v---u---w     v is predicted at 2 u - w
  struct Line {
    unsigned at;         ///< in ring
    std::uint32_t w[2];  ///< both known; the same if the degree is even
  };

  unsigned ring_size = 0, parallelograms = 0, lines = 0;
  std::uint32_t ring[most_ring];
  Parallelogram parallelogram[most_parallelograms];
  Line line[most_ring];
};

/// Finds stars of one surface.
class Stars {
 public:
  explicit Stars(const CodedSurface& surface)
      : surface_(surface), degree_(surface.introduced_by.size()) {
    for (const std::uint32_t v : surface.corners)
      degree_[v] = static_cast<std::uint8_t>(degree_[v] + (degree_[v] < 255));
  }
  static std::uint64_t memory(std::uint64_t vertices) { return vertices; }

  std::uint8_t degree(std::uint32_t v) const { return degree_[v]; }

  /// That of the vertex which half-edge `first` leaves. Precondition: twins are there.
  template <class Known>
  void find(HalfEdge first, const Known& known, Star& star) const {
    star.ring_size = star.parallelograms = star.lines = 0;
    const auto look = [&](HalfEdge h) {
      const std::uint32_t a = at(lnext(h)), b = at(lprev(h));
      const bool knows_a = known(a), knows_b = known(b);
      if (knows_a) add(star, h, a, known);
      if (!knows_a || !knows_b || star.parallelograms == Star::most_parallelograms) return;
      const HalfEdge across = surface_.twins[lnext(h).index()];
      if (!across) return;
      const std::uint32_t c = at(lprev(across));
      if (known(c)) star.parallelogram[star.parallelograms++] = {a, b, c};
    };
    HalfEdge h = first;
    unsigned faces = 0;
    do {
      look(h);
      const HalfEdge side = lprev(h);
      h = surface_.twins[side.index()];
      if (!h) {
        const std::uint32_t b = at(side);
        if (known(b) && star.ring_size < Star::most_ring) star.ring[star.ring_size++] = b;
      }
    } while (h && h != first && ++faces < most_faces);
    if (h) return;
    for (h = surface_.twins[first.index()]; h && faces < most_faces;
         h = surface_.twins[h.index()], ++faces)
      look(h = lnext(h));
  }

 private:
  static constexpr unsigned most_degree = 16, most_faces = 64;

  std::uint32_t at(HalfEdge h) const { return surface_.corners[h.index()]; }

  /// Half-edge h runs to u, which is known.
  template <class Known>
  void add(Star& star, HalfEdge h, std::uint32_t u, const Known& known) const {
    if (star.ring_size == Star::most_ring) return;
    const unsigned place = star.ring_size++;
    star.ring[place] = u;
    const unsigned degree = degree_[u];
    if (degree < 4 || degree > most_degree) return;
    // Around u, clockwise from v.
    HalfEdge g = lnext(h);
    for (unsigned k = 1; k < degree / 2; ++k) {
      g = surface_.twins[g.index()];
      if (!g) return;
      g = lnext(g);
    }
    const std::uint32_t w = at(lnext(g));
    if (!known(w)) return;
    std::uint32_t other = w;
    if (degree % 2 != 0) {
      g = surface_.twins[g.index()];
      if (!g) return;
      other = at(lnext(lnext(g)));
      if (!known(other)) return;
    }
    star.line[star.lines++] = {place, {w, other}};
  }

  CodedSurface surface_;
  std::vector<std::uint8_t> degree_;
};

}  // namespace clers::internal::mixed

#endif

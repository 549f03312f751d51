// Across which edges of a surface the values of corners differ: a flag an edge, in the context of
// the seams that are known where it ends, around its two triangles, and of another attribute.
#ifndef CLERS_CODEC_ATTRIBUTES_SEAMS_H
#define CLERS_CODEC_ATTRIBUTES_SEAMS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/attributes/coded_faces.h"
#include "codec/attributes/missing.h"
#include "codec/attributes/parallelograms.h"
#include "codec/base/portable.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/coder.h"
#include "topology/ids.h"

namespace clers::internal {

/// Of each half-edge: 1 if it is on a seam, else 0.
using Seams = std::vector<std::uint8_t>;

inline std::uint64_t seams_memory(std::uint64_t half_edges) {
  return half_edges;
}

/// Codes seams: edges at one of whose ends the two corners that they part have different values.
/// Edges on which a corner at each end is without a value count as seams, and cost nothing; so do
/// diagonals, which are never seams. Triangles are gone through in coded order, and each edge is
/// coded with the later of its two. Precondition: the surface has twins. Cost: linear.
class SeamCoder {
 public:
  /// `value_of` tells which corners have values, if some may have none; empty: all have. `beside`
  /// are the seams of another attribute, or nullptr.
  SeamCoder(const CodedFaces& faces, std::span<const std::uint32_t> value_of, const Seams* beside)
      : faces_(faces),
        surface_(faces.surface),
        value_of_(value_of),
        beside_(beside),
        at_(faces.vertices) {
    for_each_edge([&](const Edge& edge) CLERS_INLINE_LAMBDA {
      if (!edge.first && !edge.second) return;
      ++at_[edge.from].left;
      ++at_[edge.to].left;
    });
  }
  static std::uint64_t memory(std::uint64_t vertices, std::uint64_t half_edges) {
    return sizeof(Vertex) * vertices + seams_memory(half_edges);
  }

  /// `same(c, d)` tells an encoder whether two corners of the mesh have one value.
  template <class Coder, class Same>
  Seams code(Coder& coder, const Same& same) {
    Seams seams(surface_.corners.size());
    for_each_edge([&](const Edge& e) CLERS_INLINE_LAMBDA {
      if (!e.first && !e.second) {
        seams[e.side] = seams[e.twin] = 1;
        return;
      }
      Vertex &from = at_[e.from], &to = at_[e.to];
      --from.left;
      --to.left;
      const bool differs =
          Coder::encodes && ((e.first && !same(e.a, e.c)) || (e.second && !same(e.b, e.d)));
      const unsigned one = from.state(), two = to.state();
      const unsigned other = beside_ == nullptr ? 0 : 1u + (*beside_)[e.side];
      BitModel& by_ends = ends_[other][std::min(one, two)][std::max(one, two)];
      BitModel& by_sides = sides_[other][around(seams, e.side)][around(seams, e.twin)]
                                 [std::min(from.seams, 2u) + std::min(to.seams, 2u)];
      const bool seam = coder.decide((by_ends.share() + by_sides.share()) / 2, differs);
      by_ends.update(seam);
      by_sides.update(seam);
      if (!seam) return;
      seams[e.side] = seams[e.twin] = 1;
      ++from.seams;
      ++to.seams;
    });
    return seams;
  }

 private:
  struct Vertex {
    std::uint32_t seams = 0, left = 0;  ///< edges that are seams, that are not coded yet

    static constexpr unsigned states = 9;
    unsigned state() const { return 3 * std::min(seams, 2u) + std::min(left, 2u); }
  };
  struct Edge {
    std::uint32_t side, twin, from, to;  ///< half-edges; where side starts and ends
    std::uint32_t a, b, c, d;  ///< corners: side starts at a and ends at b, across are c and d
    bool first, second;        ///< whether both corners there have values
  };

  /// Calls visit(edge) for each edge that may be a seam, with the later of its sides.
  template <class Visit>
  void for_each_edge(Visit visit) const {
    const std::uint32_t* const corners = surface_.corners.data();
    const auto count = static_cast<std::uint32_t>(surface_.corners.size());
    const bool diagonals = !faces_.corner_of.empty();
    const auto has = [&](std::uint32_t c) { return value_of_.empty() || value_of_[c] != no_value; };
    for (std::uint32_t h = 0; h < count; ++h) {
      const HalfEdge twin = surface_.twins[h];
      if (!twin || twin.index() > h) continue;
      const std::uint32_t g = twin.index();
      Edge e{h,
             g,
             corners[h],
             corners[g],
             faces_.corner(h),
             faces_.corner(next_in(h)),
             faces_.corner(next_in(g)),
             faces_.corner(g),
             true,
             true};
      if (diagonals && e.a == e.c && e.b == e.d) continue;
      e.first = has(e.a) && has(e.c);
      e.second = has(e.b) && has(e.d);
      visit(static_cast<const Edge&>(e));
    }
  }

  /// How many of the two other sides of its triangle are seams, as far as is known.
  static unsigned around(const Seams& seams, std::uint32_t h) {
    return unsigned(seams[next_in(h)]) + seams[previous_in(h)];
  }

  const CodedFaces& faces_;
  const CodedSurface& surface_;
  const std::span<const std::uint32_t> value_of_;
  const Seams* const beside_;
  std::vector<Vertex> at_;
  BitModel ends_[3][Vertex::states][Vertex::states], sides_[3][3][3][5];
};

}  // namespace clers::internal

#endif

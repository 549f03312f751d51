// What undoes the cuts: which vertices of a surface are copies of one vertex of the mesh. Decoding
// makes one of them again. Knows the triangles of a surface. codec/format.md, Copies; the paper's
// Vertex and Point (CAGD 2010, Appendix A), as a stream.
//
// Of the vertices that are one in the mesh the first names their class; the others are its copies.
// Cuts run along edges, so that there are as many sheets of the same edges: the class of a copy
// mostly has a member beside another member of the class of one of its neighbours.
//
//          v ------ w            v is a copy, w is of the class of m:
//          :        :            the class of v is likely that of a neighbour of m
//          x ------ m
#ifndef CLERS_CODEC_SOUP_STITCHING_H
#define CLERS_CODEC_SOUP_STITCHING_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "codec/base/no_index.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/stream.h"

namespace clers::internal {

/// Codes the classes of surface vertices. Cost: a pass over vertices and faces, all else by the
/// vertices on cuts: those that are copies, or have one.
class Stitching {
  struct Neighbour {
    std::uint32_t place, next;
  };
  static constexpr unsigned most_listed =
      16;  ///< neighbours of a vertex, so that hubs cost no more
  static constexpr std::uint64_t most_neighbours(std::uint64_t corners, std::uint64_t on_cuts) {
    return std::min(2 * corners, most_listed * on_cuts);
  }

 public:
  /// `corners` are triangles of surface vertices, all below `vertices`, of which there are more
  /// than `copies`.
  Stitching(std::span<const std::uint32_t> corners, std::uint32_t vertices, std::uint32_t copies)
      : triangles_(corners), vertices_(vertices), copies_(copies) {}

  /// Memory that a Stitching takes at most, in bytes.
  static std::uint64_t memory(std::uint64_t corners, std::uint64_t vertices, std::uint64_t copies) {
    const std::uint64_t on_cuts = std::min(vertices, 2 * copies);
    return 5 * vertices + 17 * on_cuts + sizeof(Neighbour) * most_neighbours(corners, on_cuts);
  }

  /// A Coder that encodes gets classes[v], the least vertex of the class of v; one that decodes
  /// fills them in. False: what was decoded names no class, or there are not `copies` copies.
  template <class Coder>
  bool code(Coder& coder, std::span<std::uint32_t> classes) {
    if constexpr (Coder::encodes) mark(classes);
    if (!code_marks(coder)) return false;
    if constexpr (!Coder::encodes) std::iota(classes.begin(), classes.end(), 0u);
    list_neighbours();
    const std::uint32_t count = static_cast<std::uint32_t>(on_cut_.size());
    class_.resize(count);
    ring_.resize(count);
    std::uint32_t copies = 0;
    unsigned before = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t v = on_cut_[i];
      class_[i] = ring_[i] = i;
      const bool copy = coder.bit(copy_[before], classes[v] != v);
      before = (before << 1 | copy) & 7;
      if (!copy) continue;
      if (copies++ == copies_) return false;
      const std::uint32_t c = code_class(coder, i, place_[classes[v]]);
      if (c >= i || class_[c] != c) return false;
      class_[i] = last_ = c;
      std::swap(ring_[i], ring_[c]);
      classes[v] = on_cut_[c];
    }
    return copies == copies_;
  }

 private:
  void mark(std::span<const std::uint32_t> classes) {
    marks_.resize(vertices_);
    for (std::uint32_t v = 0; v < vertices_; ++v)
      if (classes[v] != v) marks_[v] = marks_[classes[v]] = 1;
  }

  /// Which vertices are on cuts: by the distance to the next one where there were none lately, one
  /// by one where there were.
  template <class Coder>
  bool code_marks(Coder& coder) {
    marks_.resize(vertices_);
    on_cut_.reserve(std::min<std::size_t>(vertices_, 2 * std::size_t(copies_)));
    unsigned lately = 0;
    for (std::uint32_t v = 0; v < vertices_; ++v) {
      if (lately == 0) {
        std::uint32_t gap = 0;
        if constexpr (Coder::encodes)
          while (v + gap < vertices_ && !marks_[v + gap]) ++gap;
        gap = gap_.code(coder, gap);
        if (gap > vertices_ - v) return false;
        v += gap;
        if (v == vertices_) return true;
        marks_[v] = 1;
      } else {
        marks_[v] = coder.bit(mark_[lately], marks_[v]);
      }
      lately = (lately << 1 | marks_[v]) & 15;
      if (!marks_[v]) continue;
      if (on_cut_.size() == 2 * std::uint64_t(copies_)) return false;
      on_cut_.push_back(v);
    }
    return true;
  }

  /// Neighbours of vertices on cuts that are on cuts too.
  void list_neighbours() {
    const std::uint32_t count = static_cast<std::uint32_t>(on_cut_.size());
    place_.resize(vertices_);
    for (std::uint32_t i = 0; i < count; ++i) place_[on_cut_[i]] = i;
    first_.assign(count, no_index);
    listed_.assign(count, 0);
    neighbours_.reserve(static_cast<std::size_t>(most_neighbours(triangles_.size(), count)));
    const auto list = [&](std::uint32_t a, std::uint32_t b) {
      if (!marks_[a] || !marks_[b]) return;
      const std::uint32_t i = place_[a];
      if (listed_[i] == most_listed) return;
      ++listed_[i];
      neighbours_.push_back({place_[b], first_[i]});
      first_[i] = static_cast<std::uint32_t>(neighbours_.size() - 1);
    };
    for (std::size_t h = 0; h < triangles_.size(); h += 3) {
      const std::uint32_t a = triangles_[h], b = triangles_[h + 1], c = triangles_[h + 2];
      if (marks_[a] + marks_[b] + marks_[c] < 2) continue;
      list(a, b);
      list(b, a);
      list(b, c);
      list(c, b);
      list(c, a);
      list(a, c);
    }
  }

  template <class Visit>
  void for_each_neighbour(std::uint32_t i, Visit visit) const {
    for (std::uint32_t k = first_[i]; k != no_index; k = neighbours_[k].next)
      visit(neighbours_[k].place);
  }

  /// Classes beside other members of the classes of known neighbours: first what is beside two of
  /// them.
  void gather(std::uint32_t i) {
    candidates_ = both_ = 0;
    std::array<std::uint32_t, 2> known{no_index, no_index};
    unsigned count = 0;
    for_each_neighbour(i, [&](std::uint32_t w) {
      if (w >= i || count == 2 || ring_[w] == w || class_[w] == known[0]) return;
      known[count] = class_[w];
      unsigned members = 4;
      const unsigned end = count == 1 ? candidates_ : 0;
      for (std::uint32_t m = ring_[w]; m != w && members > 0; m = ring_[m], --members)
        for_each_neighbour(m, [&](std::uint32_t x) {
          if (x >= i) return;
          const std::uint32_t c = class_[x];
          if (c == known[0] || c == known[1]) return;
          unsigned k = 0;
          while (k < candidates_ && candidate_[k] != c) ++k;
          if (k == candidates_) {
            if (candidates_ < candidate_.size()) candidate_[candidates_++] = c;
          } else if (k < end && k >= both_) {
            std::swap(candidate_[k], candidate_[both_++]);
          }
        });
      ++count;
    });
  }

  template <class Coder>
  std::uint32_t code_class(Coder& coder, std::uint32_t i, std::uint32_t value) {
    gather(i);
    for (unsigned k = 0; k < candidates_; ++k) {
      const std::uint32_t c = candidate_[k];
      const bool beside_both = k < both_, has_copies = ring_[c] != c;
      const unsigned rank = std::min(beside_both ? k : k - both_, 7u);
      if (coder.bit(taken_[beside_both][has_copies][rank], value == c)) return c;
    }
    return code_from(coder, far_, last_, value);
  }

  std::span<const std::uint32_t> triangles_;
  const std::uint32_t vertices_, copies_;
  std::vector<std::uint8_t> marks_;    ///< of each vertex: it is on a cut
  std::vector<std::uint32_t> on_cut_;  ///< the vertices on cuts, ascending
  std::vector<std::uint32_t> place_;   ///< in `on_cut_`, of each vertex there
  // By place:
  std::vector<std::uint32_t> first_;  ///< of the list of neighbours
  std::vector<std::uint8_t> listed_;  ///< how many neighbours
  std::vector<std::uint32_t> class_;  ///< place of the least vertex
  std::vector<std::uint32_t> ring_;   ///< the next known member of the class
  std::vector<Neighbour> neighbours_;
  std::array<std::uint32_t, 24> candidate_{};
  unsigned candidates_ = 0, both_ = 0;
  std::uint32_t last_ = 0;
  BitModel mark_[16], copy_[8];
  BitModel taken_[2][2][8];
  NumberModel far_, gap_;
};

/// Numbers of mesh vertices from classes: those that name their class, in their order. Returns how
/// many there are.
inline std::uint32_t number_classes(std::span<std::uint32_t> classes) {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> number(classes.size());
  for (std::uint32_t v = 0; v < classes.size(); ++v)
    if (classes[v] == v) number[v] = count++;
  for (std::uint32_t& c : classes) c = number[c];
  return count;
}

/// `vertices[v]`: which vertex of the input, of `inputs`, vertex v of the surface is, or is a copy
/// of; then that of each mesh vertex. The surface, too, becomes one on mesh vertices.
inline EncodedStream encode_copies(std::uint32_t inputs, CodedArrays& surface,
                                   std::vector<std::uint32_t>& vertices) {
  const std::uint32_t count = static_cast<std::uint32_t>(vertices.size());
  std::uint32_t copies = 0;
  std::vector<std::uint32_t> classes(count), first(inputs, no_index);
  for (std::uint32_t v = 0; v < count; ++v) {
    std::uint32_t& c = first[vertices[v]];
    if (c > v)
      c = v;
    else
      ++copies;
    classes[v] = c;
  }
  EncodedStream out{{copies}, encode_stream([&](EncodeTo& coder) {
                      Stitching(surface.corners, count, copies).code(coder, classes);
                    })};
  const std::uint32_t points = number_classes(classes);
  for (std::uint32_t v = 0; v < count; ++v) vertices[classes[v]] = vertices[v];
  vertices.resize(points);
  stitch(classes, surface.corners, surface.introduced_by);
  return out;
}

/// What a mesh says of the copies before it is decoded.
struct CopiesHeader {
  std::uint64_t copies = 0;  ///< vertices that the surface has more than the mesh
  Stream stream;

  void read(ByteReader& in) { stream = read_stream(in, {&copies}); }
  /// Why a surface of so many vertices cannot have them; empty: it can.
  std::string fault(std::uint64_t vertices) const {
    if (copies > 0 && copies < vertices) return {};
    return std::to_string(copies) + " copies among " + std::to_string(vertices) + " vertices";
  }
};

/// Makes mesh vertices of those of the surface, of which there are `vertices`, in `introduced_by`
/// too unless that is empty. Precondition: no fault. Error: invalid.
inline Expected<Done> decode_copies(const CopiesHeader& header, std::uint32_t vertices,
                                    std::span<std::uint32_t> triangles,
                                    std::vector<std::uint32_t>& introduced_by) {
  std::vector<std::uint32_t> classes(vertices);
  auto ok = decode_stream(header.stream, "the copies", [&](DecodeFrom& coder) -> std::string {
    if (Stitching(triangles, vertices, static_cast<std::uint32_t>(header.copies))
            .code(coder, classes))
      return {};
    return "a vertex is a copy of none, or there are not " + std::to_string(header.copies) +
           " copies";
  });
  if (!ok) return ok;
  number_classes(classes);
  stitch(classes, triangles, introduced_by);
  return ok;
}

}  // namespace clers::internal

#endif

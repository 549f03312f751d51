// What undoes the cuts: which vertices of a surface are copies of one vertex of the mesh.
//
// Of the vertices that are one in the mesh the first names their class; the others are its copies.
// Cuts run along edges, so that there are as many sheets of the same edges: the class of a copy
// mostly has a member beside another member of the class of one of its neighbours.
//
//          v ------ w            v is a copy, w is of the class of m:
//          :        :            the class of v is likely that of a neighbour of m
//          x ------ m
#ifndef CLERS_CODEC_STITCHING_H
#define CLERS_CODEC_STITCHING_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "codec/corners_of.h"
#include "codec/event_model.h"

namespace clers {

/// Codes the classes of surface vertices. A class is named by its first member: where copies are
/// few by number, else in the order in which the faces have them. Cost: linear; where copies are few
/// 4 bytes each, else 12 bytes a vertex and 4 a corner.
class Stitching {
 public:
  static constexpr std::uint32_t unknown = 0xffffffffu;

  /// Whether there are so many copies that it pays to look at the faces.
  static bool along_faces(std::uint64_t vertices, std::uint64_t copies) {
    return copies > vertices / 512;
  }
  /// Memory that a Stitching takes, in bytes.
  static std::uint64_t memory(std::uint64_t corners, std::uint64_t vertices, std::uint64_t copies) {
    return along_faces(vertices, copies) ? CornersOf::memory(corners, vertices) + 9 * vertices
                                         : vertices / 8;
  }

  /// `corners` are triangles of surface vertices, all below `vertices`, of which there are more
  /// than `copies`.
  Stitching(std::span<const std::uint32_t> corners, std::uint32_t vertices, std::uint32_t copies)
      : triangles_(corners), copies_(copies), met_(vertices) {
    if (!along_faces(vertices, copies)) return;
    corners_ = CornersOf(corners, vertices);
    ring_.resize(vertices);
    std::iota(ring_.begin(), ring_.end(), 0u);
    // Around an interior vertex, every neighbour comes next as often as it came before.
    turns_.resize(vertices);
    for (std::size_t h = 0; h < corners.size(); h += 3) {
      const std::uint32_t a = corners[h], b = corners[h + 1], c = corners[h + 2];
      turns_[a] += b - c;
      turns_[b] += c - a;
      turns_[c] += a - b;
    }
  }

  /// A Coder that encodes gets the class of each vertex; one that decodes fills them in. False: what
  /// was decoded names no class, or there are not `copies` copies.
  template <class Coder>
  bool code(Coder& coder, std::span<std::uint32_t> classes) {
    return along_faces(met_.size(), copies_) ? code_along_faces(coder, classes)
                                             : code_by_number(coder, classes);
  }

 private:
  template <class Coder>
  bool code_by_number(Coder& coder, std::span<std::uint32_t> classes) {
    const std::uint32_t vertices = static_cast<std::uint32_t>(met_.size());
    std::uint32_t last = 0, v = 0;
    for (std::uint32_t left = copies_;; --left, ++v) {
      std::uint32_t copy = v;  // the next one, or the end
      if (left == 0) {
        copy = vertices;
      } else {
        if constexpr (Coder::encodes)
          while (classes[copy] == copy) ++copy;
        const std::uint32_t gap = gap_.code(coder, copy - v);
        if (gap >= vertices - v) return false;
        copy = v + gap;
      }
      for (; v < copy; ++v) {
        classes[v] = v;
        met_[v] = true;
      }
      if (left == 0) return true;
      const std::uint32_t c = code_from(coder, far_, last, classes[v]);
      if (c >= v || !met_[c]) return false;
      classes[v] = last = c;
    }
  }

  template <class Coder>
  bool code_along_faces(Coder& coder, std::span<std::uint32_t> classes) {
    std::uint32_t left = copies_;
    for (std::size_t i = 0; i < triangles_.size(); i += 3) {
      const std::span<const std::uint32_t> face = triangles_.subspan(i, 3);
      for (const std::uint32_t v : face) {
        if (met_[v]) continue;
        std::array<std::uint32_t, 2> known{};
        unsigned count = 0, copies = 0;
        for (const std::uint32_t w : face) {
          if (!met_[w]) continue;
          copies += classes[w] != w;
          known[count++] = w;
        }
        const unsigned context = (is_interior(v) * 3 + count) * 3 + copies;
        const bool copy = coder.bit(copy_[context * 2 + last_was_copy_], classes[v] != v);
        last_was_copy_ = copy;
        if (!copy) {
          classes[v] = v;
        } else {
          if (left-- == 0) return false;
          const std::uint32_t c = code_class(coder, v, std::span(known).first(count), classes);
          if (c >= met_.size() || !met_[c] || classes[c] != c) return false;
          classes[v] = last_ = c;
          std::swap(ring_[v], ring_[c]);
        }
        met_[v] = true;
      }
    }
    return left == 0;
  }

  bool is_interior(std::uint32_t v) const { return turns_[v] == 0; }

  static constexpr unsigned most_looked_at = 8;  ///< triangles of a vertex, so that hubs cost no more

  /// Classes beside other members of the classes of the known neighbours: first what is beside two
  /// of them.
  void gather(std::span<const std::uint32_t> known, std::span<const std::uint32_t> classes) {
    candidates_ = both_ = 0;
    for (const std::uint32_t w : known) {
      const unsigned end = candidates_;
      unsigned members = 4;
      for (std::uint32_t m = ring_[w]; m != w && members > 0; m = ring_[m], --members)
        corners_.for_each_neighbour(m, most_looked_at, [&](std::uint32_t x) {
          if (!met_[x]) return;
          const std::uint32_t c = classes[x];
          for (const std::uint32_t k : known)
            if (c == classes[k]) return;
          const auto at = std::find(candidate_.begin(), candidate_.begin() + candidates_, c);
          const unsigned i = static_cast<unsigned>(at - candidate_.begin());
          if (i == candidates_) {
            if (candidates_ < candidate_.size()) candidate_[candidates_++] = c;
          } else if (i < end && i >= both_) {
            std::swap(candidate_[i], candidate_[both_++]);
          }
        });
    }
  }

  template <class Coder>
  std::uint32_t code_class(Coder& coder, std::uint32_t v, std::span<const std::uint32_t> known,
                           std::span<const std::uint32_t> classes) {
    const std::uint32_t value = classes[v];
    gather(known, classes);
    for (unsigned i = 0; i < candidates_; ++i) {
      const bool beside_both = i < both_;
      const unsigned rank = std::min(beside_both ? i : i - both_, 7u);
      const std::uint32_t c = candidate_[i];
      const bool has_copies = ring_[c] != c;
      if (coder.bit(taken_[beside_both][is_interior(v)][has_copies][rank], value == c)) return c;
    }
    return code_from(coder, far_, last_, value);
  }

  std::span<const std::uint32_t> triangles_;
  const std::uint32_t copies_;
  std::vector<bool> met_;
  CornersOf corners_;
  std::vector<std::uint32_t> turns_;  ///< 0: interior, as far as a context needs to know
  std::vector<std::uint32_t> ring_;   ///< members of each class, as far as they are known
  std::array<std::uint32_t, 24> candidate_{};
  unsigned candidates_ = 0, both_ = 0;
  std::uint32_t last_ = 0;
  bool last_was_copy_ = false;
  BitModel copy_[36];
  BitModel taken_[2][2][2][8];
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

}  // namespace clers

#endif

// Where every vertex of a multi-triangulation is in its base (Dynamic adaptive meshes, §6).
#ifndef CLERS_TOPOLOGY_MODELING_LABELS_H
#define CLERS_TOPOLOGY_MODELING_LABELS_H

#include <compare>
#include <cstdint>
#include <vector>

#include <clers/modeling/multi_triangulation.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// A vertex of level k at (i, j) / 2^((k+1)/2) of a block of the base, (k+1)/2 rounded down:
///
///     (0,1) d --------- c (1,1)      The split edge, from b to d, has its first face below it;
///           | \       / |            level 1 is at (1,1)/2, level 2 at the middles of sides, ..
///           |   \   /   |            A block of one face has the triangle a b d alone.
///           |   / \s  \ |
///     (0,0) a --------- b (1,0)
///
/// Of the places that a vertex on a side has in the blocks around it, the least counts: first by
/// block, then j, then i. No two vertices have one label, and a vertex keeps its label for life.
struct Label {
  std::uint32_t block = 0;
  std::uint32_t j = 0, i = 0;
  unsigned level = 0;

  /// i and j as numbers of the unit square, exact.
  double u() const;
  double v() const;

  friend auto operator<=>(const Label&, const Label&) = default;
};

/// Keeps for every face which part of which base face it is, 12 bytes, from which follow the labels
/// of its corners. Observes refine and simplify (the whole Change is not needed).
class Labels {
 public:
  /// The base is the mesh as it is now: none of its vertices is refined. Blocks are numbered by
  /// their lower face.
  explicit Labels(const MultiTriangulation& base);

  /// Blocks of the base.
  std::uint32_t blocks() const { return blocks_; }
  /// The label of a live vertex. Cost: O(level) for each face at it.
  Label of(const MultiTriangulation& mesh, Vertex v) const;
  /// Where corner c of a live face is in that face's own block.
  Label of_corner(const MultiTriangulation& mesh, Face f, unsigned c) const;

  /// Makes room for a split: then `refined` does not fail.
  void reserve(const Surface& surface) {
    internal::reserve_more(parts_, surface.face_limit() + std::size_t{2} - parts_.size());
  }
  void refined(const Surface& surface, const Refined& change);
  void simplified(const Surface& surface, const Simplified& change);

 private:
  struct Part {
    std::uint32_t base = 0;  // twice the block, and 1 for its second face
    // The way from the base face down: a 1, then a bit for each split, 1 for the part at the split
    // edge's destination. Two words, to have no padding.
    std::uint32_t path_high = 0, path_low = 1;

    std::uint64_t path() const { return std::uint64_t{path_high} << 32 | path_low; }
    void set(std::uint64_t path) {
      path_high = static_cast<std::uint32_t>(path >> 32);
      path_low = static_cast<std::uint32_t>(path);
    }
  };

  std::uint32_t blocks_ = 0;
  std::vector<Part> parts_;  // by face
};

}  // namespace clers

#endif

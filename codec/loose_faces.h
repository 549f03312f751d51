// Faces that no surface can have: those of fewer than three corners and those that repeat a vertex.
//
// They are told one by one, by vertices: in rising order, each rotated so that the least sequence
// of vertices comes of it, since cycles have no first corner.
#ifndef CLERS_CODEC_LOOSE_FACES_H
#define CLERS_CODEC_LOOSE_FACES_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/event_model.h"

namespace clers {

/// The rotation of a cycle that makes the least sequence; the first one of those. Linear.
inline std::uint32_t least_rotation(std::span<const std::uint32_t> cycle) {
  const std::size_t n = cycle.size();
  std::size_t i = 0, j = 1, k = 0;  // rotations i and j agree in k places
  while (i < n && j < n && k < n) {
    const std::uint32_t a = cycle[(i + k) % n], b = cycle[(j + k) % n];
    if (a == b) {
      ++k;
      continue;
    }
    (a > b ? i : j) += k + 1;
    if (i == j) ++j;
    k = 0;
  }
  return static_cast<std::uint32_t>(n == 0 ? 0 : std::min(i, j));
}

/// Neighbours of the vertices of triangles, in the order of the faces.
class Neighbours {
 public:
  Neighbours(std::span<const std::uint32_t> corners, std::uint32_t vertices)
      : begin_(std::size_t(vertices) + 2) {
    for (const std::uint32_t v : corners) begin_[v + 2] += 2;
    for (std::size_t v = 2; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    all_.resize(2 * corners.size());
    for (std::size_t i = 0; i < corners.size(); i += 3)
      for (unsigned j = 0; j < 3; ++j)
        for (unsigned k = 1; k < 3; ++k)
          all_[begin_[corners[i + j] + 1]++] = corners[i + (j + k) % 3];
  }
  static constexpr std::uint64_t memory(std::uint64_t corners, std::uint64_t vertices) {
    return sizeof(std::size_t) * (vertices + 2) + 2 * sizeof(std::uint32_t) * corners;
  }
  /// With repetitions. Vertices that no triangle has have none.
  std::span<const std::uint32_t> of(std::uint32_t v) const {
    if (v + std::size_t(2) >= begin_.size()) return {};
    return std::span(all_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> all_;
};

/// Codes loose faces in rising order.
class LooseFaceModel {
 public:
  /// `corners` are the triangles of the mesh, as far as it is a surface, by its vertices.
  LooseFaceModel(std::span<const std::uint32_t> corners, std::uint32_t surface_vertices,
                 std::uint32_t vertices)
      : vertices_(vertices), neighbours_(corners, surface_vertices) {}

  /// A Coder that encodes is told the size.
  template <class Coder>
  std::uint32_t code_size(Coder& coder, std::uint32_t size) {
    return size_.code(coder, size);
  }

  /// A Coder that encodes is told the corners; one that decodes fills them in. False: what was
  /// decoded is no vertex.
  template <class Coder>
  bool code_corners(Coder& coder, std::span<std::uint32_t> face) {
    for (std::size_t j = 0; j < face.size(); ++j) {
      const std::uint64_t v = j == 0 ? std::uint64_t(first_) + step_.code(coder, face[0] - first_)
                                     : code_corner(coder, face[j - 1], face[0], face[j]);
      if (v >= vertices_) return false;
      face[j] = static_cast<std::uint32_t>(v);
    }
    if (!face.empty()) first_ = face[0];
    return true;
  }

 private:
  static constexpr unsigned most_candidates = 16;
  static constexpr std::size_t most_looked_at = 64;  ///< so that hubs cost no more

  template <class Coder>
  std::uint64_t code_corner(Coder& coder, std::uint32_t before, std::uint32_t first,
                            std::uint32_t value) {
    if (coder.bit(again_, value == before)) return before;
    if (before != first && coder.bit(back_, value == first)) return first;
    // No corner of the least rotation is below its first.
    std::uint32_t candidates[most_candidates];
    unsigned n = 0;
    const auto around = neighbours_.of(before);
    for (const std::uint32_t c : around.first(std::min(around.size(), most_looked_at))) {
      if (n == most_candidates) break;
      if (c <= first || std::find(candidates, candidates + n, c) != candidates + n) continue;
      candidates[n++] = c;
    }
    for (unsigned i = 0; i < n; ++i)
      if (coder.bit(neighbour_[i], value == candidates[i])) return candidates[i];
    return std::uint64_t(first) + far_.code(coder, value - first);
  }

  std::uint32_t vertices_;
  Neighbours neighbours_;
  std::uint32_t first_ = 0;  ///< of the face before
  NumberModel size_, step_, far_;
  BitModel again_, back_, neighbour_[most_candidates];
};

}  // namespace clers

#endif

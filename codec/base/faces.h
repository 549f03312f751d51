// Faces of any size as cycles of corners in one array.
#ifndef CLERS_CODEC_BASE_FACES_H
#define CLERS_CODEC_BASE_FACES_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "topology/ids.h"

namespace clers::internal {

/// A view of corners and face sizes: faces as cycles of corners.
class Cycles {
 public:
  /// `sizes` empty: triangles. Precondition: the sizes add up to the corners, which are fewer than
  /// 2^32 - 1. The spans must outlive the view. Cost: constant for triangles, else 4 bytes a face.
  Cycles(std::span<const std::uint32_t> corners, std::span<const std::uint32_t> sizes)
      : org(corners) {
    if (sizes.empty()) return;
    begin_.reserve(sizes.size() + 1);
    begin_.push_back(0);
    for (const std::uint32_t size : sizes) begin_.push_back(begin_.back() + size);
  }

  std::span<const std::uint32_t> org;  ///< vertex of each corner

  bool triangles() const { return begin_.empty(); }
  std::uint32_t count() const {
    return static_cast<std::uint32_t>(triangles() ? org.size() / 3 : begin_.size() - 1);
  }
  std::uint32_t begin(std::uint32_t f) const { return triangles() ? 3 * f : begin_[f]; }
  std::uint32_t end(std::uint32_t f) const { return triangles() ? 3 * f + 3 : begin_[f + 1]; }
  std::uint32_t size(std::uint32_t f) const { return end(f) - begin(f); }
  std::span<const std::uint32_t> cycle(std::uint32_t f) const {
    return org.subspan(begin(f), size(f));
  }

 private:
  std::vector<std::uint32_t> begin_;  ///< first corner of each face, and one past the last
};

/// The same, and the face of each corner. Corner h is also the name of the half-edge that runs from
/// its vertex to that of the next corner of its face.
class Faces : public Cycles {
 public:
  /// As for Cycles, but linear unless they are triangles, and 4 bytes a corner more.
  Faces(std::span<const std::uint32_t> corners, std::span<const std::uint32_t> sizes)
      : Cycles(corners, sizes) {
    if (sizes.empty()) return;
    face_.reserve(corners.size());
    for (std::uint32_t f = 0; f < sizes.size(); ++f) face_.insert(face_.end(), sizes[f], f);
  }

  /// Bytes that a view takes; `sizes`: has it any?
  static constexpr std::uint64_t memory(std::uint64_t corners, std::uint64_t faces, bool sizes) {
    return sizes ? sizeof(std::uint32_t) * (faces + 1 + corners) : 0;
  }

  std::uint32_t face(std::uint32_t h) const { return triangles() ? h / 3 : face_[h]; }
  std::uint32_t next(std::uint32_t h) const {
    const std::uint32_t f = face(h);
    return h + 1 == end(f) ? begin(f) : h + 1;
  }
  std::uint32_t prev(std::uint32_t h) const {
    const std::uint32_t f = face(h);
    return h == begin(f) ? end(f) - 1 : h - 1;
  }
  /// The vertex of the face of h beyond the larger end of h: of a triangle, the third.
  std::uint32_t beyond(std::uint32_t h) const {
    const std::uint32_t after = next(h);
    return org[org[h] < org[after] ? next(after) : prev(h)];
  }

 private:
  std::vector<std::uint32_t> face_;  ///< of each corner
};

/// So that every corner has a number, and triangles made of polygons have.
inline constexpr std::uint64_t max_corners = 3 * std::uint64_t(max_faces);

}  // namespace clers::internal

#endif

// Faces as they stand in the file: for meshes whose order costs more than it is worth to code them
// as a surface.
#ifndef CLERS_CODEC_SOUP_RAW_FACES_H
#define CLERS_CODEC_SOUP_RAW_FACES_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/entropy/coder.h"

namespace clers::internal {

/// Codes one face after the other: every corner is a vertex seen a little before, the lowest that
/// was not seen yet, or told by its distance.
class RawFaceModel {
 public:
  explicit RawFaceModel(std::uint32_t vertex_count) : vertex_count_(vertex_count) {}

  /// A Coder that encodes is told the size.
  template <class Coder>
  std::uint32_t code_size(Coder& coder, std::uint32_t size) {
    size = size_[std::min(last_size_, 5u)].code(coder, size);
    return last_size_ = size;
  }

  /// A Coder that encodes is told the corners; one that decodes fills them in. False: what was
  /// decoded is no vertex.
  template <class Coder>
  bool code_corners(Coder& coder, std::span<std::uint32_t> face) {
    for (std::size_t j = 0; j < face.size(); ++j) {
      const unsigned place = static_cast<unsigned>(std::min<std::size_t>(j, 3));
      const std::uint32_t v = code_corner(coder, place, face[j]);
      if (v >= vertex_count_) return false;
      face[j] = v;
    }
    return true;
  }

 private:
  static constexpr unsigned remembered = 16;

  template <class Coder>
  std::uint32_t code_corner(Coder& coder, unsigned place, std::uint32_t value) {
    unsigned& before = before_[place];
    BitModel* models = models_[place][before];
    if (coder.bit(models[remembered], value == next_)) {
      before = remembered;
      return remember(next_++, remembered - 1);
    }
    for (unsigned i = 0; i < filled_; ++i)
      if (coder.bit(models[i], value == recent_[i])) {
        before = i;
        return remember(recent_[i], i);
      }
    before = remembered + 1;
    const std::uint32_t v = code_from(coder, far_[place], last_[place], value);
    last_[place] = v;
    return remember(v, remembered - 1);
  }

  /// Moves a vertex to the front, from place `at` or from outside.
  std::uint32_t remember(std::uint32_t v, unsigned at) {
    if (filled_ < remembered && at == remembered - 1) at = filled_++;
    std::copy_backward(recent_.begin(), recent_.begin() + at, recent_.begin() + at + 1);
    recent_[0] = v;
    if (v != 0xffffffffu && v >= next_) next_ = v + 1;
    return v;
  }

  std::uint32_t vertex_count_;
  std::uint32_t next_ = 0;  ///< above all seen
  std::array<std::uint32_t, remembered> recent_{};
  unsigned filled_ = 0;
  std::array<std::uint32_t, 4> last_{};
  unsigned last_size_ = 3;
  unsigned before_[4] = {};
  BitModel models_[4][remembered + 2][remembered + 1];
  NumberModel size_[6];
  NumberModel far_[4];
};

/// Fans of triangles in faces, along which values of plain faces are predicted. No sizes:
/// triangles.
inline std::vector<std::uint32_t> fan_triangles(std::span<const std::uint32_t> corners,
                                                std::span<const std::uint32_t> sizes) {
  if (sizes.empty()) return {corners.begin(), corners.end()};
  std::size_t count = 0;
  for (const std::uint32_t size : sizes) count += size < 3 ? 0 : size - 2;
  std::vector<std::uint32_t> triangles;
  triangles.reserve(3 * count);
  const std::uint32_t* face = corners.data();
  for (const std::uint32_t size : sizes) {
    for (std::uint32_t k = 2; k < size; ++k)
      triangles.insert(triangles.end(), {face[0], face[k - 1], face[k]});
    face += size;
  }
  return triangles;
}

}  // namespace clers::internal

#endif

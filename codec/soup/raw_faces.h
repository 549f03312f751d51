// Raw faces: corner by corner in the order of the input, for meshes that are hardly a surface, or
// whose order costs more than a surface saves. Knows no surface. codec/format.md, Mesh.
#ifndef CLERS_CODEC_SOUP_RAW_FACES_H
#define CLERS_CODEC_SOUP_RAW_FACES_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "codec/base/faces.h"
#include "codec/entropy/stream.h"

namespace clers::internal {

/// Codes one face after the other: every corner is a vertex seen a little before, the lowest that
/// was not seen yet, or given by its distance.
class RawFaceModel {
 public:
  explicit RawFaceModel(std::uint32_t vertex_count) : vertex_count_(vertex_count) {}

  template <class Coder>
  std::uint32_t code_size(Coder& coder, std::uint32_t size) {
    size = size_[std::min(last_size_, 5u)].code(coder, size);
    return last_size_ = size;
  }

  /// A coder that decodes fills in the corners. False: what was decoded is no vertex.
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

/// Fans of triangles in faces, along which values of raw faces are predicted. No sizes: triangles.
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

/// The first `count` faces, with all the numbers that stand before them.
inline Bytes encode_raw(const Cycles& faces, std::uint32_t count, std::uint32_t vertices) {
  Bytes out;
  put_varint(out, vertices);
  put_varint(out, faces.count());
  put_varint(out, faces.org.size());
  put_bytes(out, encode_stream([&](EncodeTo& coder) {
              RawFaceModel model(vertices);
              std::vector<std::uint32_t> face;
              for (std::uint32_t f = 0; f < count; ++f) {
                const auto cycle = faces.cycle(f);
                face.assign(cycle.begin(), cycle.end());
                model.code_size(coder, static_cast<std::uint32_t>(face.size()));
                model.code_corners(coder, face);
              }
            }));
  return out;
}

/// What a mesh of raw faces says before it is decoded. The stream is all that follows.
struct RawHeader {
  std::uint64_t vertices = 0, faces = 0, corners = 0;
  Stream stream;

  void read(ByteReader& in) {
    vertices = in.varint();
    faces = in.varint();
    corners = in.varint();
    const std::uint64_t at = in.offset();
    stream = {in.take(in.left()), at};
  }
  /// Why the stream cannot have them; empty: it can.
  std::string fault() const {
    const std::uint64_t most = std::min(stream.max_decisions(), max_corners);
    if (vertices <= 0xffffffffu && faces <= most && corners <= most) return {};
    return std::to_string(faces) + " faces of " + std::to_string(corners) + " corners on " +
           std::to_string(vertices) + " vertices cannot be coded in " +
           std::to_string(stream.bytes.size()) + " bytes";
  }
};

/// Precondition: no fault, and both arrays are empty. Error: invalid.
inline Expected<Done> decode_raw(const RawHeader& header, std::vector<std::uint32_t>& sizes,
                                 std::vector<std::uint32_t>& corners) {
  return decode_stream(header.stream, "the faces", [&](DecodeFrom& coder) -> std::string {
    RawFaceModel model(static_cast<std::uint32_t>(header.vertices));
    corners.resize(static_cast<std::size_t>(header.corners));
    sizes.reserve(static_cast<std::size_t>(header.faces));
    std::size_t at = 0;
    for (std::uint64_t f = 0; f < header.faces; ++f) {
      const std::uint32_t size = model.code_size(coder, 0);
      if (size > corners.size() - at) return "more corners than declared";
      if (!model.code_corners(coder, std::span(corners).subspan(at, size)))
        return "face " + std::to_string(f) + " has no such vertex";
      at += size;
      sizes.push_back(size);
    }
    return at == corners.size() ? "" : "fewer corners than declared";
  });
}

}  // namespace clers::internal

#endif

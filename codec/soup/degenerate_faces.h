// Degenerate faces, which no surface can have: those of fewer than three corners and those that
// repeat a vertex.
//
// They are coded one by one, by their vertices: in rising order, each rotated to its least sequence
// of vertices, since cycles have no first corner. Decoding appends them to the other faces. Knows
// the triangles of the surface by vertices of the mesh. codec/format.md, Mesh.
#ifndef CLERS_CODEC_SOUP_DEGENERATE_FACES_H
#define CLERS_CODEC_SOUP_DEGENERATE_FACES_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "codec/base/faces.h"
#include "codec/base/least_rotation.h"
#include "codec/entropy/stream.h"
#include "codec/order.h"
#include "codec/soup/corners_of.h"

namespace clers::internal {

/// Codes degenerate faces in rising order.
class DegenerateFaceModel {
 public:
  /// `corners` are the triangles of the mesh, as far as it is a surface, by its vertices.
  DegenerateFaceModel(std::span<const std::uint32_t> corners, std::uint32_t surface_vertices,
                      std::uint32_t vertices)
      : vertices_(vertices), corners_(corners, surface_vertices) {}

  template <class Coder>
  std::uint32_t code_size(Coder& coder, std::uint32_t size) {
    return size_.code(coder, size);
  }

  /// A coder that decodes fills in the corners. False: what was decoded is no vertex.
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
  static constexpr unsigned most_looked_at = 32;  ///< triangles, so that hubs cost no more

  template <class Coder>
  std::uint64_t code_corner(Coder& coder, std::uint32_t before, std::uint32_t first,
                            std::uint32_t value) {
    if (coder.bit(again_, value == before)) return before;
    if (before != first && coder.bit(back_, value == first)) return first;
    // No corner of the least rotation is below its first.
    std::uint32_t candidates[most_candidates];
    unsigned n = 0;
    corners_.for_each_neighbour(before, most_looked_at, [&](std::uint32_t c) {
      if (n == most_candidates || c <= first) return;
      if (std::find(candidates, candidates + n, c) == candidates + n) candidates[n++] = c;
    });
    for (unsigned i = 0; i < n; ++i)
      if (coder.bit(neighbour_[i], value == candidates[i])) return candidates[i];
    return std::uint64_t(first) + far_.code(coder, value - first);
  }

  std::uint32_t vertices_;
  CornersOf corners_;
  std::uint32_t first_ = 0;  ///< of the face before
  NumberModel size_, step_, far_;
  BitModel again_, back_, neighbour_[most_candidates];
};

/// Encodes faces, and appends them to the order. `number[v]`: what vertex v of `faces` is in the
/// coded mesh, of `vertices` vertices. `triangles` are those of its surface.
inline EncodedStream encode_degenerate(const Cycles& faces,
                                       std::span<const std::uint32_t> degenerate,
                                       std::span<const std::uint32_t> number,
                                       std::span<const std::uint32_t> triangles,
                                       std::uint32_t surface_vertices, std::uint32_t vertices,
                                       Permutation& order) {
  struct Rotated {
    std::uint32_t face, rotation;
    std::size_t begin, size;
  };
  std::vector<std::uint32_t> corners;
  std::vector<Rotated> rotated;
  for (const std::uint32_t f : degenerate) {
    const std::size_t begin = corners.size();
    for (const std::uint32_t v : faces.cycle(f)) corners.push_back(number[v]);
    const std::span<std::uint32_t> cycle = std::span(corners).subspan(begin);
    const std::uint32_t rotation = least_rotation(
        static_cast<std::uint32_t>(cycle.size()), [cycle](std::uint32_t x, std::uint32_t y) {
          return cycle[x] == cycle[y] ? 0 : cycle[x] < cycle[y] ? -1 : 1;
        });
    std::rotate(cycle.begin(), cycle.begin() + rotation, cycle.end());
    rotated.push_back({f, rotation, begin, cycle.size()});
  }
  const auto cycle = [&](const Rotated& r) { return std::span(corners).subspan(r.begin, r.size); };
  std::stable_sort(rotated.begin(), rotated.end(), [&](const Rotated& a, const Rotated& b) {
    const auto x = cycle(a), y = cycle(b);
    return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
  });
  return {{rotated.size(), corners.size()}, encode_stream([&](EncodeTo& coder) {
            DegenerateFaceModel model(triangles, surface_vertices, vertices);
            for (const Rotated& r : rotated) {
              model.code_size(coder, static_cast<std::uint32_t>(r.size));
              model.code_corners(coder, cycle(r));
              order.faces.push_back(r.face);
              order.first_corners.push_back(r.rotation);
            }
          })};
}

/// What a mesh says of its degenerate faces before it is decoded.
struct DegenerateHeader {
  std::uint64_t faces = 0, corners = 0;
  Stream stream;

  void read(ByteReader& in) { stream = read_stream(in, {&faces, &corners}); }
  /// Why the stream cannot have them; empty: it can.
  std::string fault() const {
    const std::uint64_t most = stream.max_decisions();
    if (faces > 0 && faces <= most && corners <= most) return {};
    return std::to_string(faces) + " degenerate faces of " + std::to_string(corners) +
           " corners cannot be coded in " + std::to_string(stream.bytes.size()) + " bytes";
  }
};

/// Appends them, in a mesh of `vertices` vertices, of which the first are those of the surface.
/// Precondition: no fault. Error: invalid.
inline Expected<Done> append_degenerate(const DegenerateHeader& header,
                                        std::span<const std::uint32_t> triangles,
                                        std::uint32_t surface_vertices, std::uint32_t vertices,
                                        std::vector<std::uint32_t>& sizes,
                                        std::vector<std::uint32_t>& corners) {
  return decode_stream(header.stream, "the degenerate faces",
                       [&](DecodeFrom& coder) -> std::string {
                         DegenerateFaceModel model(triangles, surface_vertices, vertices);
                         std::uint64_t left = header.corners;
                         for (std::uint64_t i = 0; i < header.faces; ++i) {
                           const std::uint32_t size = model.code_size(coder, 0);
                           if (size > left) return "more degenerate corners than declared";
                           left -= size;
                           sizes.push_back(size);
                           corners.resize(corners.size() + size);
                           if (!model.code_corners(coder, std::span(corners).last(size)))
                             return "degenerate face " + std::to_string(i) + " has no such vertex";
                         }
                         return left == 0 ? "" : "fewer degenerate corners than declared";
                       });
}

}  // namespace clers::internal

#endif

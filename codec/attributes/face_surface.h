// The surface that values of faces are predicted along: triangles whose corners name the face that
// they are part of.
//
//        v2____v1         Polygons are several triangles, which all name one value. The twins are
//        / \ .  \         those of the surface, so what is around a corner are the faces around
//       / f \ .f \        its vertex.
//      a________ b
#ifndef CLERS_CODEC_ATTRIBUTES_FACE_SURFACE_H
#define CLERS_CODEC_ATTRIBUTES_FACE_SURFACE_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/attributes/coded_faces.h"
#include "codec/attributes/value_surface.h"

namespace clers::internal {

/// Faces that no surface has are values of no triangle. The vertex of a face is that of its first
/// corner.
class FaceSurface {
 public:
  /// Cost: linear. `faces` must outlive it.
  explicit FaceSurface(const CodedFaces& faces) : whole_(faces.surface) {
    const std::size_t count = faces.faces(), corners = whole_.corners.size();
    vertex_of_.reserve(count);
    face_of_.resize(corners);
    std::size_t begin = 0, h = 0;
    for (std::uint32_t f = 0; f < count; ++f) {
      vertex_of_.push_back(begin < faces.corners.size() ? faces.corners[begin] : 0);
      begin += faces.sizes.empty() ? 3 : faces.sizes[f];
      for (; h < corners && faces.corner(h) < begin; ++h) face_of_[h] = f;
    }
    introduced_by_.resize(count);
    find_introducing(face_of_, introduced_by_);
  }

  ValueSurface view(const Attribute* position) const {
    return {{face_of_, whole_.twins, introduced_by_}, vertex_of_, position, whole_.corners};
  }

  static std::uint64_t memory(std::uint64_t half_edges, std::uint64_t faces) {
    return 4 * half_edges + 8 * faces;
  }

 private:
  CodedSurface whole_;
  std::vector<std::uint32_t> face_of_, introduced_by_, vertex_of_;
};

}  // namespace clers::internal

#endif

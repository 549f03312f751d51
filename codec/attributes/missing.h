// Which elements have no value: a flag each, in the context of what is known nearby.
#ifndef CLERS_CODEC_ATTRIBUTES_MISSING_H
#define CLERS_CODEC_ATTRIBUTES_MISSING_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/attributes/coded_faces.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/coder.h"
#include "codec/mesh.h"

namespace clers::internal {

/// The value of an element that has one, which is not known yet.
inline constexpr std::uint32_t unassigned = no_value - 1;

/// Codes whether each element is no_value or not; then it is unassigned. Cost: linear; a byte a
/// vertex.
class MissingCoder {
 public:
  template <class Coder>
  void code(Coder& coder, const CodedFaces& faces, Domain domain,
            std::span<std::uint32_t> value_of) {
    switch (domain) {
      case Domain::vertex: return code_vertices(coder, faces.surface, value_of);
      case Domain::corner: return code_corners(coder, faces, value_of);
      case Domain::face: return code_faces(coder, value_of);
    }
  }

 private:
  enum State : std::uint8_t { unknown, present, missing };

  template <class Coder>
  static bool flag(Coder& coder, BitModel& model, std::uint32_t& value) {
    const bool is_missing = coder.bit(model, Coder::encodes && value == no_value);
    value = is_missing ? no_value : unassigned;
    return is_missing;
  }

  /// By the vertex before, and those of the triangle that introduces this one.
  template <class Coder>
  void code_vertices(Coder& coder, const CodedSurface& surface, std::span<std::uint32_t> value_of) {
    unsigned before = 0;
    for (std::uint32_t v = 0; v < value_of.size(); ++v) {
      unsigned states[3] = {};
      if (surface.has(v))
        for (std::size_t i = 0; i < 3; ++i) {
          const std::uint32_t u = surface.corners[3 * std::size_t(surface.introduced_by[v]) + i];
          if (u < v) ++states[value_of[u] == no_value ? missing : present];
        }
      const unsigned around = 3 * std::min(states[missing], 2u) + std::min(states[present], 2u);
      before = flag(coder, vertices_[before][around], value_of[v]);
    }
  }

  /// By the corner before, at the beginning of a face the first of the face before; and by the
  /// latest corner at the same vertex.
  template <class Coder>
  void code_corners(Coder& coder, const CodedFaces& faces, std::span<std::uint32_t> value_of) {
    std::vector<std::uint8_t> state(faces.vertices);
    unsigned first = 0;
    std::size_t c = 0;
    for (std::size_t f = 0; f < faces.faces(); ++f) {
      unsigned before = first;
      for (std::uint32_t i = 0, size = faces.sizes.empty() ? 3 : faces.sizes[f]; i < size;
           ++i, ++c) {
        std::uint8_t& at_vertex = state[faces.corners[c]];
        before = flag(coder, corners_[i > 0][before][at_vertex], value_of[c]);
        at_vertex = before ? missing : present;
        if (i == 0) first = before;
      }
    }
  }

  /// By the two faces before.
  template <class Coder>
  void code_faces(Coder& coder, std::span<std::uint32_t> value_of) {
    unsigned before = 0;
    for (std::uint32_t& value : value_of)
      before = (before << 1 | unsigned(flag(coder, faces_[before], value))) & 3;
  }

  BitModel vertices_[2][9], corners_[2][2][3], faces_[4];
};

}  // namespace clers::internal

#endif

// One of two meshes that are compared: attributes in an order that both share, values as colours.
#ifndef CLERS_CODEC_COMPARISON_COMPARED_MESH_H
#define CLERS_CODEC_COMPARISON_COMPARED_MESH_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "codec/base/faces.h"
#include "codec/comparison/colours.h"
#include "codec/error.h"
#include "codec/mesh.h"

namespace clers::internal {

struct ComparedMesh {
  /// Precondition: there is no why_not_comparable() to the mesh, which must outlive this.
  explicit ComparedMesh(const Mesh& mesh);

  Faces faces;
  std::vector<const Attribute*> attributes;  ///< by domain, name and type
  /// Where those of each domain begin and end.
  std::array<std::pair<std::size_t, std::size_t>, 3> of_domain = {};
  std::vector<Colour> colour;         ///< of each vertex: its values, until it is refined
  std::vector<Colour> corner_values;  ///< of each corner; empty: has none
  std::vector<Colour> face_values;    ///< of each face; empty: has none

  std::uint32_t vertices() const { return static_cast<std::uint32_t>(colour.size()); }
  std::uint32_t corners() const { return static_cast<std::uint32_t>(faces.org.size()); }
  Colour value_of_corner(std::uint32_t c) const {
    return corner_values.empty() ? 0 : corner_values[c];
  }
  Colour value_of_face(std::uint32_t f) const { return face_values.empty() ? 0 : face_values[f]; }

  /// How the values of element i of a domain compare, as bits, with those of element j of another
  /// mesh with the same attributes: negative, zero or positive.
  int compare_values(Domain domain, std::uint32_t i, const ComparedMesh& other,
                     std::uint32_t j) const {
    const auto [begin, end] = of_domain[static_cast<std::size_t>(domain)];
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t stride = attributes[k]->stride();
      const int order = std::memcmp(attributes[k]->data.data() + i * stride,
                                    other.attributes[k]->data.data() + j * stride, stride);
      if (order != 0) return order;
    }
    return 0;
  }
  bool equal_values(Domain domain, std::uint32_t i, const ComparedMesh& other,
                    std::uint32_t j) const {
    return compare_values(domain, i, other, j) == 0;
  }
};

/// What keeps a mesh from being compared ("uses vertex 7, expected one below 5"), or nothing.
std::optional<Error> why_not_comparable(const Mesh& mesh);

/// The first attribute that only one of them has.
std::optional<std::string> attributes_differ(const ComparedMesh& a, const ComparedMesh& b);

}  // namespace clers::internal

#endif

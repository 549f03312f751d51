// One of two meshes that are compared: attributes in an order that both share, values as colours.
// Like all of this folder it knows meshes as a caller has them, and nothing of the codec but faces.
#ifndef CLERS_CODEC_COMPARISON_COMPARED_MESH_H
#define CLERS_CODEC_COMPARISON_COMPARED_MESH_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "codec/base/difference.h"
#include "codec/base/direction.h"
#include "codec/base/faces.h"
#include "codec/comparison/colours.h"
#include "codec/comparison/near_values.h"
#include "codec/error.h"
#include "codec/mesh.h"
#include "codec/verdict.h"

namespace clers::internal {

struct ComparedMesh {
  /// Precondition: there is no why_not_comparable() to the mesh, which must outlive this.
  /// Of several tolerances for an attribute the first counts.
  explicit ComparedMesh(const Mesh& mesh, std::span<const Tolerance> tolerances = {});

  Faces faces;
  std::vector<const Attribute*> attributes;  ///< by domain, name and type
  /// Where those of each domain begin and end.
  std::array<std::pair<std::size_t, std::size_t>, 3> of_domain = {};
  /// Of each attribute, the largest difference that is none; not set: bits are compared.
  std::vector<std::optional<double>> tolerance;
  std::vector<ErrorMeasure> measure;  ///< what differences of each are
  /// Of each attribute, whether both meshes say by index which elements share a value: then it must
  /// be the same elements. compare_sharing() finds it.
  std::vector<bool> shared;
  std::vector<Colour> colour;         ///< of each vertex: its values, until it is refined
  std::vector<Colour> corner_values;  ///< of each corner; empty: has none
  std::vector<Colour> face_values;    ///< of each face; empty: has none

  std::uint32_t vertices() const { return static_cast<std::uint32_t>(colour.size()); }
  bool shares() const { return std::find(shared.begin(), shared.end(), true) != shared.end(); }
  bool is_exact() const {
    return std::none_of(tolerance.begin(), tolerance.end(), [](const auto& t) { return t; });
  }
  std::uint32_t corners() const { return static_cast<std::uint32_t>(faces.org.size()); }
  Colour value_of_corner(std::uint32_t c) const {
    return corner_values.empty() ? 0 : corner_values[c];
  }
  Colour value_of_face(std::uint32_t f) const { return face_values.empty() ? 0 : face_values[f]; }

  /// How the values of corner i compare with those of corner j of the same mesh: negative, zero or
  /// positive. As bits, and as colours those that are compared within a tolerance.
  int compare_corners(std::uint32_t i, std::uint32_t j) const {
    const auto [begin, end] = of_domain[static_cast<std::size_t>(Domain::corner)];
    for (std::size_t k = begin; k < end; ++k) {
      const bool has_i = has(k, i), has_j = has(k, j);
      if (has_i != has_j) return has_i ? 1 : -1;
      if (tolerance[k] || !has_i) continue;
      const int order = std::memcmp(value(k, i), value(k, j), attributes[k]->stride());
      if (order != 0) return order;
    }
    const Colour x = value_of_corner(i), y = value_of_corner(j);
    return x < y ? -1 : x > y;
  }
  /// Whether the values of element i of a domain agree with those of element j of another mesh with
  /// the same attributes.
  bool agree(Domain domain, std::uint32_t i, const ComparedMesh& other, std::uint32_t j) const {
    const auto [begin, end] = of_domain[static_cast<std::size_t>(domain)];
    for (std::size_t k = begin; k < end; ++k) {
      if (has(k, i) != other.has(k, j)) return false;
      if (!has(k, i)) continue;
      if (tolerance[k] ? difference_of(k, i, other, j) > *tolerance[k]
                       : std::memcmp(value(k, i), other.value(k, j), attributes[k]->stride()) != 0)
        return false;
    }
    return true;
  }
  /// Whether element i has a value of attribute k.
  bool has(std::size_t k, std::uint32_t i) const {
    return attributes[k]->indices.empty() || attributes[k]->indices[i] != no_value;
  }
  /// The largest difference of a component of attribute k, or the angle. Precondition: both have a
  /// value.
  double difference_of(std::size_t k, std::uint32_t i, const ComparedMesh& other,
                       std::uint32_t j) const {
    if (measure[k] == ErrorMeasure::angle)
      return angle_between(attributes[k]->scalar, value(k, i), other.value(k, j));
    return difference(attributes[k]->scalar, value(k, i), other.value(k, j),
                      attributes[k]->components);
  }

 private:
  const std::byte* value(std::size_t k, std::uint32_t i) const {
    const Attribute& a = *attributes[k];
    return a.data.data() + (a.indices.empty() ? i : a.indices[i]) * a.stride();
  }
};

/// What keeps a mesh from being compared ("uses vertex 7, expected one below 5"), or nothing.
std::optional<Error> why_not_comparable(const Mesh& mesh);

/// The first attribute that only one of them has.
std::optional<std::string> attributes_differ(const ComparedMesh& a, const ComparedMesh& b);

/// Finds in which attributes it matters what elements share. Returns what differs in the values
/// that no element has. Precondition: they have the same attributes. Cost: n log n.
std::optional<std::string> compare_sharing(ComparedMesh& a, ComparedMesh& b);

/// Colours all elements of both by their values: values that agree get the same colour.
/// Precondition: they have the same attributes.
void colour_values(ComparedMesh& a, ComparedMesh& b);
/// The same of vertices alone, in a way that may be closer to the truth and may be wrong.
void colour_vertices(ComparedMesh& a, ComparedMesh& b, Nearness nearness);

}  // namespace clers::internal

#endif

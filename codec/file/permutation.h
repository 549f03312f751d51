// A permutation of a mesh, applied: faces, corners and values in another order. Encoding brings
// them into the order in which they are coded; decoding, where the order of the file was kept,
// back. Knows no bytes.
#ifndef CLERS_CODEC_FILE_PERMUTATION_H
#define CLERS_CODEC_FILE_PERMUTATION_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

#include "codec/base/faces.h"
#include "codec/mesh_view.h"
#include "codec/order.h"

namespace clers::internal {

inline Permutation identity(const MeshView& mesh) {
  Permutation order;
  order.vertices.resize(mesh.vertex_count);
  order.faces.resize(mesh.face_count());
  std::iota(order.vertices.begin(), order.vertices.end(), 0u);
  std::iota(order.faces.begin(), order.faces.end(), 0u);
  order.first_corners.assign(mesh.face_count(), 0);
  return order;
}

/// Where everything went that inverse[i] says to be at i now.
inline std::vector<std::uint32_t> inverse(const std::vector<std::uint32_t>& numbers) {
  std::vector<std::uint32_t> result(numbers.size());
  for (std::uint32_t i = 0; i < numbers.size(); ++i) result[numbers[i]] = i;
  return result;
}

/// Calls visit(corner) for the corners of `faces` in the new order.
template <class Visit>
void for_each_corner(const Cycles& faces, const Permutation& order, Visit visit) {
  for (std::size_t i = 0; i < order.faces.size(); ++i) {
    const std::uint32_t f = order.faces[i], begin = faces.begin(f), size = faces.size(f);
    std::uint32_t j = order.first_corners[i];
    for (std::uint32_t k = 0; k < size; ++k, j = j + 1 == size ? 0 : j + 1) visit(begin + j);
  }
}

struct PermutedFaces {
  std::vector<std::uint32_t> corners, sizes;  ///< no sizes: triangles
};
/// Faces in the new order, by new vertices. Memory besides the result: 4 bytes a vertex.
inline PermutedFaces permuted(const Cycles& faces, const Permutation& order) {
  PermutedFaces result;
  const std::vector<std::uint32_t> number = inverse(order.vertices);
  result.corners.reserve(faces.org.size());
  for_each_corner(faces, order,
                  [&](std::uint32_t c) { result.corners.push_back(number[faces.org[c]]); });
  if (faces.triangles()) return result;
  result.sizes.reserve(faces.count());
  for (const std::uint32_t f : order.faces) result.sizes.push_back(faces.size(f));
  return result;
}

/// What elements of a domain have, in the new order: `size` bytes each, `step` apart. `faces` are
/// those that the elements are of.
inline std::vector<std::byte> permuted_elements(const std::byte* elements, std::size_t size,
                                                std::size_t step, Domain domain,
                                                const Cycles& faces, const Permutation& order) {
  const std::size_t count = domain == Domain::vertex ? order.vertices.size()
                            : domain == Domain::face ? order.faces.size()
                                                     : faces.org.size();
  std::vector<std::byte> result(count * size);
  // Of the usual sizes a copy is a few instructions if they are known.
  const auto copy_all = [&](auto known_size) {
    std::byte* to = result.data();
    const auto copy = [&](std::size_t from) {
      std::memcpy(to, elements + from * step, known_size);
      to += known_size;
    };
    switch (domain) {
      case Domain::vertex:
        for (const std::uint32_t v : order.vertices) copy(v);
        break;
      case Domain::face:
        for (const std::uint32_t f : order.faces) copy(f);
        break;
      case Domain::corner: for_each_corner(faces, order, copy); break;
    }
  };
  switch (size) {
    case 4: copy_all(std::integral_constant<std::size_t, 4>()); break;
    case 8: copy_all(std::integral_constant<std::size_t, 8>()); break;
    case 12: copy_all(std::integral_constant<std::size_t, 12>()); break;
    default: copy_all(size);
  }
  return result;
}

/// An attribute with its elements in the new order, packed. Values by index keep their numbers.
inline Attribute permuted(const AttributeView& a, const Cycles& faces, const Permutation& order) {
  Attribute result{std::string(a.name), a.domain, a.scalar, a.components, {}};
  const std::size_t size = a.value_size(), step = a.step();
  if (a.indices.empty()) {
    result.data = permuted_elements(a.data.data(), size, step, a.domain, faces, order);
    return result;
  }
  result.data.resize(a.value_count() * size);
  for (std::size_t i = 0; i * size < result.data.size(); ++i)
    std::memcpy(result.data.data() + i * size, a.value(i), size);
  const auto indices = std::as_bytes(a.indices);
  const std::vector<std::byte> moved = permuted_elements(
      indices.data(), sizeof(std::uint32_t), sizeof(std::uint32_t), a.domain, faces, order);
  result.indices.resize(a.indices.size());
  std::memcpy(result.indices.data(), moved.data(), moved.size());
  return result;
}

}  // namespace clers::internal

#endif

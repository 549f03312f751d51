// Memory of the caller that a mesh is decoded into.
#ifndef CLERS_CODEC_MESH_TARGET_H
#define CLERS_CODEC_MESH_TARGET_H

#include <cstddef>
#include <cstdint>
#include <ranges>
#include <span>
#include <string_view>
#include <type_traits>

#include <clers/mesh.h>
#include <clers/mesh_view.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// Memory for the values of an attribute, one for each element: the counterpart of AttributeView.
/// Values by index are copied to each element that has them; where one has none, the memory stays
/// as it was.
struct AttributeTarget {
  std::string_view name = {};
  Domain domain = Domain::vertex;
  Scalar scalar = Scalar::float32;  ///< that of the attribute: nothing is converted
  std::uint8_t components = 1;      ///< as stored, too
  /// From the first byte of the first value on. Ends with the last value, or with its stride.
  std::span<std::byte> data = {};
  std::size_t stride = 0;  ///< bytes from one value to the next; 0: packed. Those between two
                           ///< values are left alone

  std::size_t step() const { return stride == 0 ? size_of(scalar) * components : stride; }
};

/// Memory for a mesh, or for a part of it: what is left empty is left out. Sizes are those that
/// MeshInfo says, to the element.
struct MeshTarget {
  std::span<std::uint32_t> corners = {};
  std::span<std::uint16_t> corners_16 = {};  ///< instead: for at most 65536 vertices
  std::span<std::uint32_t> face_sizes = {};  ///< needed with corners or opposites, unless all faces
                                             ///< are triangles
  /// One for each corner h: the half-edge h runs to the next corner of its face. Takes the one that
  /// runs along its edge the other way; no_opposite where there is none, or more than one.
  std::span<std::uint32_t> opposites = {};
  std::span<const AttributeTarget> attributes = {};

  static constexpr std::uint32_t no_opposite = 0xffffffffu;
};

/// A member of all structs of an array: attribute_target("normal", vertices, &Vertex::normal).
template <class Struct, class Member>
AttributeTarget attribute_target(std::string_view name,
                                 std::type_identity_t<std::span<Struct>> structs,
                                 Member Struct::*member, Domain domain = Domain::vertex) {
  AttributeTarget target{
      name, domain, ValueType<Member>::scalar, ValueType<Member>::components, {}, sizeof(Struct)};
  if (structs.empty()) return target;
  const auto all = std::as_writable_bytes(structs);
  const auto* first = reinterpret_cast<const std::byte*>(&(structs[0].*member));
  target.data = all.subspan(static_cast<std::size_t>(first - all.data()));
  return target;
}

/// Packed scalars, so many a value: attribute_target("position", coordinates, 3).
template <class Scalars>
requires std::is_arithmetic_v<ElementOf<Scalars>> && std::ranges::borrowed_range<Scalars>
    AttributeTarget attribute_target(std::string_view name, Scalars&& scalars,
                                     std::uint8_t components, Domain domain = Domain::vertex) {
  return {name,
          domain,
          scalar_of<ElementOf<Scalars>>(),
          components,
          std::as_writable_bytes(std::span(scalars)),
          0};
}

/// Packed values: attribute_target("position", positions) of a std::vector<std::array<float, 3>>.
template <class Values>
requires std::ranges::borrowed_range<Values> AttributeTarget
attribute_target(std::string_view name, Values&& values, Domain domain = Domain::vertex) {
  using Type = ValueType<ElementOf<Values>>;
  static_assert(sizeof(ElementOf<Values>) == size_of(Type::scalar) * Type::components);
  return {name, domain, Type::scalar, Type::components, std::as_writable_bytes(std::span(values)),
          0};
}

}  // namespace clers

#endif

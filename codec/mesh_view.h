// A mesh in memory of the caller, as encode takes it: nothing is copied to describe it.
#ifndef CLERS_CODEC_MESH_VIEW_H
#define CLERS_CODEC_MESH_VIEW_H

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

#include <clers/mesh.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// Values of an attribute, one after the other or a stride apart, as in an interleaved vertex
/// buffer.
struct AttributeView {
  std::string_view name = {};
  Domain domain = Domain::vertex;
  Scalar scalar = Scalar::float32;
  std::uint8_t components = 1;
  /// From the first byte of the first value on. Ends with the last value, or with its stride.
  std::span<const std::byte> data = {};
  std::size_t stride = 0;                       ///< bytes from one value to the next; 0: packed
  std::span<const std::uint32_t> indices = {};  ///< as in Attribute

  std::size_t value_size() const { return size_of(scalar) * components; }
  std::size_t step() const { return stride == 0 ? value_size() : stride; }
  const std::byte* value(std::size_t i) const { return data.data() + i * step(); }
  /// How many there are. Precondition: `data` is as it says.
  std::size_t value_count() const {
    return data.empty() ? 0 : (data.size() - value_size()) / step() + 1;
  }
};

/// The attributes of a Mesh, or an array of views.
class AttributeViews {
 public:
  AttributeViews() = default;
  template <class Range>
  requires std::convertible_to<const Range&, std::span<const AttributeView>> AttributeViews(
      const Range& range) {
    const std::span<const AttributeView> views(range);
    views_ = views.data();
    size_ = views.size();
  }
  template <class Range>
  requires std::convertible_to<const Range&, std::span<const Attribute>> AttributeViews(
      const Range& range) {
    const std::span<const Attribute> attributes(range);
    attributes_ = attributes.data();
    size_ = attributes.size();
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  AttributeView operator[](std::size_t i) const {
    return views_ != nullptr ? views_[i] : AttributeView(attributes_[i]);
  }

  class Iterator {
   public:
    Iterator(const AttributeViews& of, std::size_t at) : of_(&of), at_(at) {}
    AttributeView operator*() const { return (*of_)[at_]; }
    Iterator& operator++() { return ++at_, *this; }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    const AttributeViews* of_;
    std::size_t at_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size_}; }

 private:
  const AttributeView* views_ = nullptr;
  const Attribute* attributes_ = nullptr;
  std::size_t size_ = 0;
};

/// A Mesh converts to one; of other arrays:
///
///     clers::AttributeView attributes[] = {
///         clers::attribute_view("position", vertices, &Vertex::place)};
///     clers::MeshView view;
///     view.vertex_count = vertices.size();
///     view.corners_16 = indices;
///     view.attributes = attributes;
///
/// All that it names must outlive it.
struct MeshView {
  std::uint32_t vertex_count = 0;
  std::span<const std::uint32_t> corners = {};  ///< as in Mesh
  std::span<const std::uint16_t> corners_16 =
      {};  ///< or these, in 16 bits: one of the two is empty
  std::span<const std::uint32_t> face_sizes = {};  ///< empty: all faces are triangles
  AttributeViews attributes = {};
  std::string_view name = {};
  std::span<const MetadataEntry> metadata = {};

  bool triangles_only() const { return face_sizes.empty(); }
  std::size_t corner_count() const { return corners.size() + corners_16.size(); }
  std::size_t face_count() const {
    return triangles_only() ? corner_count() / 3 : face_sizes.size();
  }
  /// Values that an attribute of this domain has.
  std::size_t value_count(Domain domain) const {
    switch (domain) {
      case Domain::vertex: return vertex_count;
      case Domain::corner: return corner_count();
      case Domain::face: return face_count();
    }
    return 0;
  }
  /// The vertex attribute "position".
  std::optional<AttributeView> position() const {
    for (const AttributeView a : attributes)
      if (a.domain == Domain::vertex && a.name == position_name) return a;
    return std::nullopt;
  }
};

inline Attribute::operator AttributeView() const {
  return {name, domain, scalar, components, data, 0, indices};
}
inline Mesh::operator MeshView() const {
  return {vertex_count, corners, {}, face_sizes, attributes, name, metadata};
}

/// What a value of a C++ type is made of: float, float[3] or std::array<float, 3>. Specialize it
/// for a vector type of your own, whose size must be that of its scalars:
///
///     template <>
///     struct clers::ValueType<Vec3> : clers::ValueType<float[3]> {};
template <class T>
struct ValueType {
  static constexpr Scalar scalar = scalar_of<T>();
  static constexpr std::uint8_t components = 1;
};
template <class T, std::size_t n>
requires(n > 0 && n <= 255) struct ValueType<T[n]> {
  static constexpr Scalar scalar = scalar_of<T>();
  static constexpr std::uint8_t components = n;
};
template <class T, std::size_t n>
struct ValueType<std::array<T, n>> : ValueType<T[n]> {};

/// A member of all structs of an array: attribute_view("normal", vertices, &Vertex::normal).
template <class Struct, class Member>
AttributeView attribute_view(std::string_view name,
                             std::type_identity_t<std::span<const Struct>> structs,
                             Member Struct::*member, Domain domain = Domain::vertex) {
  AttributeView view{name, domain,        ValueType<Member>::scalar, ValueType<Member>::components,
                     {},   sizeof(Struct)};
  if (structs.empty()) return view;
  const auto all = std::as_bytes(structs);
  const auto* first = reinterpret_cast<const std::byte*>(&(structs[0].*member));
  view.data = all.subspan(static_cast<std::size_t>(first - all.data()));
  return view;
}

/// What a contiguous range holds.
template <class Range>
using ElementOf =
    std::remove_cv_t<typename decltype(std::span(std::declval<Range&>()))::element_type>;

/// Packed scalars, so many a value: attribute_view("position", coordinates, 3).
template <class Scalars>
requires std::is_arithmetic_v<ElementOf<const Scalars>> AttributeView
attribute_view(std::string_view name, const Scalars& scalars, std::uint8_t components,
               Domain domain = Domain::vertex) {
  return {name,
          domain,
          scalar_of<ElementOf<const Scalars>>(),
          components,
          std::as_bytes(std::span(scalars)),
          0};
}

/// Packed values: attribute_view("position", positions) of a std::vector<std::array<float, 3>>.
template <class Values>
AttributeView attribute_view(std::string_view name, const Values& values,
                             Domain domain = Domain::vertex) {
  using Type = ValueType<ElementOf<const Values>>;
  static_assert(sizeof(ElementOf<const Values>) == size_of(Type::scalar) * Type::components);
  return {name, domain, Type::scalar, Type::components, std::as_bytes(std::span(values)), 0};
}

}  // namespace clers

#endif

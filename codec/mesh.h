// A mesh as plain arrays: face sizes, corner vertices, attributes by domain.
#ifndef CLERS_CODEC_MESH_H
#define CLERS_CODEC_MESH_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <clers/scalar.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

struct AttributeView;  // <clers/mesh_view.h>
struct MeshView;

/// What an attribute has one value for.
enum class Domain : std::uint8_t { vertex = 0, corner = 1, face = 2 };
inline constexpr unsigned domain_count = 3;

/// As in the enumeration. Precondition: the value is one of it.
constexpr const char* name(Domain d) {
  constexpr const char* names[domain_count] = {"vertex", "corner", "face"};
  return names[static_cast<unsigned>(d)];
}

/// In Attribute::indices: an element that has no value.
inline constexpr std::uint32_t no_value = 0xffffffffu;

/// Named values, tuples of `components` scalars, packed, in native byte order. Each vertex, corner
/// or face has one: in their order, or, as an OBJ's `f 1/2/3` has them, by index. The vertex
/// attribute named "position" holds the places of vertices, and is not by index.
struct Attribute {
  std::string name;  ///< UTF-8, at most 255 bytes
  Domain domain = Domain::vertex;
  Scalar scalar = Scalar::float32;
  std::uint8_t components = 1;  ///< at least 1
  std::vector<std::byte> data;  ///< of all values, stride() bytes each

  /// Empty: element i has value i. Else which value each element has, or no_value. Elements may
  /// share values, and a value may be that of none. Decoded, values are numbered in the order of
  /// their first use, and last come those of none; with Order::keep as they were.
  std::vector<std::uint32_t> indices = {};

  std::size_t stride() const { return size_of(scalar) * components; }
  std::size_t value_count() const { return data.size() / stride(); }
  operator AttributeView() const;
};

/// What the file of a mesh says besides the mesh: its source, comments, names. The library carries
/// it without a look at it; codec/io documents what it writes here.
struct MetadataEntry {
  std::string key;    ///< UTF-8, 1 to 255 bytes, no other entry's
  std::string value;  ///< any bytes
};

inline constexpr char position_name[] = "position";

/// Faces are cycles of vertex indices, counterclockwise seen from outside, concatenated in
/// `corners`. Vertices are 0 .. vertex_count-1; one that no face uses is allowed.
struct Mesh {
  std::uint32_t vertex_count = 0;
  std::vector<std::uint32_t> corners;     ///< each below vertex_count
  std::vector<std::uint32_t> face_sizes;  ///< corners of each face; empty: all faces are triangles
  std::vector<Attribute> attributes;
  std::string name;  ///< of the object in its file, UTF-8; may be empty
  std::vector<MetadataEntry> metadata;

  bool triangles_only() const { return face_sizes.empty(); }
  std::size_t face_count() const {
    return triangles_only() ? corners.size() / 3 : face_sizes.size();
  }
  /// Values that an attribute of this domain has.
  std::size_t value_count(Domain domain) const {
    switch (domain) {
      case Domain::vertex: return vertex_count;
      case Domain::corner: return corners.size();
      case Domain::face: return face_count();
    }
    return 0;
  }

  /// The vertex attribute "position", or nullptr.
  const Attribute* position() const {
    for (const Attribute& a : attributes)
      if (a.domain == Domain::vertex && a.name == position_name) return &a;
    return nullptr;
  }
  operator MeshView() const;
};

}  // namespace clers

#endif

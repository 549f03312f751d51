// Where the values of a glTF are in its buffers, and which primitives name them: what its JSON
// says, checked. Knows no bytes.
#ifndef CLERS_CODEC_GLTF_LAYOUT_H
#define CLERS_CODEC_GLTF_LAYOUT_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "codec/gltf/json.h"
#include <clers/error.h>
#include <clers/scalar.h>

namespace clers::gltf {

inline constexpr std::size_t none = static_cast<std::size_t>(-1);

/// A part of a buffer.
struct View {
  std::size_t buffer = 0;
  std::uint64_t offset = 0, length = 0;
  std::uint64_t stride = 0;  ///< 0: not said
  /// Values in it may be known by other ways than accessors: it has an extension.
  bool extended = false;
};

/// Values one stride apart: those of an accessor, or the indices or values of its sparse part.
///
///     start                 A matrix is columns, each of which begins at a multiple of 4 bytes:
///     |xyz....|xyz....|     `column` bytes from one to the next.
///      <stride>
struct Run {
  std::size_t view = none;  ///< none: there are no bytes, all values are 0
  std::size_t buffer = 0;
  std::uint64_t start = 0, stride = 0, count = 0;
  Scalar scalar = Scalar::float32;
  std::uint8_t columns = 1, rows = 1;
  std::uint32_t column = 0;

  unsigned components() const { return columns * rows; }
  std::uint64_t size() const { return (columns - 1u) * column + rows * size_of(scalar); }
  std::uint64_t end() const { return count == 0 ? start : start + (count - 1) * stride + size(); }
  bool has_bytes() const { return view != none && count > 0; }
};

struct Accessor {
  std::size_t base = 0;                       ///< of Layout::runs, as all these
  std::size_t indices = none, values = none;  ///< of the sparse part, if there is one
  std::uint64_t count = 0;
};

/// What a primitive draws (glTF 2.0, 3.7.2.1).
inline constexpr std::uint64_t mode_points = 0, mode_triangles = 4, last_mode = 6;

struct Primitive {
  struct Vertices {
    std::string name;
    std::size_t accessor;
    bool target = false;  ///< of a morph target
  };
  std::vector<Vertices> vertices;  ///< attributes, then those of morph targets
  std::size_t indices = none;
  std::uint64_t mode = mode_triangles;
  std::vector<std::size_t> other_indices;  ///< that extensions name
  bool opaque = false;  ///< an extension may name vertices in ways that are not known
  std::size_t mesh = 0;
};

struct Layout {
  std::vector<std::uint64_t> buffers;  ///< sizes
  std::vector<View> views;
  std::vector<Run> runs;
  std::vector<Accessor> accessors;
  std::vector<Primitive> primitives;
  std::vector<std::string> mesh_names;
};

/// Reads what the JSON says. `empty`: which buffers have no bytes. Errors: malformed.
Expected<Layout> read_layout(const Json& document, const std::vector<bool>& empty);

/// "accessors[3]: what"
Failure<Error> malformed(std::string where, std::size_t index, std::string what);

/// The member of that name, an array of objects; an empty one if there is none. Errors: malformed.
Expected<const std::vector<Json>*> list_of(const Json& document, const char* key);

/// Calls read, which returns what is wrong, with each of these objects. Errors: malformed.
template <class Read>
Expected<Done> read_each(const Json& document, const char* key, Read read) {
  const auto list = list_of(document, key);
  if (!list) return Failure{list.error()};
  for (std::size_t i = 0; i < (*list)->size(); ++i)
    if (std::string fault = read((**list)[i]); !fault.empty())
      return malformed(key, i, std::move(fault));
  return Done{};
}

/// An index or a size that is a member of an object; `otherwise` if there is none. Sets `fault`.
std::uint64_t member(const Json& object, const char* key, std::uint64_t otherwise,
                     std::string& fault);

}  // namespace clers::gltf

#endif

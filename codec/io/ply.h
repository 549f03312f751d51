// The parts of a PLY file before they mean anything: elements of properties, read into columns.
// Source: G. Turk, The PLY Polygon File Format, 1994.
#ifndef CLERS_CODEC_IO_PLY_H
#define CLERS_CODEC_IO_PLY_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "codec/error.h"
#include "codec/io/io.h"
#include "codec/io/text.h"
#include "codec/mesh.h"

namespace clers::io::ply {

enum class Format { text, little_endian, big_endian };

/// How values of a list are checked and stored.
enum class Meaning {
  value,        ///< as they are
  index,        ///< of a vertex, as uint32
  strip_index,  ///< the same, or `restart`
};
inline constexpr std::uint32_t restart = 0xffffffffu;

struct Property {
  std::string name;
  Scalar type = Scalar::float32;
  std::optional<Scalar> count_type;  ///< of a list
  Meaning meaning = Meaning::value;
};

/// What a comment of ours says: the properties from `first` on are one attribute.
///
///     comment clers attribute 3 my%20name
///     property float my_name
///     property float my_name_1
///     property float my_name_2
///
/// Or one list property is a corner attribute of 3 components. The name is percent-encoded. It is
/// written where the names and number of the properties alone would not say so.
struct Claim {
  std::size_t first = 0;
  unsigned components = 1;
  std::string name;
};
inline constexpr std::string_view attribute_comment = "clers attribute";
/// comment clers mesh NAME, percent-encoded.
inline constexpr std::string_view mesh_comment = "clers mesh";

std::string percent_encoded(std::string_view name);
std::optional<std::string> percent_decoded(std::string_view text);

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
  std::vector<Claim> claims;
};

struct Header {
  Format format = Format::text;
  std::vector<Element> elements;  ///< "vertex" is one of them
  Comments comments, obj_infos;   ///< comments that are not ours
  std::string mesh_name;
  std::size_t size = 0;  ///< the body begins here

  static constexpr std::uint64_t vertex_limit = 0xffffffffu;
  std::uint32_t vertex_count() const;  ///< below vertex_limit
};

/// Errors: malformed at a line; too_large if there are more vertices than ids.
Expected<Header> read_header(std::string_view file);

/// The values of one property over all entries, packed, in native byte order.
struct Column {
  std::vector<std::byte> values;
  std::vector<std::uint32_t> sizes;  ///< of each list; empty for a scalar
};

/// Reads the elements of a body one after the other.
class Body {
 public:
  Body(std::string_view file, const Header& header)
      : file_(file),
        format_(header.format),
        vertex_count_(header.vertex_count()),
        at_(header.size) {}

  /// The columns of the next element, one for each property. Memory: before anything is allocated
  /// the element's count is checked against the bytes that are left.
  /// Errors: malformed, at a line of a text body and at a byte of a binary one.
  Expected<std::vector<Column>> next(const Element& element);

  /// After the last element. Errors: malformed if a text goes on.
  Expected<Done> end(Notes& notes) const;

 private:
  std::string_view file_;
  Format format_;
  std::uint32_t vertex_count_;
  std::size_t at_;
};

/// Properties that make one attribute together.
struct Convention {
  std::string_view attribute;
  unsigned components;
  std::array<std::string_view, 4> properties;

  std::span<const std::string_view> names() const { return {properties.data(), components}; }
};
/// Reading takes the first line for an attribute that the file has all properties of, of one type;
/// writing the first with as many components, unless metadata say what they were called.
inline constexpr Convention conventions[] = {
    {position_name, 3, {"x", "y", "z"}},
    {"normal", 3, {"nx", "ny", "nz"}},
    {"texcoord", 2, {"s", "t"}},
    {"texcoord", 2, {"u", "v"}},
    {"texcoord", 2, {"texture_u", "texture_v"}},
    {"color", 4, {"red", "green", "blue", "alpha"}},
    {"color", 3, {"red", "green", "blue"}},
};

/// The convention that writing goes by, or nullptr.
const Convention* convention_of(std::string_view attribute, std::size_t components);

/// Whether a list of faces is known to hold values of their corners: those of VCG and MeshLab.
/// Lengths say nothing: the normal of a triangle has three numbers too.
bool lies_by_corner(const Element& element, const Property& property);

/// Properties that become one attribute.
struct Entry {
  std::string attribute;
  Domain domain = Domain::vertex;
  std::vector<std::size_t> members;  ///< properties, in the order of the components; one list
  unsigned claimed = 0;              ///< components, if a claim says so
};
/// What becomes of the properties of an element of vertices or faces, in the order of the first
/// ones: claims, then conventions, then each property by itself. Names of attributes differ within
/// a domain, and are UTF-8 of at most 255 bytes.
std::vector<Entry> plan(const Element& element);

/// What properties are called where plan() alone would not say so. As metadata a line each, words
/// percent-encoded:
///
///     vertex texcoord u v         face, corner: likewise
///     face-list normal normal     one list as long as the attribute has components
///     vertex-lists ring ring 7    lists of up to 7 numbers, which are attributes "ring.0" to
///                                 "ring.6"; face-lists: likewise
///     indices vertex_index        of the faces
class PropertyNames {
 public:
  enum class Form : std::uint8_t { scalars, list, lists };
  struct Line {
    Domain domain = Domain::vertex;
    Form form = Form::scalars;
    std::string attribute;
    std::vector<std::string> properties;
  };

  static PropertyNames of(const Mesh& mesh);
  std::string text() const;

  void add(Line line);
  const Line* find(const Attribute& a) const;
  const std::vector<Line>& lines() const { return lines_; }

  std::string indices;

 private:
  using Key = std::pair<Domain, std::string>;
  std::vector<Line> lines_;
  std::map<Key, std::size_t> by_attribute_;
};

/// The attribute that holds number i of lists whose lengths differ.
inline std::string part_of_lists(std::string_view attribute, std::size_t i) {
  return std::string(attribute) + '.' + std::to_string(i);
}

inline constexpr std::string_view usual_indices = "vertex_indices";

/// The list of a face's or a strip's vertices.
constexpr bool names_indices(std::string_view property) {
  return property == "vertex_indices" || property == "vertex_index";
}

}  // namespace clers::io::ply

#endif

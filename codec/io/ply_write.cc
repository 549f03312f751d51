#include <algorithm>
#include <cstring>
#include <set>

#include "codec/io/formats.h"
#include "codec/io/numbers.h"
#include "codec/io/ply.h"

namespace clers::io {

namespace {

using namespace ply;

constexpr std::string_view type_name(Scalar s) {
  constexpr std::string_view names[scalar_count] = {"char", "uchar", "short", "ushort", "int",
                                                    "uint", {},      {},      "float",  "double"};
  return names[static_cast<unsigned>(s)];
}

// An attribute and the properties it becomes.
struct Planned {
  const Attribute* attribute;
  std::vector<std::string> properties;  // one for each component; one list for a corner attribute
  bool claim = false;                   // whether a comment has to say what they are
};

const Convention* convention_of(const Attribute& a) {
  for (const Convention& c : conventions)
    if (c.attribute == a.name && c.components == a.components) return &c;
  return nullptr;
}

bool is_conventional_property(std::string_view name) {
  for (const Convention& c : conventions)
    for (const std::string_view property : c.names())
      if (name == property) return true;
  return names_indices(name);
}

// A name of an attribute -> one that can stand in a header.
std::string as_property(std::string_view name) {
  std::string property;
  for (const char c : name) property += c > ' ' && c <= '~' ? c : '_';
  if (property.empty() || is_conventional_property(property)) property += '_';
  return property;
}

// Properties for the attributes of one element.
std::vector<Planned> plan(const Mesh& mesh, bool of_vertices, Notes& notes) {
  std::vector<Planned> planned;
  std::set<std::string> used;
  for (const Attribute& a : mesh.attributes) {
    if ((a.domain == Domain::vertex) != of_vertices) continue;
    if (type_name(a.scalar).empty()) {
      note_left_out(notes, a, "PLY has no 64-bit integers");
      continue;
    }
    Planned p{&a, {}, false};
    const Convention* convention = a.domain == Domain::corner ? nullptr : convention_of(a);
    if (convention) {
      p.properties.assign(convention->names().begin(), convention->names().end());
    } else {
      const unsigned n = a.domain == Domain::corner ? 1 : a.components;
      const auto name_them = [&](const std::string& base) {
        p.properties = {base};
        for (unsigned i = 1; i < n; ++i) p.properties.push_back(base + "_" + std::to_string(i));
        return std::none_of(p.properties.begin(), p.properties.end(),
                            [&](const std::string& name) { return used.contains(name); });
      };
      if (std::string base = as_property(a.name); !name_them(base))
        for (base.append("_").append(std::to_string(planned.size())); !name_them(base);)
          base += '_';
      const bool clear_components = a.domain == Domain::corner ? !a.data.empty() : n == 1;
      p.claim = p.properties[0] != a.name || (!clear_components && a.components != 1);
    }
    used.insert(p.properties.begin(), p.properties.end());
    planned.push_back(std::move(p));
  }
  return planned;
}

// The values of an element's entries, one after the other.
class BodyWriter {
 public:
  BodyWriter(Encoding encoding, Output& out) : text_(encoding == Encoding::text), out_(out) {}

  void value(const Attribute& a, std::size_t index) {
    if (text_) {
      separate();
      print(out_, a, index);
      return;
    }
    const std::byte* from = a.data.data() + index * size_of(a.scalar);
    switch (size_of(a.scalar)) {
      case 1: return out_.append(from, 1);
      case 2: return little<std::uint16_t>(from);
      case 4: return little<std::uint32_t>(from);
      default: return little<std::uint64_t>(from);
    }
  }
  void size(std::uint64_t n, Scalar type) {
    if (!text_) return type == Scalar::uint8 ? out_.little(static_cast<std::uint8_t>(n)) : index(n);
    separate();
    out_.number(n);
  }
  void index(std::uint64_t n) {
    if (!text_) return out_.little(static_cast<std::uint32_t>(n));
    separate();
    out_.number(n);
  }
  void end_entry() {
    if (text_) out_ << '\n';
    first_ = true;
  }

 private:
  void separate() {
    if (!first_) out_ << ' ';
    first_ = false;
  }
  template <class T>
  void little(const std::byte* from) {
    T bits;
    std::memcpy(&bits, from, sizeof bits);
    out_.little(bits);
  }

  bool text_;
  Output& out_;
  bool first_ = true;
};

class Writer {
 public:
  Writer(const Mesh& mesh, Encoding encoding, Output& out, Notes& notes)
      : mesh_(mesh),
        encoding_(encoding),
        out_(out),
        vertex_(plan(mesh, true, notes)),
        face_(plan(mesh, false, notes)) {}

  Expected<Done> write() {
    if (mesh_.vertex_count > 0 && vertex_.empty())
      return fail(
          ErrorCode::unsupported,
          "expected the vertices to have an attribute that PLY can hold, such as positions");
    std::uint64_t longest = 0;
    for (std::size_t f = 0; f < mesh_.face_count(); ++f)
      longest = std::max<std::uint64_t>(longest, face_size(mesh_, f));
    for (const Planned& p : face_)
      if (p.attribute->domain == Domain::corner)
        longest = std::max(longest, longest * p.attribute->components);
    if (longest > 0xffffffffu)
      return fail(ErrorCode::too_large, "expected lists of fewer than 2^32 values");
    count_type_ = longest <= 255 ? Scalar::uint8 : Scalar::uint32;
    header();
    vertices();
    faces();
    return Done{};
  }

 private:
  void header() {
    out_ << "ply\nformat " << (encoding_ == Encoding::text ? "ascii" : "binary_little_endian")
         << " 1.0\n";
    if (!mesh_.name.empty())
      out_ << "comment " << mesh_comment << ' ' << percent_encoded(mesh_.name) << '\n';
    out_ << "element vertex ";
    out_.number(mesh_.vertex_count);
    out_ << '\n';
    properties(vertex_);
    out_ << "element face ";
    out_.number(mesh_.face_count());
    // int, if it can be, because that is what every program reads.
    index_type_ = mesh_.vertex_count <= 0x80000000u ? Scalar::int32 : Scalar::uint32;
    out_ << "\nproperty list " << type_name(count_type_) << ' ' << type_name(index_type_)
         << " vertex_indices\n";
    properties(face_);
    out_ << "end_header\n";
  }

  void properties(const std::vector<Planned>& planned) {
    for (const Planned& p : planned) {
      const Attribute& a = *p.attribute;
      if (p.claim) {
        out_ << "comment " << attribute_comment << ' ';
        out_.number(static_cast<unsigned>(a.components));
        out_ << ' ' << percent_encoded(a.name) << '\n';
      }
      for (const std::string& name : p.properties) {
        out_ << "property ";
        if (a.domain == Domain::corner) out_ << "list " << type_name(count_type_) << ' ';
        out_ << type_name(a.scalar) << ' ' << name << '\n';
      }
    }
  }

  void vertices() {
    BodyWriter body(encoding_, out_);
    for (std::size_t v = 0; v < mesh_.vertex_count; ++v) {
      for (const Planned& p : vertex_) values(body, *p.attribute, v, 1);
      body.end_entry();
    }
  }

  void faces() {
    BodyWriter body(encoding_, out_);
    std::size_t corner = 0;
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      const std::uint32_t size = face_size(mesh_, f);
      body.size(size, count_type_);
      for (std::size_t i = 0; i < size; ++i) body.index(mesh_.corners[corner + i]);
      for (const Planned& p : face_) {
        const Attribute& a = *p.attribute;
        if (a.domain == Domain::corner) {
          body.size(std::uint64_t{size} * a.components, count_type_);
          values(body, a, corner, size);
        } else {
          values(body, a, f, 1);
        }
      }
      corner += size;
      body.end_entry();
    }
  }

  static void values(BodyWriter& body, const Attribute& a, std::size_t first, std::size_t count) {
    for (std::size_t i = first * a.components; i < (first + count) * a.components; ++i)
      body.value(a, i);
  }

  const Mesh& mesh_;
  Encoding encoding_;
  Output& out_;
  std::vector<Planned> vertex_, face_;
  Scalar count_type_ = Scalar::uint8, index_type_ = Scalar::int32;
};

}  // namespace

Expected<Done> write_ply(const Mesh& mesh, Encoding encoding, Output& out, Notes& notes) {
  if (encoding == Encoding::text)
    for (const Attribute& a : mesh.attributes) note_lost_nans(notes, a);
  return Writer(mesh, encoding, out, notes).write();
}

}  // namespace clers::io

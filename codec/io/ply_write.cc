// Writes PLY.
#include <algorithm>
#include <cstring>
#include <map>
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
  std::vector<const Attribute*> parts = {};  // or these, and all are one list
  std::vector<std::string> properties;       // one for each component, or one list
  bool list = false;
  bool claim = false;       // whether a comment has to say what they are
  std::uint64_t zeros = 0;  // written for values that are missing
};

// A name of an attribute -> one that can stand in a header.
std::string as_property(std::string_view name) {
  std::string property;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    property += byte > ' ' && byte != 0x7f ? c : '_';
  }
  if (property.empty() || property.starts_with("\xef\xbb\xbf")) property.insert(0, "_");
  return property;
}

bool has_values(const Attribute& a) {
  return a.indices.empty() ? !a.data.empty()
                           : std::any_of(a.indices.begin(), a.indices.end(),
                                         [](std::uint32_t i) { return i != no_value; });
}

// Plans the properties of an element.
class Planner {
 public:
  Planner(const Mesh& mesh, const PropertyNames& names, bool of_vertices)
      : mesh_(mesh), names_(names), of_vertices_(of_vertices) {}

  std::vector<Planned> run(const std::string& indices, Notes& notes) {
    if (!of_vertices_) used_.insert(indices);
    for (const PropertyNames::Line& line : names_.lines())
      if (line.form == PropertyNames::Form::lists &&
          (line.domain == Domain::vertex) == of_vertices_)
        plan_lists(line);
    std::uint64_t wide = 0;
    std::set<std::string> wide_names;
    for (const Attribute& a : mesh_.attributes) {
      if ((a.domain == Domain::vertex) != of_vertices_) continue;
      if (type_name(a.scalar).empty()) {
        ++wide;
        wide_names.insert(a.name);
        continue;
      }
      if (const auto list = lists_.find(&a); list != lists_.end()) planned_.push_back(list->second);
      if (parts_.contains(&a)) continue;
      planned_.push_back(named(a, names_.find(a)));
    }
    note_left_out(notes, wide, of_vertices_ ? "vertex attribute" : "face or corner attribute",
                  of_vertices_ ? "vertex attributes" : "face or corner attributes",
                  "PLY has no 64-bit integers: " + some(wide_names));
    while (claim_what_reads_otherwise(indices)) {
    }
    return std::move(planned_);
  }

 private:
  // Lists whose lengths differ: parts that some elements have no value of have none of those after.
  void plan_lists(const PropertyNames::Line& line) {
    if (line.properties.size() != 2) return;
    const std::string& property = line.properties[0];
    std::vector<const Attribute*> parts;
    while (const Attribute* a =
               find(mesh_, part_of_lists(line.attribute, parts.size()), line.domain)) {
      if (a->components != 1 || type_name(a->scalar).empty() || parts.size() == 255 ||
          parts_.contains(a) || (!parts.empty() && a->scalar != parts[0]->scalar))
        return;
      const auto goes_on = [&](std::size_t e) {
        return a->indices.empty() || a->indices[e] != no_value;
      };
      if (!parts.empty() && !parts.back()->indices.empty())
        for (std::size_t e = 0; e < parts.back()->indices.size(); ++e)
          if (parts.back()->indices[e] == no_value && goes_on(e)) return;
      parts.push_back(a);
    }
    // The others would be left over, and lists of one length read back as something else.
    if (parts.empty() || std::to_string(parts.size()) != line.properties[1] ||
        parts.back()->indices.empty() || as_property(property) != property ||
        !used_.insert(property).second)
      return;
    parts_.insert(parts.begin(), parts.end());
    lists_.insert({parts[0], {parts[0], parts, {property}, true}});
  }

  Planned named(const Attribute& a, const PropertyNames::Line* line) {
    const bool corner = a.domain == Domain::corner;
    const std::size_t count = corner ? 1 : a.components;
    if (line && can_be(*line, a)) {
      used_.insert(line->properties.begin(), line->properties.end());
      return {&a, {}, line->properties, line->form == PropertyNames::Form::list};
    }
    Planned p{&a, {}, {}, corner};
    const auto free = [&] {
      return std::none_of(p.properties.begin(), p.properties.end(),
                          [&](const std::string& name) { return used_.contains(name); });
    };
    if (const Convention* convention = corner ? nullptr : convention_of(a.name, count))
      p.properties.assign(convention->names().begin(), convention->names().end());
    if (p.properties.empty() || !free()) {
      const auto name_them = [&](const std::string& base) {
        p.properties = {base};
        for (std::size_t i = 1; i < count; ++i)
          p.properties.push_back(base + "_" + std::to_string(i));
        return free();
      };
      if (std::string base = as_property(a.name); !name_them(base))
        for (base.append("_").append(std::to_string(planned_.size())); !name_them(base);)
          base += '_';
    }
    used_.insert(p.properties.begin(), p.properties.end());
    return p;
  }

  // Metadata may come from anywhere.
  bool can_be(const PropertyNames::Line& line, const Attribute& a) const {
    const bool corner = a.domain == Domain::corner;
    // Without entries a list would not say how many components there are.
    const bool list = line.form == PropertyNames::Form::list;
    if (line.form == PropertyNames::Form::lists) return false;
    if (list && !corner && a.data.empty()) return false;
    if (line.properties.size() != (list ? 1u : std::size_t{a.components})) return false;
    std::set<std::string> own;
    return std::all_of(line.properties.begin(), line.properties.end(), [&](const std::string& p) {
      return as_property(p) == p && !used_.contains(p) && own.insert(p).second;
    });
  }

  // Reads the header as it would be, and claims what would become other attributes.
  bool claim_what_reads_otherwise(const std::string& indices) {
    Element element;
    element.name = of_vertices_ ? "vertex" : "face";
    if (!of_vertices_)
      element.properties.push_back({indices, Scalar::int32, Scalar::uint8, Meaning::index});
    std::vector<std::size_t> first;
    for (const Planned& p : planned_) {
      first.push_back(element.properties.size());
      if (p.claim)
        element.claims.push_back({first.back(), p.attribute->components, p.attribute->name});
      for (const std::string& name : p.properties)
        element.properties.push_back({name, p.attribute->scalar,
                                      p.list ? std::optional(Scalar::uint8) : std::nullopt,
                                      Meaning::value});
    }
    const std::vector<Entry> entries = plan(element);
    std::map<std::size_t, const Entry*> at;
    for (const Entry& e : entries) at[e.members[0]] = &e;
    bool changed = false;
    for (std::size_t i = 0; i < planned_.size(); ++i) {
      Planned& p = planned_[i];
      if (p.claim || !p.parts.empty()) continue;
      const Attribute& a = *p.attribute;
      const auto found = at.find(first[i]);
      const bool same_members =
          found != at.end() && found->second->members.size() == p.properties.size();
      bool right =
          same_members && found->second->attribute == a.name && found->second->domain == a.domain;
      for (std::size_t k = 0; right && k < p.properties.size(); ++k)
        right = found->second->members[k] == first[i] + k;
      // Lists of the known names still have to be of as many values as are known.
      if (right && a.domain == Domain::corner)
        right = has_values(a) && a.components >= 2 && a.components <= 4;
      if (right) continue;
      changed = true;
      if (p.list && a.domain != Domain::corner) {  // a claim would make it a corner attribute
        p = named(a, nullptr);
      } else {
        p.claim = true;
      }
    }
    return changed;
  }

  const Mesh& mesh_;
  const PropertyNames& names_;
  bool of_vertices_;
  std::set<std::string> used_;
  std::map<const Attribute*, Planned> lists_;  // by their first parts
  std::set<const Attribute*> parts_;
  std::vector<Planned> planned_;
};

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
        names_(PropertyNames::of(mesh)),
        indices_(names_indices(names_.indices) ? names_.indices : std::string(usual_indices)),
        vertex_(Planner(mesh, names_, true).run(indices_, notes)),
        face_(Planner(mesh, names_, false).run(indices_, notes)),
        notes_(notes) {}

  Expected<Done> write() {
    if (mesh_.vertex_count > 0 && vertex_.empty())
      return fail(
          ErrorCode::unsupported,
          "expected the vertices to have an attribute that PLY can hold, such as positions");
    std::uint64_t longest = 0, longest_value = 0;
    for (std::size_t f = 0; f < mesh_.face_count(); ++f)
      longest = std::max<std::uint64_t>(longest, face_size(mesh_, f));
    for (const Planned& p : face_)
      if (p.attribute->domain == Domain::corner)
        longest_value = std::max(longest_value, longest * p.attribute->components);
    longest = std::max(longest, longest_value);
    if (longest > 0xffffffffu)
      return fail(ErrorCode::too_large, "expected lists of fewer than 2^32 values");
    count_type_ = longest <= 255 ? Scalar::uint8 : Scalar::uint32;
    header();
    vertices();
    faces();
    for (const std::vector<Planned>* planned : {&vertex_, &face_})
      for (const Planned& p : *planned) note_zeros(notes_, *p.attribute, p.zeros);
    return Done{};
  }

 private:
  void header() {
    out_ << "ply\nformat " << (encoding_ == Encoding::text ? "ascii" : "binary_little_endian")
         << " 1.0\n";
    if (!mesh_.name.empty())
      out_ << "comment " << mesh_comment << ' ' << percent_encoded(mesh_.name) << '\n';
    foreign_lines();
    out_ << "element vertex ";
    out_.number(mesh_.vertex_count);
    out_ << '\n';
    properties(vertex_);
    out_ << "element face ";
    out_.number(mesh_.face_count());
    // int, if it can be, because that is what every program reads.
    index_type_ = mesh_.vertex_count <= 0x80000000u ? Scalar::int32 : Scalar::uint32;
    out_ << "\nproperty list " << type_name(count_type_) << ' ' << type_name(index_type_) << ' '
         << indices_ << '\n';
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
        if (p.list) out_ << "list " << type_name(count_type_) << ' ';
        out_ << type_name(a.scalar) << ' ' << name << '\n';
      }
    }
  }

  void vertices() {
    BodyWriter body(encoding_, out_);
    for (std::size_t v = 0; v < mesh_.vertex_count; ++v) {
      for (Planned& p : vertex_) values(body, p, v, 1);
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
      for (Planned& p : face_) {
        const bool corners = p.attribute->domain == Domain::corner;
        values(body, p, corners ? corner : f, corners ? size : 1);
      }
      corner += size;
      body.end_entry();
    }
  }

  void values(BodyWriter& body, Planned& p, std::size_t first, std::size_t count) {
    if (!p.parts.empty()) return list(body, p.parts, first);
    const Attribute& a = *p.attribute;
    if (!a.indices.empty()) {
      const auto from = a.indices.begin() + static_cast<std::ptrdiff_t>(first);
      const auto none = static_cast<std::size_t>(
          std::count(from, from + static_cast<std::ptrdiff_t>(count), no_value));
      // A list of the corners of a face may be empty.
      if (a.domain == Domain::corner && none == count) count = 0;
      p.zeros += count == 0 ? 0 : none;
    }
    if (p.list) body.size(std::uint64_t{count} * a.components, count_type_);
    for (std::size_t i = first * a.components; i < (first + count) * a.components; ++i)
      body.value(a, i);
  }

  void list(BodyWriter& body, std::span<const Attribute* const> parts, std::size_t element) {
    std::size_t size = 0;
    while (size < parts.size() &&
           (parts[size]->indices.empty() || parts[size]->indices[element] != no_value))
      ++size;
    body.size(size, count_type_);
    for (const Attribute* a : parts.first(size)) body.value(*a, element);
  }

  // The comments and more of other programs.
  void foreign_lines() {
    std::uint64_t ours = 0;
    for_each_line(mesh_, comment_key, [&](std::string_view line) {
      // One that reads like ours would be taken for it.
      if (Text words(line); words.token() == "clers" && words.token() == "mesh")
        ++ours;
      else
        write_line("comment", line);
    });
    note_left_out(notes_, ours, "comment", "comments", "it would name the mesh");
    for_each_line(mesh_, obj_info_key,
                  [&](std::string_view line) { write_line("obj_info", line); });
    note_metadata_left_out(notes_, mesh_, {comment_key, obj_info_key, properties_key});
  }

  void write_line(std::string_view keyword, std::string_view line) {
    out_ << keyword;
    if (!line.empty() && line[0] != ' ' && line[0] != '\t') out_ << ' ';
    for (const char c : line) out_ << (c == '\r' ? ' ' : c);
    out_ << '\n';
  }

  const Mesh& mesh_;
  Encoding encoding_;
  Output& out_;
  PropertyNames names_;
  std::string indices_;
  std::vector<Planned> vertex_, face_;
  Notes& notes_;
  Scalar count_type_ = Scalar::uint8, index_type_ = Scalar::int32;
};

}  // namespace

Expected<Done> write_ply(const Mesh& mesh, Encoding encoding, Output& out, Notes& notes) {
  if (encoding == Encoding::text)
    for (const Attribute& a : mesh.attributes) note_lost_nans(notes, a);
  return Writer(mesh, encoding, out, notes).write();
}

}  // namespace clers::io

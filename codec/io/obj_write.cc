// Writes OBJ.
#include <cstring>
#include <optional>

#include "codec/io/formats.h"
#include "codec/io/numbers.h"
#include "codec/io/obj_states.h"
#include "codec/io/weld.h"

namespace clers::io {

namespace {

// Whether colours are 255ths all, which is how bytes are written.
bool reads_back_as_bytes(const Attribute& color) {
  if (!is_float(color.scalar) || color.data.empty()) return false;
  if (color.scalar == Scalar::float32) return of_255ths(color).scalar == Scalar::uint8;
  Attribute narrow{color.name, color.domain, Scalar::float32, color.components, {}};
  for (std::size_t i = 0; i < color.data.size(); i += sizeof(double)) {
    double wide;
    std::memcpy(&wide, color.data.data() + i, sizeof wide);
    const auto value = static_cast<float>(wide);
    if (static_cast<double>(value) != wide) return false;
    const auto* bytes = reinterpret_cast<const std::byte*>(&value);
    narrow.data.insert(narrow.data.end(), bytes, bytes + sizeof value);
  }
  return of_255ths(std::move(narrow)).scalar == Scalar::uint8;
}

// What the corners of a mesh use of a kind of value, vt or vn.
struct ByCorner {
  std::string_view statement;
  const Attribute* attribute = nullptr;
  Welded welded = {};         // of a corner attribute: equal values are written once
  std::uint64_t written = 0;  // in this file, by the meshes before

  bool welds() const { return attribute->domain == Domain::corner && attribute->indices.empty(); }
  std::size_t count() const {
    return !attribute ? 0 : welds() ? welded.first.size() : attribute->value_count();
  }
  /// What stands behind the slash; none: nothing.
  std::optional<std::uint64_t> index(std::size_t corner, std::uint32_t vertex) const {
    if (!attribute) return std::nullopt;
    const std::size_t element = attribute->domain == Domain::corner ? corner : vertex;
    const std::size_t value = welds()                      ? welded.number[corner]
                              : attribute->indices.empty() ? element
                                                           : attribute->indices[element];
    return value == no_value ? std::nullopt : std::optional(1 + written + value);
  }
};

class Writer {
 public:
  Writer(Output& out, Notes& notes) : out_(out), notes_(notes) {}

  Expected<Done> write(const Mesh& mesh, bool named) {
    const Attribute* position = mesh.position();
    if (mesh.vertex_count > 0 && (!position || position->components != 3))
      return fail(ErrorCode::unsupported, "expected positions with 3 components");
    const Attribute* color = find(mesh, "color", Domain::vertex);
    if (color && (!(is_float(color->scalar) || color->scalar == Scalar::uint8) ||
                  (color->components != 3 && color->components != 4)))
      color = nullptr;
    const Attribute* const kept_color = color;
    Attribute floats;
    if (color && color->scalar == Scalar::uint8) color = &(floats = as_255ths(*color));
    texcoords_.attribute = by_corner(mesh, "texcoord", 1, 3);
    normals_.attribute = by_corner(mesh, "normal", 3, 3);
    ObjFaces states(mesh);
    for (const Attribute& a : mesh.attributes) {
      if (states.says(a)) continue;
      if (&a == position || &a == kept_color || &a == texcoords_.attribute ||
          &a == normals_.attribute)
        note_kept(a);
      else
        note_left_out(notes_, a);
    }

    if (kept_color && reads_back_as_bytes(*kept_color))
      note_remark(notes_, 1, label(*color), "is all 255ths and reads back as bytes");
    note_metadata_left_out(notes_, mesh,
                           {comment_key, obj_libraries_key, obj_states[0].key, obj_states[1].key,
                            obj_states[2].key, obj_states[3].key});

    write_comments(out_, mesh);
    for_each_line(mesh, obj_libraries_key,
                  [&](std::string_view names) { out_ << "mtllib " << names << '\n'; });
    if (named) out_ << "o " << one_line(mesh.name) << '\n';
    for (std::size_t v = 0; v < mesh.vertex_count; ++v) {
      out_ << 'v';
      values(*position, v);
      if (color && color->indices.empty())
        values(*color, v);
      else if (color && color->indices[v] != no_value)
        values(*color, color->indices[v]);
      out_ << '\n';
    }
    for (ByCorner* kind : {&texcoords_, &normals_}) begin(*kind);
    faces(mesh, states);
    for (ByCorner* kind : {&texcoords_, &normals_}) kind->written += kind->count();
    vertices_written_ += mesh.vertex_count;
    return Done{};
  }

 private:
  static const Attribute* by_corner(const Mesh& mesh, std::string_view name, unsigned least,
                                    unsigned most) {
    for (const Domain domain : {Domain::corner, Domain::vertex})
      if (const Attribute* a = find(mesh, name, domain);
          a && is_float(a->scalar) && a->components >= least && a->components <= most)
        return a;
    return nullptr;
  }

  void note_kept(const Attribute& a) {
    note_lost_nans(notes_, a);
    if (!is_float(a.scalar) && a.name != "color")
      note_remark(notes_, 1, label(a), "reads back as floating point");
    if (a.domain == Domain::vertex && a.name != position_name && a.name != "color")
      note_remark(notes_, 1, label(a), "is written by corner");
  }

  void values(const Attribute& a, std::size_t index) {
    for (std::size_t i = index * a.components; i < (index + 1) * a.components; ++i) {
      out_ << ' ';
      print_untyped(out_, a, i);
    }
  }

  void begin(ByCorner& kind) {
    if (!kind.attribute) return;
    const Attribute& a = *kind.attribute;
    if (kind.welds()) kind.welded = weld(a.data, a.stride());
    for (std::size_t i = 0; i < kind.count(); ++i) {
      out_ << kind.statement;
      values(a, kind.welds() ? kind.welded.first[i] : i);
      out_ << '\n';
    }
  }

  void faces(const Mesh& mesh, ObjFaces& states) {
    std::size_t empty = 0;
    const auto face = [&](std::size_t f, std::size_t corner) {
      const std::uint32_t size = face_size(mesh, f);
      empty += size == 0;
      if (size == 0) return;
      states.begin(out_, f);
      out_ << 'f';
      for (const std::size_t end = corner + size; corner < end; ++corner) {
        const std::uint32_t v = mesh.corners[corner];
        out_ << ' ';
        out_.number(1 + vertices_written_ + v);
        const auto texcoord = texcoords_.index(corner, v), normal = normals_.index(corner, v);
        if (texcoord || normal) out_ << '/';
        if (texcoord) out_.number(*texcoord);
        if (!normal) continue;
        out_ << '/';
        out_.number(*normal);
      }
      out_ << '\n';
    };
    if (states.order().empty()) {
      std::size_t corner = 0;
      for (std::size_t f = 0; f < mesh.face_count(); corner += face_size(mesh, f++))
        face(f, corner);
    } else {
      note_remark(notes_, mesh.face_count(), counted(mesh.face_count(), "face", "faces"),
                  "were put together by what their statements say");
      std::vector<std::size_t> begins(mesh.face_count());
      for (std::size_t f = 1; f < begins.size(); ++f)
        begins[f] = begins[f - 1] + face_size(mesh, f - 1);
      for (const std::uint32_t f : states.order()) face(f, begins[f]);
    }
    states.end(out_);
    note_left_out(notes_, empty, "face without corners", "faces without corners");
  }

  // A name must not begin a new statement.
  static std::string one_line(std::string name) {
    for (char& c : name)
      if (c == '\n' || c == '\r') c = ' ';
    return name;
  }

  Output& out_;
  Notes& notes_;
  std::uint64_t vertices_written_ = 0;
  ByCorner texcoords_{"vt"}, normals_{"vn"};
};

}  // namespace

Expected<Done> write_obj(std::span<const Mesh> meshes, Output& out, Notes& notes) {
  Writer writer(out, notes);
  for (const Mesh& mesh : meshes)
    if (Expected<Done> done = writer.write(mesh, meshes.size() > 1 || !mesh.name.empty()); !done)
      return done;
  if (meshes.size() > 1)
    note_remark(notes, meshes.size(), std::to_string(meshes.size()) + " meshes",
                "became objects of one file, which reads back as one mesh");
  // A file of no bytes is taken for a failed download.
  if (out.empty()) out << '\n';
  return Done{};
}

}  // namespace clers::io

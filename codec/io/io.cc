// The door of codec/io: which reader or writer, and what holds of all.
#include "codec/io/io.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "codec/base/by_element.h"
#include "codec/base/guarded.h"
#include "codec/base/kind_defect.h"
#include "codec/base/utf8.h"
#include "codec/io/formats.h"
#include "codec/io/numbers.h"

namespace clers {
namespace CLERS_VISIBLE io {

namespace {

// What metadata call the formats of files.
struct SourceName {
  std::string_view name;
  Source source;
};
constexpr SourceName source_names[] = {
    {"ply ascii", {Format::ply, Encoding::text}},
    {"ply binary_little_endian", {Format::ply, Encoding::binary}},
    {"ply binary_big_endian", {Format::ply, Encoding::binary}},
    {"obj", {Format::obj, Encoding::text}},
    {"off", {Format::off, Encoding::text}},
    {"stl ascii", {Format::stl, Encoding::text}},
    {"stl binary", {Format::stl, Encoding::binary}},
};

// What every writer relies on.
Expected<Done> check(const Mesh& mesh, std::size_t number) {
  const auto inconsistent = [&](std::string what) {
    return fail(ErrorCode::inconsistent_mesh, Place::mesh, number, std::move(what));
  };
  std::uint64_t corners = 0;
  for (const std::uint32_t size : mesh.face_sizes) corners += size;
  if (mesh.triangles_only() ? mesh.corners.size() % 3 != 0 : corners != mesh.corners.size())
    return inconsistent("expected as many corners as the faces' sizes add up to");
  if (mesh.vertex_count == 0xffffffffu)
    return inconsistent("expected fewer than 2^32 - 1 vertices");
  for (const std::uint32_t v : mesh.corners)
    if (v >= mesh.vertex_count)
      return inconsistent("expected vertex indices below " + std::to_string(mesh.vertex_count) +
                          ", found " + std::to_string(v));
  const std::size_t counts[] = {mesh.vertex_count, mesh.corners.size(), mesh.face_count()};
  std::set<std::pair<Domain, std::string_view>> names;
  for (const Attribute& a : mesh.attributes) {
    if (const std::string defect = internal::kind_defect(a); !defect.empty())
      return inconsistent("attribute " + quoted(a.name) + " has " + defect);
    const std::size_t count = counts[static_cast<unsigned>(a.domain)];
    if (!a.indices.empty() || (count == 0 && !a.data.empty())) {
      if (a.indices.size() != count || a.data.size() % a.stride() != 0)
        return inconsistent("expected " + label(a) + " to have " + std::to_string(count) +
                            " indices of whole values");
      for (const std::uint32_t i : a.indices)
        if (i != no_value && i >= a.value_count())
          return inconsistent("expected " + label(a) + " to have indices below " +
                              std::to_string(a.value_count()) + ", found " + std::to_string(i));
    } else if (a.data.size() != count * a.stride())
      return inconsistent("expected " + label(a) + " to have " +
                          std::to_string(count * a.stride()) + " bytes, found " +
                          std::to_string(a.data.size()));
    if (!names.insert({a.domain, a.name}).second)
      return inconsistent("a second " + std::string(name(a.domain)) + " attribute " +
                          quoted(a.name));
  }
  return Done{};
}

// What formats without indices write.
Mesh without_sharing(const Mesh& mesh) {
  Mesh result = mesh;
  for (Attribute& a : result.attributes) a = expanded(a);
  return result;
}

template <class Read>
Expected<ReadResult> read_text(std::string_view file, Read read) {
  const std::string_view text = without_padding(file);
  Expected<ReadResult> result = read(text);
  if (result) note_padding(result->notes, file.size() - text.size());
  return result;
}

// Mesh files say nothing of their encoding: what is no UTF-8 is taken as Latin-1.
void make_utf8(std::string& name, Notes& notes) {
  if (internal::is_utf8(name)) return;
  name = utf8_of_latin_1(name);
  note_remark(notes, 1, "the name " + quoted(name), "is not UTF-8 and was read as Latin-1");
}

Expected<ReadResult> read_as(std::span<const std::byte> bytes, Format format) {
  switch (format) {
    case Format::ply: return read_ply(as_text(bytes));
    case Format::obj: return read_text(as_text(bytes), read_obj);
    case Format::off: return read_text(as_text(bytes), read_off);
    case Format::stl: return read_stl(as_text(bytes));
  }
  return fail(ErrorCode::unsupported, "expected a known format");
}

}  // namespace

std::optional<Format> format_of(std::string_view name) {
  std::string extension(name.substr(name.rfind('.') + 1));  // npos + 1 = 0: all of it
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == "ply") return Format::ply;
  if (extension == "obj") return Format::obj;
  if (extension == "off") return Format::off;
  if (extension == "stl") return Format::stl;
  return std::nullopt;
}

Expected<ReadResult> read(std::span<const std::byte> bytes, Format format) {
  return internal::guarded("read", [&]() -> Expected<ReadResult> {
    // An OBJ of no statements may be a mesh, one of no bytes is what a failed download leaves.
    if (format == Format::obj && bytes.empty())
      return fail(ErrorCode::malformed, Place::byte, 0, "the file is empty");
    Expected<ReadResult> result = read_as(bytes, format);
    // Only now: the header of a binary STL may begin like anything.
    if (!result)
      if (const std::optional<std::string> kind = foreign_kind(bytes))
        return fail(ErrorCode::unsupported, "this is " + *kind);
    if (!result) return result;
    for (Mesh& mesh : result->meshes) {
      make_utf8(mesh.name, result->notes);
      for (Attribute& a : mesh.attributes) make_utf8(a.name, result->notes);
    }
    if (format == Format::obj || format == Format::off)
      set_metadata(result->meshes[0], source_key, format == Format::obj ? "obj" : "off");
    return result;
  });
}

Expected<WriteResult> write(std::span<const Mesh> meshes, Format format,
                            std::optional<Encoding> encoding) {
  return internal::guarded("write", [&]() -> Expected<WriteResult> {
    for (std::size_t i = 0; i < meshes.size(); ++i)
      if (Expected<Done> checked = check(meshes[i], i); !checked)
        return Failure<Error>{checked.error()};
    if (meshes.size() != 1 && format != Format::obj)
      return fail(ErrorCode::unsupported,
                  "expected one mesh, which is what this format holds, found " +
                      std::to_string(meshes.size()));
    if (encoding == Encoding::binary && (format == Format::obj || format == Format::off))
      return fail(ErrorCode::unsupported,
                  "expected text, the one encoding of this format written here");

    Mesh unshared;
    const auto shares = [](const Attribute& a) { return !a.indices.empty(); };
    if (format != Format::obj &&
        std::any_of(meshes[0].attributes.begin(), meshes[0].attributes.end(), shares)) {
      unshared = without_sharing(meshes[0]);
      meshes = std::span(&unshared, 1);
    }
    Output out;
    Notes notes;
    Expected<Done> done = [&]() -> Expected<Done> {
      switch (format) {
        case Format::ply:
          return write_ply(meshes[0], encoding.value_or(Encoding::binary), out, notes);
        case Format::obj: return write_obj(meshes, out, notes);
        case Format::off: return write_off(meshes[0], out, notes);
        case Format::stl:
          return write_stl(meshes[0], encoding.value_or(Encoding::binary), out, notes);
      }
      return fail(ErrorCode::unsupported, "expected a known format");
    }();
    if (!done) return Failure<Error>{done.error()};
    return WriteResult{out.take(), std::move(notes)};
  });
}

void set_face_sizes(Mesh& mesh, std::vector<std::uint32_t> sizes) {
  const bool triangles = std::all_of(sizes.begin(), sizes.end(), [](auto n) { return n == 3; });
  mesh.face_sizes = triangles ? std::vector<std::uint32_t>() : std::move(sizes);
}

const Attribute* find(const Mesh& mesh, std::string_view name, Domain domain) {
  for (const Attribute& a : mesh.attributes)
    if (a.domain == domain && a.name == name) return &a;
  return nullptr;
}

std::string label(const Attribute& attribute) {
  return std::string(name(attribute.domain)) + " attribute " + quoted(attribute.name) + " (" +
         std::to_string(attribute.components) + " x " + name(attribute.scalar) + ")";
}

void note_left_out(Notes& notes, const Attribute& attribute, std::string_view why) {
  note_left_out(notes, 1, label(attribute), {}, why);
}

void note_left_out(Notes& notes, std::uint64_t count, std::string_view one, std::string_view many,
                   std::string_view why) {
  if (count == 0) return;
  Note note{
      Note::Kind::loss, count, many.empty() ? std::string(one) : counted(count, one, many), {}};
  note.text = note.what + (count == 1 ? " was" : " were") + " left out";
  if (!why.empty()) note.text.append(": ").append(why);
  notes.push_back(std::move(note));
}

Attribute expanded(const Attribute& attribute) {
  if (attribute.indices.empty()) return attribute;
  Attribute a = internal::by_element(attribute);
  if (missing(attribute) > 0) a.indices = attribute.indices;
  return a;
}

std::uint64_t missing(const Attribute& attribute) {
  return static_cast<std::uint64_t>(
      std::count(attribute.indices.begin(), attribute.indices.end(), no_value));
}

void note_zeros(Notes& notes, const Attribute& attribute, std::uint64_t count) {
  if (count == 0) return;
  const std::string what = counted(count, "missing value", "missing values");
  notes.push_back({Note::Kind::loss, count, what,
                   label(attribute) + ": " + what + " became zeros, as the format has no other"});
}

void note_padding(Notes& notes, std::size_t bytes) {
  if (bytes > 0)
    note_remark(notes, bytes, counted(bytes, "byte", "bytes"),
                std::string(bytes == 1 ? "was" : "were") + " padding at the end of the file");
}

std::string utf8_of_latin_1(std::string_view text) {
  std::string utf8;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80)
      utf8 += c;
    else
      utf8 += {static_cast<char>(0xc0 | byte >> 6), static_cast<char>(0x80 | (byte & 0x3f))};
  }
  return utf8;
}

std::string some(const std::set<std::string>& names) {
  constexpr std::size_t most = 3;
  std::string text;
  std::size_t shown = 0;
  for (const std::string& name : names) {
    if (shown == most) return text + " and " + std::to_string(names.size() - most) + " more";
    if (shown++ > 0) text += ", ";
    text += quoted(name);
  }
  return text;
}

void note_remark(Notes& notes, std::uint64_t count, std::string what, std::string_view became) {
  std::string text = what + ' ' + std::string(became);
  notes.push_back({Note::Kind::remark, count, std::move(what), std::move(text)});
}

const std::string* metadata(const Mesh& mesh, std::string_view key) {
  for (const MetadataEntry& entry : mesh.metadata)
    if (entry.key == key) return &entry.value;
  return nullptr;
}

void set_metadata(Mesh& mesh, std::string_view key, std::string value) {
  mesh.metadata.push_back({std::string(key), std::move(value)});
}

void note_metadata_left_out(Notes& notes, const Mesh& mesh,
                            std::initializer_list<std::string_view> written) {
  std::set<std::string> others;
  for (const MetadataEntry& entry : mesh.metadata) {
    if (std::find(written.begin(), written.end(), entry.key) != written.end()) continue;
    const auto lines =
        1 + static_cast<std::uint64_t>(std::count(entry.value.begin(), entry.value.end(), '\n'));
    if (entry.key == comment_key)
      note_left_out(notes, lines, "comment", "comments");
    else if (entry.key == obj_info_key)
      note_left_out(notes, lines, "line obj_info", "lines obj_info");
    else if (entry.key == header_key)
      note_left_out(notes, 1, "the header of a binary STL", {});
    else if (entry.key == properties_key)
      note_remark(notes, lines, counted(lines, "name", "names"),
                  "of properties of PLY became those of this format");
    else if (entry.key != source_key)
      others.insert(entry.key);
  }
  note_left_out(notes, others.size(), "entry of metadata", "entries of metadata", some(others));
}

void write_comments(Output& out, const Mesh& mesh) {
  for_each_line(mesh, comment_key, [&](std::string_view line) {
    out << '#';
    for (const char c : line) out << (c == '\r' ? ' ' : c);
    out << '\n';
  });
}

std::optional<Source> source_of(const Mesh& mesh) {
  const std::string* source = metadata(mesh, source_key);
  if (!source) return std::nullopt;
  for (const SourceName& s : source_names)
    if (s.name == *source) return s.source;
  return std::nullopt;
}

void note_lost_nans(Notes& notes, const Attribute& attribute) {
  if (const std::size_t lost = count_lost_nans(attribute))
    notes.push_back({Note::Kind::loss, lost,
                     counted(lost, "bit pattern", "bit patterns") + " of NaNs",
                     label(attribute) + ": the bits of " + counted(lost, "NaN", "NaNs") +
                         " cannot be written as text and read back as those of a plain NaN"});
}

}  // namespace io
}  // namespace clers

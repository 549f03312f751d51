// One reader and one writer for each format; see io.h for what they keep.
#ifndef CLERS_CODEC_IO_FORMATS_H
#define CLERS_CODEC_IO_FORMATS_H

#include <algorithm>
#include <initializer_list>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "codec/io/io.h"
#include "codec/io/text.h"

namespace clers::io {

Expected<ReadResult> read_ply(std::string_view file);
Expected<ReadResult> read_obj(std::string_view file);
Expected<ReadResult> read_off(std::string_view file);
Expected<ReadResult> read_stl(std::string_view file);

// Precondition: the meshes are consistent, as write() has checked. What is left out goes to notes.
Expected<Done> write_ply(const Mesh& mesh, Encoding encoding, Output& out, Notes& notes);
Expected<Done> write_obj(std::span<const Mesh> meshes, Output& out, Notes& notes);
Expected<Done> write_off(const Mesh& mesh, Output& out, Notes& notes);
Expected<Done> write_stl(const Mesh& mesh, Encoding encoding, Output& out, Notes& notes);

/// Sets the faces' sizes, or none if all are triangles.
void set_face_sizes(Mesh& mesh, std::vector<std::uint32_t> sizes);

/// The number of corners of a face.
inline std::uint32_t face_size(const Mesh& mesh, std::size_t face) {
  return mesh.triangles_only() ? 3 : mesh.face_sizes[face];
}

/// The attribute of this name in this domain, or nullptr.
const Attribute* find(const Mesh& mesh, std::string_view name, Domain domain);

/// "vertex attribute 'name' (3 x float32)".
std::string label(const Attribute& attribute);

/// A loss: "2 comments were left out", and why if there is more to say. None if there are none.
void note_left_out(Notes& notes, std::uint64_t count, std::string_view one, std::string_view many,
                   std::string_view why = {});

/// Notes that an attribute was left out.
void note_left_out(Notes& notes, const Attribute& attribute, std::string_view why = {});

std::string utf8_of_latin_1(std::string_view text);

/// Up to three of them, in quotes: "'a', 'b', 'c' and 5 more".
std::string some(const std::set<std::string>& names);

/// What metadata say, or nullptr.
const std::string* metadata(const Mesh& mesh, std::string_view key);
void set_metadata(Mesh& mesh, std::string_view key, std::string value);

/// Keys of metadata. The values of all but the header are lines, without the last one's end.
inline constexpr std::string_view source_key = "source.format";  ///< "ply ascii", "obj", ..
inline constexpr std::string_view comment_key = "comment";       ///< what follows '#' or "comment"

/// Notes if a text loses bits of NaNs of an attribute.
void note_lost_nans(Notes& notes, const Attribute& attribute);
inline constexpr std::string_view obj_info_key = "obj_info";  ///< of PLY, what follows the word
inline constexpr std::string_view properties_key = "ply.properties";
inline constexpr std::string_view header_key = "stl.header";

/// The 16 bits of each triangle of a binary STL, where some are not 0: a face attribute.
inline constexpr std::string_view stl_bits_name = "stl.bits";

/// The attribute without sharing, value i that of element i. Its indices are left only where some
/// elements have no value; these have zeros.
Attribute expanded(const Attribute& attribute);
/// How many elements have no value.
std::uint64_t missing(const Attribute& attribute);
/// Notes elements without a value, for which a format has no other.
void note_zeros(Notes& notes, const Attribute& attribute, std::uint64_t count);

/// Notes the metadata that a writer has no place for: all but these.
void note_metadata_left_out(Notes& notes, const Mesh& mesh,
                            std::initializer_list<std::string_view> written);

/// Calls f(line) for each line of what metadata say.
template <class F>
void for_each_line(const Mesh& mesh, std::string_view key, F f) {
  const std::string* lines = metadata(mesh, key);
  if (!lines) return;
  for (std::size_t from = 0; from <= lines->size();) {
    const std::size_t end = std::min(lines->find('\n', from), lines->size());
    f(std::string_view(*lines).substr(from, end - from));
    from = end + 1;
  }
}

/// The comments, a line each behind '#'.
void write_comments(Output& out, const Mesh& mesh);

/// Some programs write the zero that ends a string in C, or the byte that ended a text in CP/M.
inline std::string_view without_padding(std::string_view file) {
  return file.substr(0, file.find_last_not_of(std::string_view("\0\x1a", 2)) + 1);
}
void note_padding(Notes& notes, std::size_t bytes);

/// A remark: "3 polygons" "became 6 triangles".
void note_remark(Notes& notes, std::uint64_t count, std::string what, std::string_view became);

}  // namespace clers::io

#endif

// One reader and one writer for each format; see io.h for what they keep.
#ifndef CLERS_CODEC_IO_FORMATS_H
#define CLERS_CODEC_IO_FORMATS_H

#include <span>
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

inline void note_line(Notes& notes, std::string line) {
  notes.push_back({Note::Kind::loss, 1, line, line});
}

/// A remark: "3 polygons" "became 6 triangles".
void note_remark(Notes& notes, std::uint64_t count, std::string what, std::string_view became);

/// What metadata say, or nullptr.
const std::string* metadata(const Mesh& mesh, std::string_view key);
void set_metadata(Mesh& mesh, std::string_view key, std::string value);

/// Keys of metadata. The values of all but the header are lines, without the last one's end.
inline constexpr std::string_view source_key = "source.format";  ///< "ply ascii", "obj", ..
inline constexpr std::string_view comment_key = "comment";       ///< what follows '#' or "comment"

/// Notes if a text loses bits of NaNs of an attribute.
void note_lost_nans(Notes& notes, const Attribute& attribute);

}  // namespace clers::io

#endif

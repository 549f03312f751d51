// Mesh files <-> meshes.
#ifndef CLERS_CODEC_IO_IO_H
#define CLERS_CODEC_IO_IO_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <clers/error.h>
#include <clers/mesh.h>
#include <clers/topology/export.h>

namespace clers {
namespace CLERS_VISIBLE io {

/// What is read and, but for what is in brackets, written:
///
///     ply  text and binary [both byte orders; written little endian]. Faces of any size, or
///          triangle strips [written as faces]. Properties of vertices and faces become attributes:
///              x y z -> "position", nx ny nz -> "normal", red green blue [alpha] -> "color",
///              s t, u v or texture_u texture_v -> "texcoord", any other -> its own name.
///          So do lists of one length; of lists that differ in length, number i of each becomes
///          attribute "NAME.i", which shorter ones have no value of. Lists "texcoord" and "color"
///          of faces, which MeshLab writes, are of the corners; those of a face may be empty.
///          Metadata keep comments, lines obj_info and what properties are called. Attributes of
///          several components, and names that a header cannot hold, are kept in comments that
///          begin "clers", so that all but 64-bit integers reads back as it was.
///     obj  Faces of any size. v -> "position", and "color": bytes if all are 255ths. vt and vn ->
///          "texcoord" and "normal" by corner; values are shared, or missing, as faces index them.
///          o, g, usemtl and s -> face attributes "object", "group", "material", "smoothing":
///          numbers of the names that metadata list ("obj.objects", "obj.groups", "obj.materials",
///          "obj.smoothing", a name a line). A single o names the mesh instead. Metadata keep
///          mtllib ("obj.mtllib"). Written faces are put together by these statements. Several
///          meshes are written as objects, which read back as one.
///     off  text in three dimensions, in the variants of Geomview and MeshLab. Faces of any size;
///          "position", "normal", "color" and "texcoord" of vertices, "color" of faces, or
///          "color_index". Some vertices or faces may have no colour.
///     stl  text and binary. Triangles [polygons as fans], by positions alone, which are written as
///          float32, and normals, which come from the corners. Of a binary file metadata keep the
///          header, and face attribute "stl.bits" what stands behind each triangle, such as its
///          colour, if that is not 0.
///
/// Comments of obj and off are metadata too. Lines end in LF, CR LF or CR; byte order marks of
/// UTF-8 are blanks; NaN and infinity may be as Microsoft's C library wrote them.
enum class Format { ply, obj, off, stl };

enum class Encoding { text, binary };

/// From a file name's extension or a name given by the user ("ply", ".PLY"); none if unknown.
std::optional<Format> format_of(std::string_view name);

/// What a file is that is none of these, and what to do: "a gzip file: unpack it first, with
/// gunzip"; none if it is not known. By its first bytes, as read() says it, or by its name.
std::optional<std::string> foreign_kind(std::span<const std::byte> bytes);
std::optional<std::string> foreign_kind(std::string_view name);

/// What happened to one kind of thing in reading or writing.
struct Note {
  enum class Kind : std::uint8_t {
    loss,    ///< the result does not have it
    remark,  ///< the result has it in another form, or more than the file says
  };
  Kind kind = Kind::loss;
  std::uint64_t count = 0;  ///< of the things
  std::string what;         ///< "665 texture coordinates"
  std::string text;  ///< "665 texture coordinates were left out: 139 of 7946 faces have none"
};
using Notes = std::vector<Note>;  ///< one for each kind of thing

/// What a mesh was read from, if its metadata say so.
struct Source {
  Format format;
  Encoding encoding;
};
std::optional<Source> source_of(const Mesh& mesh);

struct ReadResult {
  std::vector<Mesh> meshes;
  Notes notes;
};

/// Reads a whole mesh file held in memory, as one mesh. Polygons stay polygons, unused vertices
/// stay, indices and the order of vertices and faces stay as in the file. Only STL welds: vertices
/// with equal positions become one, which is noted.
///
/// Numbers of OBJ, OFF and text STL, which do not say how wide they are, become float32 if each of
/// a kind (positions, normals, ..) is the rounding of a float32 to its digits, else float64.
///
/// Names that are not UTF-8 are taken as Latin-1, which is noted.
///
/// Errors: malformed, unsupported or too_large, with the line (text) or byte (binary) and what was
/// expected; out_of_memory. Memory: at most a small multiple of the file's size. Cost: linear but
/// for STL, whose corners are sorted.
Expected<ReadResult> read(std::span<const std::byte> bytes, Format format);

struct WriteResult {
  std::vector<std::byte> bytes;
  Notes notes;
};

/// Writes meshes as one file. PLY and STL are binary unless text is asked for, OBJ and OFF are
/// always text. A number in text has the fewest digits that read back bit for bit (NaN: its sign
/// alone). What a format cannot hold is noted.
/// Errors: unsupported (a format that cannot hold this at all, such as several meshes in all but
/// OBJ), inconsistent_mesh, too_large, out_of_memory.
Expected<WriteResult> write(std::span<const Mesh> meshes, Format format,
                            std::optional<Encoding> encoding = std::nullopt);

}  // namespace io
}  // namespace clers

#endif

// Mesh files <-> meshes.
#ifndef CLERS_CODEC_IO_IO_H
#define CLERS_CODEC_IO_IO_H

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "codec/error.h"
#include "codec/mesh.h"

namespace clers::io {

enum class Format { ply, obj, off, stl };

/// From a file name's extension or a name given by the user ("ply", ".PLY"); none if unknown.
std::optional<Format> format_of(std::string_view name);

/// What reading or writing could not carry over, for people, one line each
/// ("element 'camera' (1 entry) is not part of a mesh and was left out").
struct Notes {
  std::vector<std::string> lines;
};

struct ReadResult {
  std::vector<Mesh> meshes;
  Notes notes;
};

/// Reads a whole mesh file held in memory. Polygons stay polygons, unused vertices stay, indices and
/// vertex order stay as in the file. Only STL welds: vertices with equal position bits become one,
/// which is noted.
/// Errors: malformed or unsupported, with line (text) or byte (binary) and what was expected.
Expected<ReadResult> read(std::span<const std::byte> bytes, Format format);

enum class Encoding { text, binary };

struct WriteResult {
  std::vector<std::byte> bytes;
  Notes notes;
};

/// Writes meshes as one file. PLY is binary little endian unless text is asked for and keeps every
/// attribute that it can name; OFF and OBJ are text, floats written so that they read back bit for
/// bit; STL is binary unless text is asked for. What a format cannot hold is noted.
/// Errors: unsupported (a format that cannot hold this mesh at all, such as polygons in STL).
Expected<WriteResult> write(std::span<const Mesh> meshes, Format format,
                            std::optional<Encoding> encoding = std::nullopt);

}  // namespace clers::io

#endif

// Formats of files beside .clers, by name: those of meshes and those of scenes.
#ifndef CLERS_CODEC_CLI_FORMATS_H
#define CLERS_CODEC_CLI_FORMATS_H

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "codec/gltf/gltf.h"
#include "codec/io/io.h"

namespace clers::cli {

/// Draco's files, which are read and not written.
struct Drc {};

/// A format of meshes, or a form of glTF, which is one of scenes.
using Format = std::variant<io::Format, gltf::Form, Drc>;

inline bool is_scene(Format format) {
  return std::holds_alternative<gltf::Form>(format);
}

inline bool is_read_only(Format format) {
  return std::holds_alternative<Drc>(format);
}

/// From a file name's extension or a name given by the user ("ply", ".PLY"); none if unknown.
std::optional<Format> format_of(std::string_view name);

/// The same of a path: none if it has no extension that is known.
std::optional<Format> format_of_path(std::string_view path);

/// ".ply"
const char* extension(Format format);

inline constexpr char read_names[] = "ply, obj, off, stl, glb, gltf or drc",
                      written_names[] = "ply, obj, off, stl, glb or gltf";

}  // namespace clers::cli

#endif

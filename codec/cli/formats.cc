// Names that differ in case are the same.
#include "codec/cli/formats.h"

#include <algorithm>
#include <cctype>

namespace clers::cli {

std::optional<Format> format_of(std::string_view name) {
  if (const auto format = io::format_of(name)) return *format;
  if (name.starts_with('.')) name.remove_prefix(1);
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (lower == "glb") return gltf::Form::glb;
  if (lower == "gltf") return gltf::Form::gltf;
  if (lower == "drc") return Drc();
  return std::nullopt;
}

std::optional<Format> format_of_path(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == path.npos ? std::nullopt : format_of(path.substr(dot));
}

const char* extension(Format format) {
  if (is_read_only(format)) return ".drc";
  if (const auto* form = std::get_if<gltf::Form>(&format))
    return *form == gltf::Form::glb ? ".glb" : ".gltf";
  switch (std::get<io::Format>(format)) {
    case io::Format::ply: return ".ply";
    case io::Format::obj: return ".obj";
    case io::Format::off: return ".off";
    case io::Format::stl: return ".stl";
  }
  return "";
}

}  // namespace clers::cli

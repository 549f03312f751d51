// Files that are no meshes of ours: what they are, and what to do about it.
#include <algorithm>
#include <cctype>

#include "codec/io/formats.h"

namespace clers::io {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view export_it = ", which clers does not read: export OBJ, PLY or STL";
constexpr std::string_view unpack_it = ": unpack it first";

struct Kind {
  std::string_view start;       // of the file
  std::string_view extensions;  // of its name, between spaces
  std::string_view what, then;
};
constexpr Kind kinds[] = {
    {"CLERS"sv, " clers ", "a .clers file",
     ": it is encoded already; decode, info and verify read it"},
    {"glTF"sv, " glb ", "a glTF binary", ": call it .glb, or say --from glb"},
    {{}, " gltf ", "a glTF scene", ": call it .gltf, or say --from gltf"},
    {"DRACO"sv, " drc ", "a Draco file", ": call it .drc, or say --from drc"},
    {"\x1f\x8b"sv, " gz tgz ", "a gzip file", ": unpack it first, with gunzip"},
    {"\x28\xb5\x2f\xfd"sv, " zst ", "a zstd file", ": unpack it first, with zstd -d"},
    {"\xfd\x37\x7a\x58\x5a"sv, " xz ", "an xz file", ": unpack it first, with unxz"},
    {"BZh"sv, " bz2 ", "a bzip2 file", ": unpack it first, with bunzip2"},
    {"\x04\x22\x4d\x18"sv, " lz4 ", "an lz4 file", ": unpack it first, with lz4 -d"},
    {"7z\xbc\xaf\x27\x1c"sv, " 7z ", "a 7-Zip archive", unpack_it},
    {"Rar!"sv, " rar ", "a RAR archive", unpack_it},
    {{}, " 3mf ", "a 3MF package", export_it},
    {{}, " usdz ", "a USD package", export_it},
    {"PK\x03\x04"sv, " zip ", "a zip archive", unpack_it},
    {{}, " tar ", "a tar archive", unpack_it},
    {"Kaydara FBX Binary"sv, " fbx ", "an FBX scene", export_it},
    {"BLENDER"sv, " blend ", "a Blender file", export_it},
    {"PXR-USDC"sv, " usdc usd ", "a USD scene", export_it},
    {"#usda"sv, " usda ", "a USD scene", export_it},
    {"OCTM"sv, " ctm ", "an OpenCTM file", export_it},
    {"#VRML"sv, " wrl vrml ", "a VRML scene", export_it},
    {"# vtk DataFile"sv, " vtk ", "a VTK file", export_it},
    {"ISO-10303-21"sv, " stp step ", "a STEP model", export_it},
    {"MeshVersionFormatted"sv, " mesh meshb ", "a Medit mesh", export_it},
    {"$MeshFormat"sv, " msh ", "a Gmsh mesh", export_it},
    {{}, " dae ", "a COLLADA scene", export_it},
    {{}, " x3d ", "an X3D scene", export_it},
    {{}, " amf ", "an AMF file", export_it},
    {{}, " 3ds max ", "a 3ds Max scene", export_it},
    {{}, " ma mb ", "a Maya scene", export_it},
    {{}, " c4d ", "a Cinema 4D scene", export_it},
    {{}, " lwo lws ", "a LightWave scene", export_it},
    {{}, " igs iges ", "an IGES model", export_it},
    {{}, " vtp vtu ", "a VTK file", export_it},
    {{}, " dxf dwg ", "a drawing", export_it},
    {{}, " mtl ", "a library of materials", ": give the OBJ file that names it"},
    {{},
     " pcd xyz pts las laz e57 ",
     "a cloud of points",
     ": save it as PLY, and clers reconstruct makes a mesh of it"},
    {"version https://git-lfs"sv,
     {},
     "a pointer of Git LFS",
     ": fetch the file itself, with git lfs pull"},
    {"<!DOCTYPE html"sv, " html htm ", "a web page", ": download the file itself"},
    {"<!doctype html"sv, {}, "a web page", ": download the file itself"},
    {"<html"sv, {}, "a web page", ": download the file itself"},
    {"<?xml"sv, " xml ", "an XML file", export_it},
    {"\xff\xfe"sv, {}, "text in UTF-16", ": save it as UTF-8"},
    {"\xfe\xff"sv, {}, "text in UTF-16", ": save it as UTF-8"},
};

std::string said(const Kind& kind) {
  return std::string(kind.what).append(kind.then);
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

// A glTF scene as text is JSON with an "asset".
bool is_gltf(std::string_view file) {
  const std::string_view start = file.substr(0, 4096);
  const std::size_t brace = start.find_first_not_of(" \t\r\n");
  return brace != start.npos && start[brace] == '{' &&
         (start.find("\"asset\"") != start.npos || start.find("\"accessors\"") != start.npos ||
          start.find("\"buffers\"") != start.npos);
}

}  // namespace

std::optional<std::string> foreign_kind(std::span<const std::byte> bytes) {
  const std::string_view file = as_text(bytes);
  for (const Kind& kind : kinds)
    if (!kind.start.empty() && file.starts_with(kind.start)) return said(kind);
  if (is_gltf(file)) return foreign_kind(".gltf");
  return std::nullopt;
}

std::optional<std::string> foreign_kind(std::string_view name) {
  const std::string extension = ' ' + lower_case(name.substr(name.rfind('.') + 1)) + ' ';
  for (const Kind& kind : kinds)
    if (kind.extensions.find(extension) != kind.extensions.npos) return said(kind);
  return std::nullopt;
}

}  // namespace clers::io

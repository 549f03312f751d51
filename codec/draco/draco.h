// Draco's files -> meshes, by Google's library.
#ifndef CLERS_CODEC_DRACO_DRACO_H
#define CLERS_CODEC_DRACO_DRACO_H

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <clers/error.h>
#include <clers/limits.h>
#include <clers/mesh.h>
#include <clers/topology/export.h>

namespace clers {
namespace CLERS_VISIBLE draco {

/// What a .drc file becomes:
///
///   vertices    The different positions, as draco_decoder writes an OBJ. Where nothing is shared
///               (sequential coding, point clouds) they are Draco's points.
///   attributes  "position", "normal", "color", "texcoord"; a generic one has the name that the
///               metadata give it, or is "generic". Others of one name are "color.1", ..
///               One that is the same at all points of a vertex is of vertices; a generic one that
///               is the same at all corners of each face is of faces; all others are of corners, by
///               index: what Draco shares stays shared. Booleans are uint8.
///   metadata    "draco.attributes", a line for each: name, Draco's type, unique id, "normalized",
///               and to how many bits it is quantised. Draco's own entries are "draco.KEY", those
///               of an attribute "draco.NAME.KEY", below others "draco.KEY.KEY".
///
/// A point cloud is a mesh without faces.
struct ReadResult {
  Mesh mesh;
  std::vector<std::string> notes;  ///< for people: what Draco has lost, as far as its file tells
};

/// Reads a .drc file. Values are bit for bit those that Draco decodes.
///
/// Errors: malformed; unsupported, of a version that the library does not know; limit, before
/// Draco allocates what its headers ask for; out_of_memory. Memory: some 200 bytes a face. The
/// bytes go through Google's decoder, which checks what it reads but has had its faults: trust
/// files of strangers no further than you trust that.
Expected<ReadResult> read(std::span<const std::byte> bytes, const Limits& limits = {});

/// The hook for gltf::Decoders: what the bufferView of a KHR_draco_mesh_compression holds. Vertices
/// are Draco's points, attributes have a value for each, and their unique ids, in decimal, for
/// names. Metadata of the same key say how an attribute is quantised: "14 bits". The same errors.
Expected<Mesh> decode_for_gltf(std::span<const std::byte> bytes);

}  // namespace draco
}  // namespace clers

#endif

// Measures meshes, and those of a file.
#ifndef CLERS_CODEC_INSPECT_H
#define CLERS_CODEC_INSPECT_H

#include <cstddef>
#include <span>
#include <vector>

#include <clers/error.h>
#include <clers/info.h>
#include <clers/limits.h>
#include <clers/mesh_view.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// A mesh of a file, measured.
struct InspectedMesh {
  MeshShape shape;
  CodingCounts counts;
};

/// A file, and each of its meshes measured.
struct Inspection {
  FileInfo file;
  std::vector<InspectedMesh> meshes;  ///< one for each of file.meshes
};

/// Decodes the faces of all meshes of a .clers file, not their attributes, and measures them.
/// Decoder::info (<clers/decoder.h>) gives Inspection::file alone at once. Errors: those of decode.
/// Thread safe. Cost: several times that of decoding the faces; the memory of one mesh at a time,
/// for which the limit is.
Expected<Inspection> inspect(std::span<const std::byte> bytes, const Limits& limits = {});

/// Measures a mesh of any faces. Looks at no values of attributes. Errors: inconsistent_mesh,
/// too_large (2^32 - 1 corners or 2^31 - 1 faces), out_of_memory. Thread safe. Cost: n log n in the
/// corners; some 50 bytes each.
Expected<MeshShape> measure(const MeshView& mesh);

}  // namespace clers

#endif

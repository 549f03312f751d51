// The sections of a mesh -> the mesh.
#ifndef CLERS_CODEC_MESH_DECODER_H
#define CLERS_CODEC_MESH_DECODER_H

#include "codec/connectivity.h"
#include "codec/error.h"
#include "codec/mesh.h"
#include "codec/mesh_reader.h"
#include "codec/turned_faces.h"

namespace clers {

/// A mesh without attributes, and the triangles that those are predicted along.
struct DecodedFaces {
  Mesh mesh;
  bool all_on_surface = true;            ///< mesh.corners are the triangles of the surface
  std::vector<std::uint32_t> triangles;  ///< otherwise those, or fans of plain faces
  std::vector<TurnedRun> turned;
  ConnectivityCounts counts;
};

/// Precondition: `sections` comes from read_meshes. Errors: those of decode. Throws std::bad_alloc
/// only.
Expected<DecodedFaces> decode_faces(const MeshSections& sections);

/// Puts a mesh back into the order of its file, where that was kept; values too. Errors: invalid.
Expected<Done> restore_order(const MeshSections& sections, Mesh& mesh);

/// Turned faces are told to run the other way until this is called: values are predicted before.
void turn_back(Mesh& mesh, std::span<const TurnedRun> runs);

}  // namespace clers

#endif

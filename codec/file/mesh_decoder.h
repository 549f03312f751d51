// The sections of a mesh -> the mesh: which stream is decoded after which, and what memory all that
// takes. Knows the streams by their rooms, and nothing of what is in them.
#ifndef CLERS_CODEC_FILE_MESH_DECODER_H
#define CLERS_CODEC_FILE_MESH_DECODER_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/connectivity/connectivity.h"
#include "codec/error.h"
#include "codec/file/mesh_reader.h"
#include "codec/mesh.h"

namespace clers::internal {

/// A piece, or a mesh that is not in pieces, in its own numbers.
struct DecodedPiece {
  Mesh mesh;
  ConnectivityCounts counts;
  std::uint64_t reversed_faces = 0;
};

enum class Values : bool { skip, decode };

/// Bytes that decoding a piece takes, by what its headers say.
struct PieceMemory {
  std::uint64_t result = 0;  ///< the mesh that comes out
  std::uint64_t faces = 0;   ///< at most while its faces are decoded, the result included
  std::uint64_t values = 0;  ///< while its values are, by one thread; the result included
  std::uint64_t peak() const { return std::max(faces, values); }
};
PieceMemory memory_of(const PieceSections& sections, Values values);

/// Bytes of the mesh that make_room makes.
std::uint64_t room_memory(const MeshSections& sections, Values values);

/// Bytes that finish_mesh takes besides the mesh.
std::uint64_t finishing_memory(const MeshSections& sections, Values values);

/// Decodes a piece, all of it or only its faces. Threads are for its attributes, as far as what
/// they take fits into `memory`. Preconditions: `sections` comes from read_sections; `memory` is at
/// least memory_of(sections, values).peak(). Errors: those of decode. Throws std::bad_alloc only.
Expected<DecodedPiece> decode_piece(const PieceSections& sections, Values values,
                                    unsigned threads = 1, std::uint64_t memory = 0);

/// The same of a piece whose faces are all triangles of its surface (may_have_sizes() is false, and
/// there are as many faces as surface_faces), without values, into memory for just its corners.
/// `twins` as for decode_connectivity.
Expected<Done> decode_triangles(const PieceSections& sections, std::span<std::uint32_t> corners,
                                std::span<HalfEdge> twins = {});

/// A mesh with room for all that its pieces will be.
Mesh make_room(const MeshSections& sections, Values values);

/// What is left to do when all pieces are there: the order of the file, where that was kept; values
/// too. Errors: invalid.
Expected<Done> finish_mesh(const MeshSections& sections, Mesh& mesh);

}  // namespace clers::internal

#endif

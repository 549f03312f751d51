// The sections of a mesh -> the mesh.
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
#include "codec/mesh_target.h"
#include "codec/piece.h"

namespace clers::internal {

/// A piece, or a mesh that is not in pieces, in its own numbers.
struct DecodedPiece {
  Mesh mesh;
  ConnectivityCounts counts;
  std::uint64_t turned_faces = 0;
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

/// Bytes that put_piece takes, and decode_seam.
std::uint64_t numbering_memory(const PieceSections& sections);

/// Bytes of the mesh that make_room makes.
std::uint64_t room_memory(const MeshSections& sections, Values values);

/// Bytes that finish_mesh takes besides the mesh.
std::uint64_t finishing_memory(const MeshSections& sections, Values values);

/// Decodes a piece, all of it or only its faces. Threads are for its attributes, as far as what
/// they take fits into `memory`. Preconditions: `sections` comes from read_meshes; `memory` is at
/// least memory_of(sections, values).peak(). Errors: those of decode. Throws std::bad_alloc only.
Expected<DecodedPiece> decode_piece(const PieceSections& sections, Values values,
                                    unsigned threads = 1, std::uint64_t memory = 0);

/// The same of a piece whose faces are all triangles of its surface (may_have_sizes() is false, and
/// there are as many faces as surface_faces), without values, into memory for just its corners.
/// `twins` as for decode_connectivity.
Expected<Done> decode_triangles(const PieceSections& sections, std::span<std::uint32_t> corners,
                                std::span<HalfEdge> twins = {});

/// The vertices of pieces before, in the order of the piece. Errors: invalid.
Expected<std::vector<SharedVertex>> decode_seam(const PieceSections& sections);

/// Gives the corners of a piece the numbers of its mesh: those that pieces before gave to vertices
/// of the seam, the others from sections.first_vertex on. Returns them for all vertices that a
/// corner can name. Errors: invalid.
Expected<std::vector<std::uint32_t>> number_piece(const PieceSections& sections,
                                                  std::span<std::uint32_t> corners);

/// A mesh with room for all that its pieces will be.
Mesh make_room(const MeshSections& sections, Values values);

/// Puts a decoded piece where it belongs. Calls for different pieces may run at the same time.
/// Errors: invalid.
Expected<Done> put_piece(const PieceSections& sections, const Mesh& piece, Mesh& whole);

/// The same, into memory of a caller: 32-bit corners, face sizes, and the attributes that the piece
/// has, or some of these.
Expected<Done> put_piece(const PieceSections& sections, const Mesh& piece, const MeshTarget& whole);

/// The sizes of all faces of a mesh; the values of an attribute, `step` bytes apart.
void put_sizes(const Mesh& from, std::span<std::uint32_t> to);
void put_values(const Attribute& from, std::byte* to, std::size_t step);

/// What is left to do when all pieces are there: the order of the file, where that was kept; values
/// too. Errors: invalid.
Expected<Done> finish_mesh(const MeshSections& sections, Mesh& mesh);

}  // namespace clers::internal

#endif

// A mesh put together of its decoded pieces: where a piece belongs, and which numbers its vertices
// have there. Knows pieces as meshes, and their seams.
#ifndef CLERS_CODEC_PIECES_ASSEMBLY_H
#define CLERS_CODEC_PIECES_ASSEMBLY_H

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/error.h"
#include "codec/mesh.h"
#include "codec/mesh_target.h"
#include "codec/piece.h"
#include "codec/pieces/seams.h"

namespace clers::internal {

/// A piece among those of its mesh.
struct PiecePlace {
  std::uint64_t vertices = 0, faces = 0, corners = 0;  ///< of the piece
  /// Where in the mesh what is the piece's own begins.
  std::uint64_t first_vertex = 0, first_face = 0, first_corner = 0;
  SeamHeader seam;
  std::uint64_t at = 0;  ///< of the piece in the file

  /// Unreferenced vertices come after all referenced ones.
  std::uint64_t most_used_vertices() const { return std::min(vertices, corners); }
};

/// Bytes that put_piece takes, and decode_seam.
std::uint64_t numbering_memory(const PiecePlace& place);

/// The vertices of pieces before, in the order of the piece. Error: invalid.
Expected<std::vector<SharedVertex>> decode_seam(const PiecePlace& place);

/// Gives the corners of a piece the numbers of its mesh: those that pieces before gave to vertices
/// of the seam, the others from place.first_vertex on. Returns them for all vertices that a corner
/// can name. Error: invalid.
Expected<std::vector<std::uint32_t>> number_piece(const PiecePlace& place,
                                                  std::span<std::uint32_t> corners);

/// Puts a decoded piece where it belongs. Calls for different pieces may run at the same time.
/// Precondition: `whole` has room for all its pieces, and the attributes of this one. Error:
/// invalid.
Expected<Done> put_piece(const PiecePlace& place, const Mesh& piece, Mesh& whole);

/// The same, into memory of a caller: 32-bit corners, face sizes, and attributes, of which i takes
/// values of attribute_of[i] of the piece. Precondition: none of these has values by index.
Expected<Done> put_piece(const PiecePlace& place, const Mesh& piece, const MeshTarget& whole,
                         std::span<const std::size_t> attribute_of);

/// The sizes of all faces of a mesh; the values of the elements of an attribute, `step` bytes
/// apart: where an element has none, the memory stays as it is.
void put_sizes(const Mesh& from, std::span<std::uint32_t> to);
void put_values(const Attribute& from, std::byte* to, std::size_t step);

}  // namespace clers::internal

#endif

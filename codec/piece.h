// A part of a file that decodes alone.
#ifndef CLERS_CODEC_PIECE_H
#define CLERS_CODEC_PIECE_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include <clers/mesh.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// A vertex of a piece that is a vertex of a piece before it.
struct SharedVertex {
  std::uint32_t vertex;  ///< of the piece
  std::uint32_t number;  ///< in the whole mesh
};

/// A part of a file that decodes alone: a piece of a mesh, or a mesh that is not in pieces.
struct Piece {
  std::size_t mesh_index = 0;  ///< of its mesh in the file
  std::size_t index = 0;       ///< among the pieces of that mesh
  std::size_t count = 1;       ///< of these pieces
  /// With values of all its vertices, shared ones too. The first piece has the metadata of the
  /// whole mesh.
  Mesh mesh;
  std::vector<SharedVertex> seam;  ///< by rising `vertex`
  /// In the whole mesh, the vertices that are not shared are numbered from here on in their order.
  std::uint32_t first_vertex = 0;
  std::uint32_t first_face = 0;  ///< and the faces
};

/// A piece, by what can be read without decoding it.
struct PieceInfo {
  std::size_t mesh_index = 0, index = 0, count = 1;    ///< as in Piece
  std::uint64_t vertices = 0, faces = 0, corners = 0;  ///< of Piece::mesh
  bool triangles_only = true;                          ///< false: there are, or may be, other faces
  std::uint32_t first_vertex = 0, first_face = 0;      ///< as in Piece
};

}  // namespace clers

#endif

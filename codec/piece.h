// A part of a file that decodes alone.
#ifndef CLERS_CODEC_PIECE_H
#define CLERS_CODEC_PIECE_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/mesh.h"

namespace clers {

/// A vertex of a piece that is a vertex of a piece before it.
struct SharedVertex {
  std::uint32_t vertex;  ///< of the piece
  std::uint32_t number;  ///< in the whole mesh
};

/// A part of a file that decodes alone: a piece of a mesh, or a mesh that is not in pieces.
struct Piece {
  std::size_t mesh_index = 0;        ///< of its mesh in the file
  std::size_t index = 0, count = 1;  ///< among the pieces of the mesh
  Mesh mesh;                         ///< with the values of all its vertices, the shared ones too;
                                     ///< the first one of a mesh has the mesh's metadata
  std::vector<SharedVertex> seam;    ///< in the order of `vertex`
  std::uint32_t first_vertex = 0;    ///< its other vertices have this number and those that
                                     ///< follow in the whole mesh, in their order
  std::uint32_t first_face = 0;      ///< so have its faces
};

}  // namespace clers

#endif

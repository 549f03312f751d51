// Which faces of a mesh are coded together, where it is coded in pieces.
#ifndef CLERS_CODEC_PARTITION_H
#define CLERS_CODEC_PARTITION_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/mesh.h"

namespace clers {

/// Faces piece by piece, in the order of the mesh within each; no piece is empty.
struct Partition {
  std::vector<std::uint32_t> faces;
  std::vector<std::uint32_t> begin = {0};  ///< of each piece in `faces`, and one past the last

  std::size_t count() const { return begin.size() - 1; }
  std::span<const std::uint32_t> piece(std::size_t i) const {
    return std::span(faces).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

/// Parts the faces into pieces of about `piece_faces`, in space: a mesh is halved again and again
/// by the plane across an axis that cuts the fewest faces. A face lies where most of its vertices
/// do, and a component that is small beside a piece lies as a whole where its least vertex does.
///
/// Vertices at one place are never told apart, so the parts depend on neither the order of faces
/// nor that of vertices. Without positions the place of a vertex is how far it is from some others.
/// Precondition: the mesh is consistent. Cost: linear; some 10 bytes a face. Throws std::bad_alloc
/// only.
Partition partition(const Mesh& mesh, std::uint32_t piece_faces, unsigned threads = 1);

}  // namespace clers

#endif

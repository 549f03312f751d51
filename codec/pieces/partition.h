// Which faces of a mesh are coded together, where it is coded in pieces. Knows nothing of how.
#ifndef CLERS_CODEC_PIECES_PARTITION_H
#define CLERS_CODEC_PIECES_PARTITION_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/mesh_view.h"

namespace clers::internal {

/// Faces piece by piece, in the order of the mesh within each; no piece is empty.
struct Partition {
  std::vector<std::uint32_t> faces;
  std::vector<std::uint32_t> begin = {0};  ///< of each piece in `faces`, and one past the last

  std::size_t count() const { return begin.size() - 1; }
  std::span<const std::uint32_t> piece(std::size_t i) const {
    return std::span(faces).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

/// Parts the faces into as many pieces as it takes for `piece_faces` in each; a piece may have some
/// percent more. Seams are short along the surface: faces that are connected within a small cell of
/// space stay together, and of such patches pieces are made so that few edges are cut (`cells.h`,
/// `bisection.h`). A face goes where most of its vertices do, and a component that is small beside
/// a piece goes into one as a whole.
///
/// Vertices at one place always go together, so the parts depend on neither the order of faces
/// nor that of vertices. Without positions cells grow along the faces, and the parts do depend on
/// that. Precondition: the mesh is consistent. Cost: linear, and n log n in the patches; some 20
/// bytes a face. Throws std::bad_alloc only.
Partition partition(const MeshView& mesh, std::uint32_t piece_faces, unsigned threads = 1);

}  // namespace clers::internal

#endif

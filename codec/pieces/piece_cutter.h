// The pieces of a mesh, each as a mesh that can be coded alone. Knows how faces were parted, and
// nothing of how they are coded.
#ifndef CLERS_CODEC_PIECES_PIECE_CUTTER_H
#define CLERS_CODEC_PIECES_PIECE_CUTTER_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/base/faces.h"
#include "codec/mesh.h"
#include "codec/pieces/partition.h"

namespace clers::internal {

/// Takes pieces out of a mesh, one by one.
class PieceCutter {
 public:
  /// Vertices that no face uses go to the last piece. The mesh must outlive this. Cost: linear.
  PieceCutter(const Mesh& mesh, Partition parts);

  std::size_t count() const { return parts_.count(); }
  std::span<const std::uint32_t> faces(std::size_t piece) const { return parts_.piece(piece); }

  struct Piece {
    Mesh mesh;                            ///< vertices are numbered as faces use them
    std::vector<std::uint32_t> vertices;  ///< of the whole mesh
  };
  /// `number` is memory for one caller at a time: empty at first, and left as it should be found.
  /// Cost: linear in the piece.
  Piece cut(std::size_t piece, std::vector<std::uint32_t>& number) const;

 private:
  const Mesh& mesh_;
  Partition parts_;
  Cycles all_;
  std::vector<std::uint32_t> isolated_;  ///< vertices that no face uses
};

}  // namespace clers::internal

#endif

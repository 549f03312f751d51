// A mesh <-> the pieces that it is coded in.
#ifndef CLERS_CODEC_PIECES_PIECES_H
#define CLERS_CODEC_PIECES_PIECES_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/file/mesh_encoder.h"
#include "codec/pieces/partition.h"

namespace clers::internal {

/// Takes pieces out of a mesh, one by one.
class PieceCutter {
 public:
  /// Vertices that no face uses go to the last piece. The mesh must outlive this. Cost: linear.
  PieceCutter(const MeshView& mesh, Partition parts);

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
  MeshView mesh_;
  Partition parts_;
  std::vector<std::uint32_t> begins_;    ///< first corner of each face; empty: triangles
  std::vector<std::uint32_t> isolated_;  ///< vertices that no face uses
};

/// Encodes a piece. The order that comes with it is that of the whole mesh.
Expected<EncodedMesh> encode_piece(PieceCutter::Piece piece, std::span<const std::uint32_t> faces,
                                   const EncodeOptions& options, const Progress& progress);

/// Makes one mesh of coded pieces: adds up what was found in them, and inserts the seams. The
/// sections begin with the number of pieces; name and order are still missing.
EncodedMesh join(std::vector<EncodedMesh> pieces, const MeshView& mesh);

}  // namespace clers::internal

#endif

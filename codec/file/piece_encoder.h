// A mesh that is coded in pieces: each piece as a mesh, and the sections of all of them as those of
// one mesh. Knows pieces as they were cut out, and their seams.
#ifndef CLERS_CODEC_FILE_PIECE_ENCODER_H
#define CLERS_CODEC_FILE_PIECE_ENCODER_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/file/mesh_encoder.h"
#include "codec/pieces/piece_cutter.h"

namespace clers::internal {

/// Encodes a piece. The order that comes with it is that of the whole mesh. Options: in the order
/// of the codec.
Expected<EncodedMesh> encode_piece(PieceCutter::Piece piece, std::span<const std::uint32_t> faces,
                                   const EncodeOptions& options,
                                   std::span<const AttributePlan> plans, const Progress& progress);

/// Makes one mesh of coded pieces: adds up what was found in them, and inserts the seams.
EncodedMesh join_pieces(std::vector<EncodedMesh> pieces, const MeshView& mesh, Order order);

}  // namespace clers::internal

#endif

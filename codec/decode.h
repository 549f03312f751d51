// Bytes -> meshes.
#ifndef CLERS_CODEC_DECODE_H
#define CLERS_CODEC_DECODE_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "codec/error.h"
#include "codec/limits.h"
#include "codec/mesh.h"
#include "codec/options.h"
#include "codec/piece.h"
#include "topology/ids.h"

namespace clers {

/// Decodes a .clers file. Trusts nothing: every index of a returned mesh is below its vertex_count,
/// counts are checked against the bytes that remain and the limits before allocation, and what is
/// wrong with the bytes is a named error with the byte offset. A file that needs more memory than
/// the limit is refused before any is taken; how much that is depends on what headers say alone,
/// not on threads, of which only as many work as there is memory for. Errors: not_clers,
/// unsupported_version, truncated, trailing_bytes, corrupt, invalid, limit, out_of_memory. Throws
/// nothing, but passes on what `progress` throws (as out_of_memory, if that is std::bad_alloc).
/// Cost: linear in the faces, and O(log n) for each handle. Thread safe: calls share nothing.
Expected<std::vector<Mesh>> decode(std::span<const std::byte> bytes,
                                   const DecodeOptions& options = {});

/// Decodes a file piece by piece, which `take` receives in their order: as decode, but no more than
/// one is in memory. Numbers are those of the whole mesh as it is decoded without the order of its
/// file: that of a mesh in pieces is not restored. One thread works. The limit of memory is for one
/// piece and what comes with it; pieces taken are the caller's. Errors: those of decode, some of
/// them when pieces were taken already; bad_option if `take` is empty. What `take` throws passes
/// through, as what `progress` throws.
Expected<Done> decode_pieces(std::span<const std::byte> bytes,
                             const std::function<void(Piece)>& take,
                             const DecodeOptions& options = {});

/// Decodes one piece, counted over all meshes of the file. Errors: as above; bad_option if there is
/// none such.
Expected<Piece> decode_piece(std::span<const std::byte> bytes, std::size_t index,
                             const DecodeOptions& options = {});

/// Sizes of a mesh that can be known without decoding it.
struct MeshSizes {
  std::uint64_t vertices = 0, faces = 0, corners = 0, pieces = 1;
};

/// Sizes of the meshes of a file. Checks it as far as decode does before it allocates, limits
/// included. Errors: those of decode.
Expected<std::vector<MeshSizes>> sizes(std::span<const std::byte> bytes, const Limits& limits = {});

/// Decodes the faces of a file of one mesh, all of them triangles, into memory of the caller.
/// `corners` has the size that sizes() tells; 16 bits are enough up to 65536 vertices. `opposites`,
/// if not empty, has the same size and takes for every half-edge (3 f + i runs from corner i of
/// face f to the next) the one on the other side of the edge; null where there is none, or not just
/// one that runs the opposite way. Errors: those of decode, bad_option. On error the memory may
/// hold anything. Triangles on a surface are decoded in place; loose faces, faces one by one, a
/// kept order and 16 bits take memory for a copy.
Expected<Done> decode_into(std::span<const std::byte> bytes, std::span<std::uint32_t> corners,
                           std::span<HalfEdge> opposites = {}, const DecodeOptions& options = {});
Expected<Done> decode_into(std::span<const std::byte> bytes, std::span<std::uint16_t> corners,
                           std::span<HalfEdge> opposites = {}, const DecodeOptions& options = {});

}  // namespace clers

#endif

// A .clers file that is read once, and decoded as a whole or in parts.
#ifndef CLERS_CODEC_DECODER_H
#define CLERS_CODEC_DECODER_H

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <clers/error.h>
#include <clers/info.h>
#include <clers/mesh.h>
#include <clers/mesh_target.h>
#include <clers/options.h>
#include <clers/piece.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// Trusts no byte: counts are checked against the bytes that remain and the limits before anything
/// is allocated, every index that comes out is below the mesh's vertices, and what is wrong with
/// the bytes is a named error with its offset.
///
/// Errors of all functions: invalid, limit, out_of_memory, and bad_option for what is not there or
/// does not fit. What a call needs by the headers of the file is checked against Limits::memory
/// before any is taken, so that the verdict does not depend on threads: they only work on as many
/// pieces at a time as there is memory for. Nothing throws but what `progress` throws
/// (std::bad_alloc becomes out_of_memory).
///
/// Copies share what was read. Calls may run at the same time, also on one Decoder, if `progress`
/// allows it; the bytes must outlive it and stay as they are.
///
///     auto decoder = clers::Decoder::open(bytes);
///     const auto info = decoder->info();
///     std::vector<Vertex> vertices(info->meshes[0].vertices);
///     std::vector<std::uint32_t> indices(info->meshes[0].corners);
///     const clers::AttributeTarget places[] = {
///         clers::attribute_target("position", vertices, &Vertex::position)};
///     decoder->decode_into(0, {.corners = indices, .attributes = places});
class Decoder {
 public:
  /// Reads headers and checksums. Errors besides: not_clers, unsupported_version, truncated,
  /// trailing_bytes, corrupt. Cost: a pass over the bytes; some hundred bytes of memory for each
  /// piece and attribute, and 4 bytes are counted for each vertex that costs the file nothing.
  static Expected<Decoder> open(std::span<const std::byte> bytes, DecodeOptions options = {});

  std::size_t mesh_count() const;
  std::size_t piece_count() const;  ///< of all meshes; a mesh that is not in pieces is one

  /// Sizes, attributes, names, metadata, and what they cost: all that is known without decoding.
  /// Cost: linear in meshes, pieces and attributes; metadata is unpacked.
  Expected<FileInfo> info() const;

  /// Sizes of a piece, counted over all meshes. Constant time.
  Expected<PieceInfo> piece_info(std::size_t piece) const;

  /// All meshes, or one. Cost: linear in faces and values, and O(log n) a handle.
  Expected<std::vector<Mesh>> decode() const;
  Expected<Mesh> decode(std::size_t mesh) const;

  /// Decodes the faces of a mesh, some of its attributes, or both, into memory of the caller. What
  /// is asked for in one call is decoded once: values are predicted along faces, so any call
  /// decodes these. On error the memory may hold anything.
  ///
  /// bad_option, before anything is decoded: a size that is not that of MeshInfo (the expected one
  /// is named), no such attribute or not of this type, 16 bits for more than 65536 vertices; and
  /// once faces are known: polygons without memory for face_sizes. Of several attributes of one
  /// name and domain, this reaches the first.
  ///
  /// Memory besides: that of a piece for each thread (of a mesh that is not in pieces, the mesh; if
  /// the order of the input is kept, the whole mesh), but no copy of 32-bit corners if no
  /// attributes are asked for and all faces are triangles on the surface. 16-bit corners: 4 bytes
  /// each. Opposites come with the faces, at 4 bytes each, if no attributes are asked for and the
  /// mesh is a manifold of triangles in one piece; else they are searched for, in linear time.
  Expected<Done> decode_into(std::size_t mesh, const MeshTarget& target) const;

  /// One piece, counted over all meshes. Its numbers in the whole mesh are those of the codec's
  /// order: where the order of the input was kept, only a mesh that is one piece comes back in it.
  /// Memory: of this piece alone. Cost: linear in it. To go through a file in little memory, decode
  /// all pieces in turn.
  Expected<Piece> decode_piece(std::size_t piece) const;

 private:
  struct State;
  explicit Decoder(std::shared_ptr<const State> state) : state_(std::move(state)) {}

  std::shared_ptr<const State> state_;
};

}  // namespace clers

#endif

// One large mesh, whose pieces are encoded apart: by other processes, or on other machines.
#ifndef CLERS_CODEC_APART_H
#define CLERS_CODEC_APART_H

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <clers/error.h>
#include <clers/mesh.h>
#include <clers/mesh_view.h>
#include <clers/options.h>
#include <clers/order.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// A piece, encoded: a .clers file that decodes alone, and where its elements were in the piece.
struct CodedPiece {
  std::vector<std::byte> bytes;
  Permutation order;
};

/// Does what encode() does with a mesh that is coded in pieces, in three steps. What comes out has
/// the same bytes.
///
///     cut ----> piece 0 --> encode_piece --> CodedPiece --+
///          +--> piece 1 --> encode_piece --> CodedPiece --+--> join
///          +--> ..
///
/// The mesh must outlive it. Calls of const functions may run at the same time.
class PiecesApart {
 public:
  /// Quantises and parts the mesh; encodes nothing. Errors: those of encode(). Cost: linear, and
  /// n log n in the patches that pieces are made of.
  static Expected<PiecesApart> cut(const MeshView& mesh, const EncodeOptions& options);

  /// 0: by these options the mesh is not coded in pieces, and encode() is all there is to do.
  std::size_t count() const;
  /// What pieces must know of the whole: for encode_piece(), by the same version of the library.
  std::span<const std::byte> plan() const;
  /// A piece as a mesh, whose values may be integers that `plan` explains. Error: bad_option, no
  /// such piece. Cost: linear in the piece, and 4 bytes a vertex of the mesh.
  Expected<Mesh> piece(std::size_t index) const;

  struct Joined {
    std::vector<std::byte> bytes;  ///< those of encode()
    Permutation order;             ///< of the whole mesh
  };
  /// One for each piece, in their order. Errors: bad_option, another number of them or an order
  /// that is not of this piece; those of a file that is no piece (truncated, corrupt, invalid ..).
  Expected<Joined> join(std::span<const CodedPiece> pieces) const;

 private:
  struct State;
  explicit PiecesApart(std::shared_ptr<const State> state) : state_(std::move(state)) {}

  std::shared_ptr<const State> state_;
};

/// Encodes what PiecesApart::piece() gave. Options: those that the mesh was cut with; of them
/// `level`, `threads` and `progress` count. Errors: those of encode(); corrupt, for a plan that is
/// damaged. Thread safe.
Expected<CodedPiece> encode_piece(const MeshView& piece, std::span<const std::byte> plan,
                                  const EncodeOptions& options);

}  // namespace clers

#endif

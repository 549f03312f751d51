// Meshes -> bytes.
#ifndef CLERS_CODEC_ENCODE_H
#define CLERS_CODEC_ENCODE_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "codec/error.h"
#include "codec/inspect.h"
#include "codec/mesh.h"

namespace clers {

inline constexpr int min_level = 1, max_level = 9, default_level = 5;

/// For EncodeOptions::piece_faces.
inline constexpr std::uint32_t most_faces_whole = 1u << 20, default_piece_faces = 1u << 18,
                               never_in_pieces = 0xffffffffu;

/// What to do with faces that most programs do not expect.
enum class OnOddity : std::uint8_t {
  keep,   ///< they come back as they were
  error,  ///< encoding fails and names the first
};

/// What becomes of the order of vertices and faces, and of the corner that a face begins with.
enum class Order : std::uint8_t {
  free,  ///< the codec's: Encoded::permutations
  keep,  ///< stored: index buffers come back identical
};

struct EncodeOptions {
  int level = default_level;  ///< 1 fastest .. 9 smallest

  /// A mesh of more faces is coded in pieces of about so many, which decode alone: in less memory,
  /// and by several threads. 0: in pieces of at most about default_piece_faces, if it has positions
  /// and more than most_faces_whole faces.
  std::uint32_t piece_faces = 0;
  unsigned threads = 1;  ///< over meshes and pieces, or the attributes of a single one; 0: one a
                         ///< core. They make no difference to the bytes

  Order order = Order::free;
  OnOddity on_nonmanifold = OnOddity::keep;  ///< edges of more than two faces or of two that run
                                             ///< the same way, vertices of several fans
  OnOddity on_degenerate = OnOddity::keep;   ///< faces that repeat a vertex, or have under three
  OnOddity on_duplicate = OnOddity::keep;    ///< faces on the same vertices as an earlier one

  /// Called now and then with the name of the stage and the share of the whole work that is done,
  /// 0..1, never decreasing; from the calling thread. May be empty. What it throws ends the work
  /// and passes through.
  std::function<void(std::string_view stage, double done)> progress;
};

/// What the codec renumbered. Decoding gives the mesh in the new order. With Order::keep all
/// are 0, 1, 2 .. and first corners 0.
struct Permutation {
  std::vector<std::uint32_t> vertices;       ///< vertices[new] = old, one for each vertex
  std::vector<std::uint32_t> faces;          ///< faces[new] = old, one for each face
  std::vector<std::uint32_t> first_corners;  ///< first_corners[new] = the corner of the old face
                                             ///< (0, 1, ..) that comes first now
};

struct Encoded {
  std::vector<std::byte> bytes;
  std::vector<Permutation> permutations;  ///< one for each mesh
  std::vector<MeshInfo> report;           ///< one for each mesh: what it costs, and what coding it
                                          ///< showed. Of the shape that is vertices, faces,
                                          ///< triangles and isolated vertices, and of a mesh in one
                                          ///< piece components, boundary curves and genus of the
                                          ///< surface that was coded. measure() tells all
};

/// Encodes meshes into one .clers file.
/// Same input and options give the same bytes, whatever the compiler, build or machine.
/// Any faces are taken and come back: of any number of corners, on any vertices. A manifold mesh
/// that comes back is encoded to the same bytes again, if it is whole, or if positions differ and
/// the pieces are manifold too; other meshes to others perhaps, since cuts depend on the order of
/// faces.
/// Errors: inconsistent_mesh, too_large, out_of_memory; and where options say so
/// degenerate_face, duplicate_face, nonmanifold_edge, nonorientable, nonmanifold_vertex, each with
/// the first offending element.
/// Thread safe: calls share nothing.
/// Cost: linear in the faces; O(log n) for each handle; and sorts of the faces at edges that are
/// not manifold, of degenerate faces, and of the patches that pieces are made of.
Expected<Encoded> encode(std::span<const Mesh> meshes, const EncodeOptions& options = {});

}  // namespace clers

#endif

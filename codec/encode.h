// Meshes -> bytes.
#ifndef CLERS_CODEC_ENCODE_H
#define CLERS_CODEC_ENCODE_H

#include <cstddef>
#include <span>
#include <vector>

#include "codec/error.h"
#include "codec/info.h"
#include "codec/mesh.h"
#include "codec/options.h"
#include "codec/order.h"

namespace clers {

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

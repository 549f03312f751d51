// A mesh on its way to be encoded: its values on their grids, its faces parted into pieces. Knows
// options, and nothing of how pieces are coded.
#ifndef CLERS_CODEC_FILE_CUT_MESH_H
#define CLERS_CODEC_FILE_CUT_MESH_H

#include <memory>

#include "codec/error.h"
#include "codec/file/quantised_mesh.h"
#include "codec/mesh_view.h"
#include "codec/options.h"
#include "codec/pieces/piece_cutter.h"

namespace clers::internal {

struct CutMesh {
  QuantisedMesh quantised;
  std::unique_ptr<PieceCutter> cutter;  ///< none: the mesh is whole
};

/// Pieces share the grids of the mesh, and are those of the values that were given. The mesh must
/// outlive what comes out. Precondition: check() and check_precisions() have passed it. Errors:
/// bad_option, not_on_grid.
Expected<CutMesh> cut_mesh(const MeshView& mesh, const EncodeOptions& options, unsigned threads);

/// Refuses a level, an order, a policy or a size of pieces that is out of its range.
Expected<Done> check_options(const EncodeOptions& options);

}  // namespace clers::internal

#endif

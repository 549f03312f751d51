// Normals that follow from positions and faces, where they are near enough to it.
#ifndef CLERS_CODEC_FILE_RECOMPUTED_NORMALS_H
#define CLERS_CODEC_FILE_RECOMPUTED_NORMALS_H

#include "codec/error.h"
#include "codec/mesh_view.h"
#include "codec/numbers/quantise.h"

namespace clers::internal {

/// Moves each value that is no more than `degrees` away from a formula of the geometry to the point
/// of an octahedral grid that the formula gives, so that its residual is 0; the others to the
/// nearest point, of a grid that is fine enough. The formula is that which fits most. Nothing is
/// moved if no grid is fine enough. `mesh` has the positions that are decoded, and triangles as
/// fans of polygons.
///
/// Errors: bad_option (no three floats a value, no positions of three components), not_on_grid (a
/// value without direction). Cost: linear for each formula, and sorts.
Expected<QuantisedValues> recompute_normals(const MeshView& mesh, const AttributeView& attribute,
                                            double degrees);

}  // namespace clers::internal

#endif

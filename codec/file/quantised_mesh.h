// A mesh with its values as exact as was asked for, before it is cut into pieces. Knows attributes
// by their values, and nothing of how they are coded.
#ifndef CLERS_CODEC_FILE_QUANTISED_MESH_H
#define CLERS_CODEC_FILE_QUANTISED_MESH_H

#include <cstddef>
#include <span>
#include <vector>

#include "codec/attributes/attribute_encoder.h"
#include "codec/error.h"
#include "codec/mesh_view.h"
#include "codec/options.h"
#include "codec/precision.h"
#include "codec/scene.h"

namespace clers::internal {

struct QuantisedMesh {
  MeshView mesh;                     ///< as it will be decoded, or with integers of it: has what
                                     ///< follows
  std::vector<AttributePlan> plans;  ///< one an attribute; none: all are lossless
  std::vector<Warning> warnings;     ///< Warning::mesh is not set

  std::vector<std::vector<std::byte>> values;
  std::vector<AttributeView> attributes;
};

/// Refuses precisions that none can have, and names that no mesh and no array has. Error:
/// bad_option.
Expected<Done> check_precisions(std::span<const MeshView> meshes, const EncodeOptions& options,
                                std::span<const Array> arrays = {});

/// Quantises what is to be quantised, whose values are copied. The mesh must outlive what comes
/// out. Threads are for attributes. Precondition: check() and check_precisions() have passed it.
/// Errors: bad_option, not_on_grid.
Expected<QuantisedMesh> quantise(const MeshView& mesh, const EncodeOptions& options,
                                 unsigned threads);

}  // namespace clers::internal

#endif

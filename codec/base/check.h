// What is wrong with a mesh that a caller hands in, before anything relies on it. Knows the arrays
// alone.
#ifndef CLERS_CODEC_BASE_CHECK_H
#define CLERS_CODEC_BASE_CHECK_H

#include <cstddef>
#include <cstdint>

#include "codec/base/holds_values.h"
#include "codec/base/kind_defect.h"
#include "codec/error.h"
#include "codec/mesh_view.h"

namespace clers::internal {

/// Refuses an attribute that has not `count` values. Error: inconsistent_mesh.
Expected<Done> check_attribute(const AttributeView& a, std::size_t count);

/// Refuses faces whose arrays disagree. Errors: inconsistent_mesh, too_large. Precondition: corners
/// have 32 bits.
Expected<Done> check_arrays(const MeshView& mesh);

}  // namespace clers::internal

#endif

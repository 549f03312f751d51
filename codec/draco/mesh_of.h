// What Draco decodes, as arrays of ours.
#ifndef CLERS_CODEC_DRACO_MESH_OF_H
#define CLERS_CODEC_DRACO_MESH_OF_H

#include <cstdint>
#include <string>

#include "codec/draco/decoded.h"
#include <clers/mesh.h>

namespace clers::draco {

/// Attribute i has its unique id for a name, and a value for each point.
Mesh points_of(const Decoded& decoded);

/// As draco.h has it, without metadata; attribute i of one is attribute i of the other.
Mesh surface_of(const Decoded& decoded);

}  // namespace clers::draco

#endif

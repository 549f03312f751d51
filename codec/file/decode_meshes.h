// All pieces of meshes, by as many threads as there is memory for.
#ifndef CLERS_CODEC_FILE_DECODE_MESHES_H
#define CLERS_CODEC_FILE_DECODE_MESHES_H

#include <span>
#include <vector>

#include "codec/base/budget.h"
#include "codec/error.h"
#include "codec/file/mesh_decoder.h"
#include "codec/file/mesh_reader.h"
#include "codec/mesh.h"
#include "codec/options.h"

namespace clers::internal {

/// Decodes meshes, all of them or only their faces. The limits of `options` are not looked at.
/// Errors: limit, before anything is decoded; invalid.
Expected<std::vector<Mesh>> decode_meshes(std::span<const MeshSections> sections, Values values,
                                          const DecodeOptions& options, Budget& budget);

}  // namespace clers::internal

#endif

// What write() and write_compressed() share.
#ifndef CLERS_CODEC_GLTF_WRITE_FILES_H
#define CLERS_CODEC_GLTF_WRITE_FILES_H

#include <span>
#include <vector>

#include "codec/gltf/gltf.h"

namespace clers::gltf {

/// Writes a scene of which the files, if there are any, hold the meshes.
Expected<Written> write_files(const Scene& scene, std::span<const std::vector<std::byte>> files,
                              const WriteOptions& options);

}  // namespace clers::gltf

#endif

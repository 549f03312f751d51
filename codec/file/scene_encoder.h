// What a scene has besides meshes -> sections. codec/format.md, Arrays, Blobs, Document.
#ifndef CLERS_CODEC_FILE_SCENE_ENCODER_H
#define CLERS_CODEC_FILE_SCENE_ENCODER_H

#include <span>

#include "codec/error.h"
#include "codec/file/container.h"
#include "codec/info.h"
#include "codec/options.h"
#include "codec/order.h"
#include "codec/scene.h"

namespace clers::internal {

/// Refuses what is not as scene.h says. Error: inconsistent_mesh.
Expected<Done> check_scene(const Scene& scene);

/// Sections before those of meshes: the document and metadata. Errors: internal.
Expected<Done> put_before_meshes(const Scene& scene, ContainerWriter& out, SceneInfo& info);

/// Sections after those of meshes: arrays, in which vertices get the numbers that they have in the
/// file, and blobs. One permutation a mesh. Errors: bad_option, not_on_grid; internal.
Expected<Done> put_after_meshes(const Scene& scene, std::span<const Permutation> permutations,
                                const EncodeOptions& options, ContainerWriter& out,
                                SceneInfo& info);

}  // namespace clers::internal

#endif

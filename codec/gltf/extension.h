// The extension CLERS_mesh_compression (CLERS_mesh_compression.md): meshes of a glTF as .clers
// files, and back. Knows JSON and buffers, before or after anything else looks at them.
#ifndef CLERS_CODEC_GLTF_EXTENSION_H
#define CLERS_CODEC_GLTF_EXTENSION_H

#include <span>
#include <vector>

#include "codec/gltf/json.h"
#include "codec/gltf/layout.h"
#include "codec/gltf/plan.h"
#include "codec/gltf/values.h"
#include <clers/error.h>
#include <clers/limits.h>

namespace clers::gltf {

inline constexpr char extension_name[] = "CLERS_mesh_compression";

/// Replaces the values of the plan's meshes by these files, one a mesh.
void compress(const Layout& layout, const Plan& plan, std::span<const std::vector<std::byte>> files,
              Json& document, Buffers& buffers);

/// Replaces what has the extension by values. `empty`: buffers without bytes. Does nothing to a
/// document without it. Errors: malformed; those of decode.
Expected<Done> expand(Json& document, Buffers& buffers, const std::vector<bool>& empty);

}  // namespace clers::gltf

#endif

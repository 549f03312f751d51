// Bytes -> meshes, in one call.
#ifndef CLERS_CODEC_DECODE_H
#define CLERS_CODEC_DECODE_H

#include <cstddef>
#include <span>
#include <vector>

#include <clers/error.h>
#include <clers/mesh.h>
#include <clers/options.h>
#include <clers/scene.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// Decodes all meshes of a .clers file, and nothing else of it, as Decoder::open(bytes, options)
/// and decode() do: see there
/// (<clers/decoder.h>) for errors, cost, exceptions and thread safety, and for all other ways to
/// decode.
Expected<std::vector<Mesh>> decode(std::span<const std::byte> bytes,
                                   const DecodeOptions& options = {});

/// Decodes all that a .clers file holds. The same in all else; besides, what it takes for arrays,
/// blobs and the document is checked against Limits::memory too.
Expected<Scene> decode_scene(std::span<const std::byte> bytes, const DecodeOptions& options = {});

}  // namespace clers

#endif

// Bytes -> meshes, in one call.
#ifndef CLERS_CODEC_DECODE_H
#define CLERS_CODEC_DECODE_H

#include <cstddef>
#include <span>
#include <vector>

#include "codec/error.h"
#include "codec/mesh.h"
#include "codec/options.h"

namespace clers {

/// Decodes all meshes of a .clers file, as Decoder::open(bytes, options) and decode() do: see there
/// (codec/decoder.h) for errors, cost, exceptions and thread safety, and for all other ways to
/// decode.
Expected<std::vector<Mesh>> decode(std::span<const std::byte> bytes,
                                   const DecodeOptions& options = {});

}  // namespace clers

#endif

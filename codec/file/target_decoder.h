// A mesh, or what a caller wants of it, into memory of the caller.
#ifndef CLERS_CODEC_FILE_TARGET_DECODER_H
#define CLERS_CODEC_FILE_TARGET_DECODER_H

#include "codec/base/budget.h"
#include "codec/error.h"
#include "codec/file/mesh_reader.h"
#include "codec/mesh_target.h"
#include "codec/options.h"

namespace clers::internal {

/// Decoder::decode_into of a mesh. The limits of `options` are not looked at.
Expected<Done> decode_into(const MeshSections& mesh, const MeshTarget& target,
                           const DecodeOptions& options, Budget& budget);

}  // namespace clers::internal

#endif

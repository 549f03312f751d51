// Sizes and places that follow from others: a document need not say them.
#ifndef CLERS_CODEC_GLTF_PLACES_H
#define CLERS_CODEC_GLTF_PLACES_H

#include "codec/gltf/json.h"

namespace clers::gltf {

/// Makes null each byteOffset and byteLength that restore_places would find. Precondition: the
/// document has a layout (read_layout).
void shorten_places(Json& document);

/// Puts numbers for what is null: those of a file in which everything follows what is before it.
/// Takes any document.
void restore_places(Json& document);

}  // namespace clers::gltf

#endif

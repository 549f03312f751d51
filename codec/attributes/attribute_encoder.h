// The values of one attribute -> bytes.
#ifndef CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_ENCODER_H
#define CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_ENCODER_H

#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/mesh.h"

namespace clers::internal {

/// Encodes values that are already in the order of the coded mesh. The bytes name and describe the
/// attribute. Twins are not asked for. Errors: internal. Throws std::bad_alloc only.
Expected<Bytes> encode_attribute(const Attribute& attribute, const CodedSurface& surface,
                                 int level);

}  // namespace clers::internal

#endif

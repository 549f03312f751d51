// The values of one attribute -> bytes.
#ifndef CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_ENCODER_H
#define CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_ENCODER_H

#include <vector>

#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/info.h"
#include "codec/mesh.h"
#include "codec/numbers/number_system.h"

namespace clers::internal {

struct EncodedAttribute {
  Bytes bytes;
  AttributeInfo info;
};

/// The first level whose coders use twins.
inline constexpr int first_level_with_twins = 5;

/// Encodes values that are already in the order of the coded mesh. The bytes name and describe the
/// attribute.  Errors: internal. Throws std::bad_alloc only.
Expected<EncodedAttribute> encode_attribute(const Attribute& attribute, const CodedSurface& surface,
                                            int level, const AttributePlan& plan = {});

}  // namespace clers::internal

#endif

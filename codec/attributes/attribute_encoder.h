// The values of one attribute -> bytes.
#ifndef CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_ENCODER_H
#define CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_ENCODER_H

#include <vector>

#include "codec/attributes/number_system.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/info.h"
#include "codec/mesh.h"

namespace clers::internal {

/// What was decided for all pieces of a mesh.
struct AttributePlan {
  std::vector<NumberSystem> systems = {};  ///< one a component; none: they are found
  double error = 0;                        ///< of the values, which are in the systems already
};

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

// The values of one attribute -> bytes.
#ifndef CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_ENCODER_H
#define CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_ENCODER_H

#include <vector>

#include "codec/attributes/coded_faces.h"
#include "codec/attributes/structure_encoder.h"
#include "codec/attributes/structure_format.h"
#include "codec/attributes/value_surface.h"
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

/// Encodes values that are already in the order in which they are coded: those of a structure, or
/// one an element of the coded mesh. The bytes name and describe the attribute. Errors: internal.
/// Throws std::bad_alloc only.
Expected<EncodedAttribute> encode_attribute(const Attribute& attribute,
                                            const StructureHeader& structure,
                                            const ValueSurface& along, int level,
                                            const AttributePlan& plan = {});

/// Which element has which value is found too, in several ways, of which one is kept that takes
/// least. `beside` as for encode_structures, whose result `ways` is.
Expected<EncodedAttribute> encode_attribute(const Attribute& attribute,
                                            std::vector<EncodedStructure> ways,
                                            const CodedFaces& faces, const Attribute* position,
                                            int level, const AttributePlan& plan);

}  // namespace clers::internal

#endif

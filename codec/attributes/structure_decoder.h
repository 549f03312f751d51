// A structure -> which element has which value; and values spread over elements.
#ifndef CLERS_CODEC_ATTRIBUTES_STRUCTURE_DECODER_H
#define CLERS_CODEC_ATTRIBUTES_STRUCTURE_DECODER_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/attributes/coded_faces.h"
#include "codec/attributes/structure.h"
#include "codec/error.h"
#include "codec/mesh.h"

namespace clers::internal {

/// Precondition: there is a structure. Errors: invalid. Throws std::bad_alloc only.
Expected<ValueStructure> decode_structure(const StructureHeader& header, const CodedFaces& faces,
                                          Domain domain, const Seams* beside);

/// Makes an attribute of the values that were coded: by index, or one an element. `at`: of the
/// attribute in the file. Errors: invalid.
Expected<Done> spread_values(const StructureHeader& header, std::uint64_t at,
                             std::vector<std::uint32_t> value_of, Attribute& attribute);

/// Bytes that it takes besides the coded values, and the attribute that it makes.
std::uint64_t spreading_memory(const StructureHeader& header);

/// Numbers the values of an attribute by index as in the input, if that was kept; else by first
/// use. Elements are in their final order. Errors: invalid.
Expected<Done> number_values_by_use(const StructureHeader& header, Attribute& attribute);

/// Bytes that it takes besides the attribute.
std::uint64_t numbering_by_use_memory(const StructureHeader& header, std::uint64_t value_size);

}  // namespace clers::internal

#endif

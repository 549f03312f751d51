// Which element has which value -> a structure, and the values that are left to be coded.
#ifndef CLERS_CODEC_ATTRIBUTES_STRUCTURE_ENCODER_H
#define CLERS_CODEC_ATTRIBUTES_STRUCTURE_ENCODER_H

#include <vector>

#include "codec/attributes/coded_faces.h"
#include "codec/attributes/structure.h"
#include "codec/entropy/bytes.h"
#include "codec/mesh.h"

namespace clers::internal {

/// One way to say which element has which value.
struct EncodedStructure {
  StructureHeader header;  ///< its streams are the bytes below
  Bytes stream, numbering;
  ValueStructure structure;
  Bytes values;  ///< those that are coded, in order
};

/// The ways that are worth a try, at least one; the first may be none at all (header.any is false,
/// and the values are the attribute's). Elements are in the order of the coded faces. `numbering`:
/// which number each value had in the input, where that is kept (kept_numbering). `beside`: seams
/// of an earlier attribute, or nullptr. Cost: linear; from level 5 on, and where values are by
/// index, n log n.
std::vector<EncodedStructure> encode_structures(const Attribute& attribute, const CodedFaces& faces,
                                                const std::vector<std::uint32_t>& numbering,
                                                const Seams* beside, int level);

/// Which numbers the values of an attribute have in the order of their first use, and then those
/// that are not used; empty if these are 0, 1, 2 ..
std::vector<std::uint32_t> kept_numbering(std::span<const std::uint32_t> indices,
                                          std::size_t values);

}  // namespace clers::internal

#endif

// The bytes of one attribute -> its values, in two steps. What needs no connectivity can be read
// beside it; values need all of it.
#ifndef CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_DECODER_H
#define CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_DECODER_H

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "codec/attributes/attribute_format.h"
#include "codec/attributes/hexagon.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/mesh.h"
#include "codec/numbers/lattice.h"
#include "codec/numbers/number_decoder.h"

namespace clers::internal {

// `count` is how many values are coded: header.values(elements).

/// Whether what follows the header can hold `count` values, as far as can be seen without decoding
/// them. Errors: invalid.
Expected<Done> check_values(std::span<const std::byte> bytes, std::uint64_t at,
                            const AttributeHeader& header, std::uint64_t count);

/// What the numbers of the values are, in words (AttributeInfo::numbers). Errors: truncated,
/// invalid.
Expected<std::string> describe_numbers(std::span<const std::byte> bytes, std::uint64_t at,
                                       const AttributeHeader& header, std::uint64_t count);

/// Bytes that this takes besides the words.
std::uint64_t describing_memory(std::span<const std::byte> bytes, const AttributeHeader& header,
                                std::uint64_t count);

/// An attribute of which all is read that needs no faces.
struct BegunAttribute {
  Bytes words;                          ///< residuals, of those that are no integers
  std::optional<NumberReader> numbers;  ///< of all others,
  Rows rows;                            ///< with residuals, where these need no faces
  OrderPredictor predictor = OrderPredictor::previous;  ///< of ordered ones
};
/// Precondition: check_values. Errors: truncated, invalid. Throws std::bad_alloc only.
Expected<BegunAttribute> begin_attribute(std::span<const std::byte> bytes, std::uint64_t at,
                                         const AttributeHeader& header, std::uint64_t count);

/// Makes the values that are coded, in their order. `bytes` are the same, `along` has what
/// along(header) says. Errors: invalid. Throws std::bad_alloc only.
Expected<Attribute> finish_attribute(std::span<const std::byte> bytes, std::uint64_t at,
                                     const AttributeHeader& header, std::uint64_t count,
                                     BegunAttribute begun, const ValueSurface& along);

/// What a surface has.
struct SurfaceSize {
  std::uint64_t vertices = 0, triangles = 0;
  std::uint64_t positions = 0;  ///< vertices of the mesh
};

/// Bytes that this takes, at most.
struct AttributeMemory {
  std::uint64_t begun = 0;      ///< what is in a BegunAttribute
  std::uint64_t beginning = 0;  ///< besides, while it is made
  std::uint64_t finishing = 0;  ///< besides it and the values, while they are made
};
AttributeMemory decoding_memory(std::span<const std::byte> bytes, const AttributeHeader& header,
                                std::uint64_t count, SurfaceSize surface);

}  // namespace clers::internal

#endif

// The values of one attribute <-> bytes: predicted, split into planes of bytes, and left to zstd.
#ifndef CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_H
#define CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_H

#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/mesh.h"

namespace clers::internal {

/// How a value is guessed from those before. The numbers are the file format's.
enum class Predictor : std::uint8_t {
  none = 0,
  previous = 1,       ///< the value before
  parallelogram = 2,  ///< vertex attributes: from the triangle across the gate
};

/// Encodes values that are already in the order of the coded mesh. `corners` is the coded index
/// buffer. The bytes name and describe the attribute. Throws std::bad_alloc only.
Expected<Bytes> encode_attribute(const Attribute& attribute, std::span<const std::uint32_t> corners,
                                 int level);

/// What stands before the values.
struct AttributeHeader {
  Attribute attribute;  ///< without data
  Predictor predictor = Predictor::none;
  std::size_t bytes = 0;  ///< that the header takes
};
Expected<AttributeHeader> read_attribute_header(std::span<const std::byte> bytes, std::uint64_t at);

/// Whether what follows the header is one zstd frame that can hold `count` values, as far as it can
/// be told without unpacking it. Errors: invalid.
Expected<Done> check_values(std::span<const std::byte> bytes, std::uint64_t at,
                            const AttributeHeader& header, std::uint64_t count);

/// Decodes `count` values. Memory: `count` times the stride for them, and `decoding_memory`
/// besides. Precondition: check_values. Errors: invalid. Throws std::bad_alloc only.
Expected<Attribute> decode_attribute(std::span<const std::byte> bytes, std::uint64_t at,
                                     AttributeHeader header, std::uint64_t count,
                                     std::span<const std::uint32_t> corners);
std::uint64_t decoding_memory(const AttributeHeader& header, std::uint64_t count);

}  // namespace clers::internal

#endif

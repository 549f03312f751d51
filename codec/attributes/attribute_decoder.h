// The bytes of one attribute -> its values, in two steps. Residuals need no connectivity, so they
// can be decoded beside it; values need all of it.
#ifndef CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_DECODER_H
#define CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_DECODER_H

#include <cstdint>
#include <span>

#include "codec/attributes/attribute_format.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/mesh.h"

namespace clers::internal {

/// Whether what follows the header is one zstd frame that can hold `count` values, as far as can
/// be seen without unpacking it. Errors: invalid.
Expected<Done> check_values(std::span<const std::byte> bytes, std::uint64_t at,
                            const AttributeHeader& header, std::uint64_t count);

/// Decodes the residuals of `count` values: as many bytes as the values have. While it runs, as
/// many again. Precondition: check_values. Errors: invalid. Throws std::bad_alloc only.
Expected<Bytes> decode_residuals(std::span<const std::byte> bytes, std::uint64_t at,
                                 const AttributeHeader& header, std::uint64_t count);

/// Makes the values of residuals, in as many bytes. Throws std::bad_alloc only.
Attribute reconstruct(const AttributeHeader& header, Bytes residuals, const CodedSurface& surface);

/// Bytes that either step takes besides what it is given and returns.
inline std::uint64_t decoding_memory(const AttributeHeader& header, std::uint64_t count) {
  return count * header.attribute.stride();
}

}  // namespace clers::internal

#endif

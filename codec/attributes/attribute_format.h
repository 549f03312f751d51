// What stands before the values of an attribute: its name and kind <-> bytes.
#ifndef CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_FORMAT_H
#define CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_FORMAT_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "codec/attributes/prediction.h"
#include "codec/base/utf8.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/mesh.h"

namespace clers::internal {

struct AttributeHeader {
  Attribute attribute;  ///< without data
  Predictor predictor = Predictor::none;
  std::size_t bytes = 0;  ///< that the header takes
};

inline void put_attribute_header(Bytes& out, const Attribute& attribute, Predictor predictor) {
  put_u8(out, static_cast<std::uint32_t>(attribute.name.size()));
  put_bytes(out, std::as_bytes(std::span(attribute.name)));
  put_u8(out, static_cast<std::uint32_t>(attribute.domain));
  put_u8(out, static_cast<std::uint32_t>(attribute.scalar));
  put_u8(out, attribute.components);
  put_u8(out, static_cast<std::uint32_t>(predictor));
}

/// Reads and checks what put_attribute_header wrote. `at` is the offset of `bytes` in the file, for
/// errors: truncated, invalid.
inline Expected<AttributeHeader> read_attribute_header(std::span<const std::byte> bytes,
                                                       std::uint64_t at) {
  ByteReader in(bytes, at);
  AttributeHeader header;
  const auto name = in.take(in.u8());
  const std::uint32_t domain = in.u8(), scalar = in.u8(), components = in.u8(), predictor = in.u8();
  if (!in.ok()) return Failure{in.error()};
  const auto invalid = [&](const char* what, std::uint32_t value) {
    return fail(ErrorCode::invalid, Place::byte, at,
                "an attribute with " + std::string(what) + " " + std::to_string(value));
  };
  if (domain > static_cast<std::uint32_t>(Domain::face)) return invalid("domain", domain);
  if (scalar >= scalar_count) return invalid("scalar type", scalar);
  if (components == 0) return invalid("components", components);
  if (predictor > static_cast<std::uint32_t>(Predictor::parallelogram) ||
      (predictor == static_cast<std::uint32_t>(Predictor::parallelogram) &&
       domain != static_cast<std::uint32_t>(Domain::vertex)))
    return invalid("predictor", predictor);
  header.attribute.name.assign(reinterpret_cast<const char*>(name.data()), name.size());
  if (const std::size_t i = first_not_utf8(header.attribute.name); i < name.size())
    return fail(ErrorCode::invalid, Place::byte, at + 1 + i, "the name is not UTF-8 from here");
  header.attribute.domain = static_cast<Domain>(domain);
  header.attribute.scalar = static_cast<Scalar>(scalar);
  header.attribute.components = static_cast<std::uint8_t>(components);
  header.predictor = static_cast<Predictor>(predictor);
  header.bytes = in.position();
  return header;
}

}  // namespace clers::internal

#endif

#include <zstd.h>

#include <new>
#include <string>

#include "codec/attribute_format.h"

namespace clers {
namespace {

/// A block of zstd makes 128 KiB of 4 bytes at best.
constexpr std::uint64_t max_expansion = 32768;

template <class U>
void restore(std::span<const std::byte> planes, const AttributeHeader& header, std::size_t count,
             std::span<const std::uint32_t> corners, std::span<std::byte> out) {
  const std::size_t components = header.attribute.components;
  std::vector<U> keys(count * components);
  std::size_t row = 0;
  for_each_value(header.predictor, count, corners, [&](std::size_t v, Guess g) {
    for (std::size_t c = 0; c < components; ++c) {
      U stored = 0;
      for (std::size_t byte = 0; byte < sizeof(U); ++byte)
        stored = static_cast<U>(
            stored | static_cast<U>(std::to_integer<U>(planes[(c * sizeof(U) + byte) * count + row])
                                    << 8 * byte));
      if (g.a != v) {
        const U guess = static_cast<U>(keys[g.a * components + c] + keys[g.b * components + c] -
                                       keys[g.c * components + c]);
        stored = static_cast<U>(guess + unzigzag(stored));
      }
      keys[v * components + c] = stored;
    }
    ++row;
  });
  if (is_float(header.attribute.scalar))
    for (U& k : keys) k = from_ordered(k);
  if (!keys.empty()) std::memcpy(out.data(), keys.data(), out.size());
}

}  // namespace

Expected<AttributeHeader> read_attribute_header(std::span<const std::byte> bytes,
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
  header.attribute.domain = static_cast<Domain>(domain);
  header.attribute.scalar = static_cast<Scalar>(scalar);
  header.attribute.components = static_cast<std::uint8_t>(components);
  header.predictor = static_cast<Predictor>(predictor);
  header.bytes = in.position();
  return header;
}

Expected<Attribute> decode_attribute(std::span<const std::byte> bytes, std::uint64_t at,
                                     AttributeHeader header, std::uint64_t count,
                                     std::span<const std::uint32_t> corners) {
  const std::span<const std::byte> packed = bytes.subspan(header.bytes);
  const auto invalid = [&](std::string what) {
    return fail(ErrorCode::invalid, Place::byte, at + header.bytes, std::move(what));
  };
  const std::uint64_t size = count * header.attribute.stride();
  if (size > max_expansion * packed.size())
    return invalid(std::to_string(size) + " bytes of values cannot come from " +
                   std::to_string(packed.size()));
  Bytes planes(static_cast<std::size_t>(size));
  const std::size_t got =
      ZSTD_decompress(planes.data(), planes.size(), packed.data(), packed.size());
  if (ZSTD_isError(got)) return invalid(std::string("zstd: ") + ZSTD_getErrorName(got));
  if (got != size)
    return invalid("the values take " + std::to_string(got) + " bytes, expected " +
                   std::to_string(size));
  Attribute attribute = header.attribute;
  attribute.data.resize(planes.size());
  with_word(attribute.scalar, [&](auto word) {
    restore<decltype(word)>(planes, header, static_cast<std::size_t>(count), corners,
                            attribute.data);
  });
  return attribute;
}

}  // namespace clers

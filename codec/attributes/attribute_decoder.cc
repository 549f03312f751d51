#include <string>

#include "codec/attributes/attribute_format.h"
#include "codec/base/utf8.h"

namespace clers::internal {
namespace {

/// Words in bytes.
template <class U>
class Words {
 public:
  explicit Words(std::span<std::byte> bytes) : bytes_(bytes.data()) {}
  U operator[](std::size_t i) const {
    U word;
    std::memcpy(&word, bytes_ + i * sizeof(U), sizeof(U));
    return word;
  }
  void set(std::size_t i, U word) { std::memcpy(bytes_ + i * sizeof(U), &word, sizeof(U)); }

 private:
  std::byte* bytes_;
};

template <class U>
void restore(std::span<const std::byte> planes, const AttributeHeader& header, std::size_t count,
             std::span<const std::uint32_t> corners, std::span<std::byte> out) {
  const std::size_t components = header.attribute.components;
  Words<U> keys(out);
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
      keys.set(v * components + c, stored);
    }
    ++row;
  });
  if (is_float(header.attribute.scalar))
    for (std::size_t i = 0; i < count * components; ++i) keys.set(i, from_ordered(keys[i]));
}

std::string unlike(std::uint64_t size, std::uint64_t expected) {
  return "the values take " + std::to_string(size) + " bytes, expected " + std::to_string(expected);
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
  if (const std::size_t i = first_not_utf8(header.attribute.name); i < name.size())
    return fail(ErrorCode::invalid, Place::byte, at + 1 + i, "the name is not UTF-8 from here");
  header.attribute.domain = static_cast<Domain>(domain);
  header.attribute.scalar = static_cast<Scalar>(scalar);
  header.attribute.components = static_cast<std::uint8_t>(components);
  header.predictor = static_cast<Predictor>(predictor);
  header.bytes = in.position();
  return header;
}

Expected<Done> check_values(std::span<const std::byte> bytes, std::uint64_t at,
                            const AttributeHeader& header, std::uint64_t count) {
  return check_frame(bytes.subspan(header.bytes), at + header.bytes,
                     count * header.attribute.stride(), "the values");
}

std::uint64_t decoding_memory(const AttributeHeader& header, std::uint64_t count) {
  return count * header.attribute.stride() + count / 8 + 8;
}

Expected<Attribute> decode_attribute(std::span<const std::byte> bytes, std::uint64_t at,
                                     AttributeHeader header, std::uint64_t count,
                                     std::span<const std::uint32_t> corners) {
  const std::span<const std::byte> packed = bytes.subspan(header.bytes);
  const auto invalid = [&](std::string what) {
    return fail(ErrorCode::invalid, Place::byte, at + header.bytes, std::move(what));
  };
  const std::uint64_t size = count * header.attribute.stride();
  Bytes planes(static_cast<std::size_t>(size));
  const std::size_t got =
      zstd_result(ZSTD_decompress(planes.data(), planes.size(), packed.data(), packed.size()));
  if (ZSTD_isError(got)) return invalid(std::string("zstd: ") + ZSTD_getErrorName(got));
  if (got != size) return invalid(unlike(got, size));
  Attribute attribute = header.attribute;
  attribute.data.resize(planes.size());
  with_word(attribute.scalar, [&](auto word) {
    restore<decltype(word)>(planes, header, static_cast<std::size_t>(count), corners,
                            attribute.data);
  });
  return attribute;
}

}  // namespace clers::internal

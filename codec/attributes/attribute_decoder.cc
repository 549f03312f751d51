// Residuals beside connectivity, where they need none of it; then integers, then values.
#include "codec/attributes/attribute_decoder.h"

#include <algorithm>
#include <string>
#include <utility>

#include "codec/attributes/integer_planes.h"
#include "codec/attributes/planes.h"
#include "codec/attributes/ranks.h"

namespace clers::internal {
namespace {

WordShape shape_of(const AttributeHeader& header) {
  return {header.attribute.scalar, header.attribute.components};
}

/// Values of the words that planes hold.
Attribute words_of(const AttributeHeader& header, Bytes residuals, const CodedSurface& surface) {
  Attribute attribute = header.attribute;
  if (in_order_of_values(header.predictor))
    attribute.data = std::move(residuals);
  else
    attribute.data.resize(residuals.size());
  Bytes& words = attribute.data;
  if (header.predictor != Predictor::none)
    add_predictions(header.predictor, shape_of(header), surface,
                    residuals.empty() ? words : residuals, words);
  if (is_float(attribute.scalar))
    with_word(attribute.scalar, [&](auto word) {
      using U = decltype(word);
      for (std::size_t i = 0; i < words.size() / sizeof(U); ++i)
        set_word(words.data(), i, from_ordered(word_at<U>(words.data(), i)));
    });
  return attribute;
}

/// Rows of `count` values.
Rows make_rows(const AttributeHeader& header, std::size_t count) {
  const std::size_t n = count * header.attribute.components;
  if (header.narrow) return std::vector<std::int32_t>(n);
  return std::vector<std::int64_t>(n);
}

}  // namespace

Expected<Done> check_values(std::span<const std::byte> bytes, std::uint64_t at,
                            const AttributeHeader& header, std::uint64_t count) {
  if (header.coder != Coder::words) return Done{};
  return check_frame(bytes.subspan(header.bytes), at + header.bytes,
                     count * header.attribute.stride(), "the values");
}

Expected<std::string> describe_numbers(std::span<const std::byte> bytes, std::uint64_t at,
                                       const AttributeHeader& header, std::uint64_t count) {
  if (header.coder == Coder::words) return std::string(words_text);
  ByteReader in(bytes.subspan(header.bytes), at + header.bytes);
  const auto numbers =
      NumberReader::read(in, header.attribute.scalar, header.attribute.components, count);
  if (!numbers) return Failure{numbers.error()};
  return in_words(numbers->numbers());
}

Expected<BegunAttribute> begin_attribute(std::span<const std::byte> bytes, std::uint64_t at,
                                         const AttributeHeader& header, std::uint64_t count) {
  BegunAttribute begun;
  if (header.coder == Coder::words) {
    begun.words.resize(static_cast<std::size_t>(count) * header.attribute.stride());
    if (auto ok = unpack_planes(bytes.subspan(header.bytes), at + header.bytes, shape_of(header),
                                begun.words);
        !ok)
      return Failure{ok.error()};
    return begun;
  }
  ByteReader in(bytes.subspan(header.bytes), at + header.bytes);
  auto numbers =
      NumberReader::read(in, header.attribute.scalar, header.attribute.components, count);
  if (!numbers) return Failure{numbers.error()};
  if (numbers->numbers().narrow() != header.narrow)
    return fail(ErrorCode::invalid, Place::byte, at,
                "integers of another size than the attribute says");
  begun.position = header.bytes + in.position();
  begun.numbers = std::move(*numbers);
  if (!header.begins_without_faces()) return begun;
  begun.rows = make_rows(header, static_cast<std::size_t>(count));
  const auto coded = bytes.subspan(begun.position);
  const auto ok = std::visit(
      [&](auto& rows) -> Expected<Done> {
        return unpack_integers(coded, at + begun.position, header.attribute.components,
                               std::span(rows));
      },
      begun.rows);
  if (!ok) return Failure{ok.error()};
  return begun;
}

Expected<Attribute> finish_attribute(std::span<const std::byte> bytes, std::uint64_t at,
                                     const AttributeHeader& header, std::uint64_t count,
                                     BegunAttribute begun, const CodedSurface& surface) {
  if (header.coder == Coder::words) return words_of(header, std::move(begun.words), surface);
  if (!header.begins_without_faces())
    begun.rows = make_rows(header, static_cast<std::size_t>(count));
  const std::vector<Axis>& axes = begun.numbers->numbers().axes;
  const auto coded = bytes.subspan(begun.position);
  Attribute attribute = header.attribute;
  const auto ok = std::visit(
      [&](auto& rows) -> Expected<Done> {
        if (auto done = add_to_integers(header.predictor, surface, with_ranks(axes), at, rows);
            !done)
          return done;
        ranks_to_integers(axes, std::span(rows));
        attribute.data.resize(static_cast<std::size_t>(count) * attribute.stride());
        return begun.numbers->to_values(rows, attribute.data);
      },
      begun.rows);
  if (!ok) return Failure{ok.error()};
  return attribute;
}

AttributeMemory decoding_memory(const AttributeHeader& header, std::uint64_t count) {
  const std::uint64_t size = count * header.attribute.stride();
  if (header.coder == Coder::words) return {size, size, 0};
  const std::uint64_t integers = count * header.attribute.components *
                                 (header.narrow ? sizeof(std::int32_t) : sizeof(std::int64_t)),
                      numbers = NumberReader::memory(header.attribute.components, count);
  if (header.coder == Coder::planes) return {numbers + integers, integers, integers};
  return {numbers + integers, integers, integers};
}

}  // namespace clers::internal

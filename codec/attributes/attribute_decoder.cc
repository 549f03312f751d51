// Residuals beside connectivity, where they need none of it; then integers, then values.
#include "codec/attributes/attribute_decoder.h"

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>

#include "codec/attributes/charts.h"
#include "codec/attributes/integer_planes.h"
#include "codec/attributes/joints.h"
#include "codec/attributes/mixed_coder.h"
#include "codec/attributes/named_values_decoder.h"
#include "codec/attributes/normal_values_decoder.h"
#include "codec/attributes/ordered_integers.h"
#include "codec/attributes/planes.h"
#include "codec/attributes/sized_positions.h"
#include "codec/attributes/weights.h"
#include "codec/numbers/ranks.h"

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

/// What codes the integers.
std::span<const std::byte> integers_of(std::span<const std::byte> bytes,
                                       const AttributeHeader& header) {
  return bytes.subspan(header.bytes + static_cast<std::size_t>(header.numbers_size));
}

/// What stands before that.
std::span<const std::byte> numbers_of(std::span<const std::byte> bytes,
                                      const AttributeHeader& header) {
  return bytes.subspan(header.bytes, static_cast<std::size_t>(header.numbers_size));
}

Expected<NumberReader> read_numbers(std::span<const std::byte> bytes, std::uint64_t at,
                                    const AttributeHeader& header, std::uint64_t count) {
  ByteReader in(numbers_of(bytes, header), at + header.bytes);
  auto numbers =
      NumberReader::read(in, header.attribute.scalar, header.attribute.components, count);
  if (numbers && in.left() > 0)
    return fail(ErrorCode::invalid, Place::byte, in.offset(), "bytes after the numbers");
  return numbers;
}

template <class Int>
Lattice<Int> lattice_of(std::vector<Int>& rows, std::span<const Axis> axes) {
  return {rows, axes};
}

/// Rows of `count` values.
Rows make_rows(const Numbers& numbers, std::size_t count) {
  const std::size_t n = count * numbers.axes.size();
  if (numbers.narrow()) return std::vector<std::int32_t>(n);
  return std::vector<std::int64_t>(n);
}

/// Integers of residuals, or of what codes them along the surface.
template <class Int>
Expected<Done> finish_integers(const AttributeHeader& header, const Numbers& numbers,
                               OrderPredictor predictor, std::span<const std::byte> coded,
                               std::uint64_t at, const ValueSurface& along,
                               const Lattice<Int>& lattice) {
  if (header.coder == Coder::normals) {
    if (!may_be_normals(numbers, along))
      return fail(ErrorCode::invalid, Place::byte, at,
                  "a coder of normals for numbers that are none, or without positions");
    return decode_normals<Int>(coded, at, numbers, along, lattice.rows);
  }
  if (header.coder == Coder::charts)
    return decode_charts<Int>(coded, at, numbers.axes, along, lattice.rows);
  if (header.coder == Coder::weights || header.coder == Coder::skin) {
    ValueSurface surface = surface_of(header, lattice.count(), along);
    if (header.coder == Coder::weights) surface.joints = nullptr;
    if (header.coder == Coder::skin && surface.joints == nullptr)
      return fail(ErrorCode::invalid, Place::byte, at, "weights of joints that are not there");
    return decode_weights<Int>(coded, at, numbers, surface, lattice.rows);
  }
  if (header.coder == Coder::joints) {
    if constexpr (std::is_same_v<Int, std::int32_t>)
      return decode_joints(coded, at, numbers.axes, surface_of(header, lattice.count(), along),
                           lattice.rows);
    return fail(ErrorCode::invalid, Place::byte, at, "joints of too many bits");
  }
  const CodedSurface& surface = along.surface;
  if (header.coder == Coder::mixed) return decode_mixed(coded, at, surface, lattice);
  if (header.coder == Coder::sized) return decode_sized_positions(coded, at, surface, lattice);
  if (header.coder == Coder::named)
    return decode_named_values(coded, at, lattice.axes, surface_of(header, lattice.count(), along),
                               lattice.rows, header.coded_domain());
  const bool of_vertices = header.coded_domain() == Domain::vertex;
  const std::vector<Axis> axes = with_ranks(lattice.axes);
  const Lattice<Int> ranks{lattice.rows, axes};
  const auto ok = header.coder == Coder::planes
                      ? add_to_integers(header.predictor, surface, at, ranks)
                      : add_steps(predictor, of_vertices ? surface : CodedSurface{}, at, ranks);
  if (!ok) return ok;
  ranks_to_integers(lattice);
  return Done{};
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
  const auto numbers = read_numbers(bytes, at, header, count);
  if (!numbers) return Failure{numbers.error()};
  return in_words(numbers->numbers());
}

std::uint64_t describing_memory(std::span<const std::byte> bytes, const AttributeHeader& header,
                                std::uint64_t count) {
  if (header.coder == Coder::words) return 0;
  return NumberReader::memory(numbers_of(bytes, header), header.attribute.scalar,
                              header.attribute.components, count);
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
  auto numbers = read_numbers(bytes, at, header, count);
  if (!numbers) return Failure{numbers.error()};
  if (numbers->numbers().narrow() != header.narrow)
    return fail(ErrorCode::invalid, Place::byte, at,
                "integers of another size than the attribute says");
  begun.numbers = std::move(*numbers);
  if (!header.begins_without_faces()) return begun;
  begun.rows = make_rows(begun.numbers->numbers(), static_cast<std::size_t>(count));
  const auto coded = integers_of(bytes, header);
  const std::uint64_t coded_at = at + bytes.size() - coded.size();
  const std::vector<Axis> axes = with_ranks(begun.numbers->numbers().axes);
  const auto ok = std::visit(
      [&](auto& rows) -> Expected<Done> {
        const auto lattice = lattice_of(rows, axes);
        if (header.coder == Coder::planes) return unpack_integers(coded, coded_at, lattice);
        auto predictor = decode_residuals(coded, coded_at, lattice);
        if (!predictor) return Failure{predictor.error()};
        begun.predictor = *predictor;
        return Done{};
      },
      begun.rows);
  if (!ok) return Failure{ok.error()};
  return begun;
}

Expected<Attribute> finish_attribute(std::span<const std::byte> bytes, std::uint64_t at,
                                     const AttributeHeader& header, std::uint64_t count,
                                     BegunAttribute begun, const ValueSurface& along) {
  if (header.coder == Coder::words) return words_of(header, std::move(begun.words), along.surface);
  if (!header.begins_without_faces())
    begun.rows = make_rows(begun.numbers->numbers(), static_cast<std::size_t>(count));
  const std::vector<Axis>& axes = begun.numbers->numbers().axes;
  const auto coded = integers_of(bytes, header);
  const std::uint64_t coded_at = at + bytes.size() - coded.size();
  Attribute attribute = header.attribute;
  const auto ok = std::visit(
      [&](auto& rows) -> Expected<Done> {
        const auto lattice = lattice_of(rows, axes);
        if (auto done = finish_integers(header, begun.numbers->numbers(), begun.predictor, coded,
                                        coded_at, along, lattice);
            !done)
          return done;
        attribute.data.resize(static_cast<std::size_t>(count) * attribute.stride());
        return begun.numbers->to_values(rows, attribute.data);
      },
      begun.rows);
  if (!ok) return Failure{ok.error()};
  return attribute;
}

AttributeMemory decoding_memory(std::span<const std::byte> bytes, const AttributeHeader& header,
                                std::uint64_t count, SurfaceSize surface) {
  const std::uint64_t size = count * header.attribute.stride();
  if (header.coder == Coder::words) return {size, size, 0};
  const std::uint64_t integers = count * header.attribute.components *
                                 (header.narrow ? sizeof(std::int32_t) : sizeof(std::int64_t)),
                      numbers =
                          NumberReader::memory(numbers_of(bytes, header), header.attribute.scalar,
                                               header.attribute.components, count);
  if (header.begins_without_faces())
    return {numbers + integers,
            header.coder == Coder::planes ? integers
                                          : residuals_memory(count, header.attribute.components),
            header.coder == Coder::planes ? integers : 0};
  const std::uint64_t coding =
      header.coder == Coder::named
          ? named_values_memory(count, header.attribute.components, surface.vertices)
      : header.coder == Coder::weights || header.coder == Coder::skin
          ? weights_memory(count, header.attribute.components, surface.vertices)
      : header.coder == Coder::joints
          ? joints_memory(count, header.attribute.components, surface.vertices)
      : header.coder == Coder::normals ? normals_memory(count, surface.positions)
      : header.coder == Coder::charts
          ? charts_memory(count, header.attribute.components, surface.positions)
      : header.coder == Coder::sized
          ? sized_positions_memory(integers_of(bytes, header), count, surface.triangles)
          : mixed_memory(count, surface.triangles);
  return {numbers, 0, integers + coding};
}

}  // namespace clers::internal

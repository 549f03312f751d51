#include "codec/attributes/structure_decoder.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "codec/attributes/distinct_values.h"
#include "codec/entropy/stream.h"

namespace clers::internal {

Expected<ValueStructure> decode_structure(const StructureHeader& header, const CodedFaces& faces,
                                          Domain domain, const Seams* beside) {
  ValueStructure structure;
  structure.value_of.resize(faces.count(domain));
  auto ok = decode_stream(header.stream, "the wedges", [&](DecodeFrom& coder) -> std::string {
    UnknownElements elements;
    if (code_structure(coder, header, faces, domain, header.beside ? beside : nullptr, elements,
                       structure))
      return {};
    return "elements have not the " + std::to_string(header.values) + " values that are declared";
  });
  if (!ok) return Failure{ok.error()};
  return structure;
}

namespace {

/// Gives each element that has one a value of its own, and keeps those that none has.
Expected<Done> set_apart(const StructureHeader& header, std::uint64_t at, Attribute& attribute) {
  const std::size_t stride = attribute.stride(),
                    used = static_cast<std::size_t>(header.values - header.unused);
  const auto having =
      attribute.indices.size() - static_cast<std::size_t>(std::count(
                                     attribute.indices.begin(), attribute.indices.end(), no_value));
  if (having != header.distinct - header.unused)
    return fail(ErrorCode::invalid, Place::byte, at,
                std::to_string(having) + " elements have values of their own where " +
                    std::to_string(header.distinct - header.unused) + " are declared");
  std::vector<std::byte> data(static_cast<std::size_t>(header.distinct) * stride);
  std::uint32_t next = 0;
  for (std::uint32_t& i : attribute.indices) {
    if (i == no_value) continue;
    std::memcpy(data.data() + next * stride, attribute.data.data() + i * stride, stride);
    i = next++;
  }
  std::copy(attribute.data.begin() + static_cast<std::ptrdiff_t>(used * stride),
            attribute.data.end(), data.begin() + static_cast<std::ptrdiff_t>(next * stride));
  attribute.data = std::move(data);
  return Done{};
}

}  // namespace

Expected<Done> spread_values(const StructureHeader& header, std::uint64_t at,
                             std::vector<std::uint32_t> value_of, Attribute& attribute) {
  const std::size_t stride = attribute.stride();
  if (!header.indexed) {
    std::vector<std::byte> data(value_of.size() * stride);
    std::byte* to = data.data();
    for (const std::uint32_t v : value_of) {
      std::memcpy(to, attribute.data.data() + v * stride, stride);
      to += stride;
    }
    attribute.data = std::move(data);
    return Done{};
  }
  attribute.indices = std::move(value_of);
  if (header.apart) return set_apart(header, at, attribute);
  if (header.sharing != Sharing::equal) return Done{};
  // Values that are used, without those that equal an earlier one; then the others.
  const std::size_t used = static_cast<std::size_t>(header.values - header.unused);
  std::vector<std::byte>& data = attribute.data;
  const std::vector<std::uint32_t> numbers =
      distinct_values(std::span(data).first(used * stride), stride);
  std::size_t count = 0;
  for (std::size_t i = 0; i < header.values; ++i) {
    if (i < used && numbers[i] < count) continue;
    std::memmove(data.data() + count++ * stride, data.data() + i * stride, stride);
  }
  if (count != header.distinct)
    return fail(ErrorCode::invalid, Place::byte, at,
                std::to_string(count) + " distinct values where " +
                    std::to_string(header.distinct) + " are declared");
  data.resize(count * stride);
  for (std::uint32_t& i : attribute.indices)
    if (i != no_value) i = numbers[i];
  return Done{};
}

std::uint64_t spreading_memory(const StructureHeader& header) {
  return header.sharing == Sharing::equal ? 8 * header.values : 0;
}

Expected<Done> number_values_by_use(const StructureHeader& header, Attribute& attribute) {
  std::vector<std::uint32_t> numbers;
  if (header.numbered) {
    numbers.resize(attribute.value_count());
    auto ok = decode_stream(header.numbering, "the numbers of values",
                            [&](DecodeFrom& coder) -> std::string {
                              if (NumberingCoder().code(coder, numbers)) return {};
                              return "values have no number, or one that is another's";
                            });
    if (!ok) return ok;
  }
  number_by_first_use(attribute, numbers);
  return Done{};
}

std::uint64_t numbering_by_use_memory(const StructureHeader& header, std::uint64_t value_size) {
  return header.distinct * (value_size + 8) + header.distinct / 8 + 8;
}

}  // namespace clers::internal

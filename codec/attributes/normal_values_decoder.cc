#include "codec/attributes/normal_values_decoder.h"

#include <algorithm>
#include <string>

#include "codec/attributes/normal_values.h"
#include "codec/base/portable.h"
#include "codec/entropy/bytes.h"
#include "codec/entropy/lanes.h"
#include "codec/entropy/stream.h"

namespace clers::internal {

bool may_be_normals(const Numbers& numbers, const ValueSurface& along) {
  // Of floats with a varying number of digits k says too little.
  const bool plain =
      std::none_of(numbers.systems.begin(), numbers.systems.end(), [](const NumberSystem& s) {
        return s.map == NumberMap::digits || s.map == NumberMap::binary;
      });
  const bool three = plain && numbers.axes.size() == 3 &&
                     (is_float(numbers.scalar) || clers::size_of(numbers.scalar) <= 2);
  return (numbers.octahedral_bits() > 0 || three) && along.position != nullptr &&
         along.position->components == 3;
}

template <class Int>
Expected<Done> decode_normals(std::span<const std::byte> bytes, std::uint64_t at,
                              const Numbers& numbers, const ValueSurface& along,
                              std::span<Int> rows) {
  const DoublePrecision doubles;
  const auto invalid = [&](std::string what) {
    return fail(ErrorCode::invalid, Place::byte, at, std::move(what));
  };
  if (!may_be_normals(numbers, along))
    return invalid("normals of another kind, or of vertices without positions");
  const std::size_t values = rows.size() / numbers.axes.size();
  if (values == 0) return bytes.empty() ? Expected<Done>(Done{}) : invalid("bytes of no normals");
  ByteReader in(bytes, at);
  const std::uint32_t number = in.u8();
  if (!in.ok()) return Failure{in.error()};
  const NormalModel model = normal_model(number);
  if (number >= normal_models || !model.fits(numbers))
    return invalid("normals with model " + std::to_string(number));
  if (model.quick) {
    LaneDecoder coder(in);
    if (!in.ok()) return Failure{in.error()};
    const FormulaNormals formula(along, values, model.formula);
    if (!code_normals_quickly(coder, numbers, formula, along, rows))
      return invalid("a normal beyond what there is");
    if (!coder.finished()) return invalid("normals do not end where their bytes end");
    return Done{};
  }
  const Stream stream{in.take(in.left()), at + 1};
  if (values > stream.max_decisions()) return invalid("more normals than their bytes can say");
  const FormulaNormals formula(along, values, model.formula);
  return decode_stream(stream, "the normals", [&](DecodeFrom& coder) {
    const bool ok = code_normals(coder, model, numbers, formula, along, rows, values);
    return std::string(ok ? "" : "a normal beyond what there is");
  });
}

std::uint64_t normals_memory(std::uint64_t values, std::uint64_t vertices) {
  return FormulaNormals::memory(values, vertices) + known_values_memory(values, vertices) +
         NumberedNormals<std::int32_t, DecodeFrom>::memory(values);
}

template Expected<Done> decode_normals(std::span<const std::byte>, std::uint64_t, const Numbers&,
                                       const ValueSurface&, std::span<std::int32_t>);
template Expected<Done> decode_normals(std::span<const std::byte>, std::uint64_t, const Numbers&,
                                       const ValueSurface&, std::span<std::int64_t>);

}  // namespace clers::internal

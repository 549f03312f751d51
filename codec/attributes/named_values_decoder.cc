#include "codec/attributes/named_values_decoder.h"

#include <string>
#include <vector>

#include "codec/attributes/named_values.h"
#include "codec/entropy/bytes.h"
#include "codec/entropy/stream.h"

namespace clers::internal {

template <class Int>
Expected<Done> decode_named_values(std::span<const std::byte> bytes, std::uint64_t at,
                                   std::span<const Axis> axes, const ValueSurface& along,
                                   std::span<Int> rows, Domain domain) {
  const std::size_t components = axes.size(), values = rows.size() / components;
  const auto invalid = [&](std::string what) {
    return fail(ErrorCode::invalid, Place::byte, at, std::move(what));
  };
  if (values == 0) return bytes.empty() ? Expected<Done>(Done{}) : invalid("bytes of no values");
  ByteReader in(bytes, at);
  const std::uint32_t number = in.u8();
  if (!in.ok()) return Failure{in.error()};
  const NamedModel model = named_model(number);
  if (number >= named_models || !model.fits(components))
    return invalid("values of " + std::to_string(components) + " components with model " +
                   std::to_string(number));
  std::vector<std::uint64_t> tops;
  std::uint64_t most = 0;
  for (const Axis& axis : axes) {
    tops.push_back(coded_top(axis));
    most = std::max(most, tops.back());
  }
  const Stream stream{in.take(in.left()), at + 1};
  if (most > 0 && values > stream.max_decisions())
    return invalid("more values than their bytes can say");
  auto decoded = decode_stream(stream, "the values", [&](DecodeFrom& coder) {
    NamedValueCoder<Int, DecodeFrom> coded(coder, model, tops, rows);
    const bool ok = for_each_nearby(
        domain, along, values, values,
        [&](std::uint32_t v, const Nearby& nearby) { return coded.code(v, nearby); });
    return std::string(ok ? "" : "a value beyond the greatest");
  });
  if (!decoded) return decoded;
  for (std::size_t c = 0; c < components; ++c) {
    if (axes[c].palette.empty()) continue;
    for (std::size_t i = c; i < rows.size(); i += components)
      rows[i] = static_cast<Int>(axes[c].palette[static_cast<std::size_t>(rows[i])]);
  }
  return decoded;
}

std::uint64_t named_values_memory(std::uint64_t values, std::uint64_t components,
                                  std::uint64_t vertices) {
  return NamedValueCoder<std::int32_t, DecodeFrom>::memory(values, components) +
         known_values_memory(values, vertices) + 8 * components;
}

template Expected<Done> decode_named_values(std::span<const std::byte>, std::uint64_t,
                                            std::span<const Axis>, const ValueSurface&,
                                            std::span<std::int32_t>, Domain);
template Expected<Done> decode_named_values(std::span<const std::byte>, std::uint64_t,
                                            std::span<const Axis>, const ValueSurface&,
                                            std::span<std::int64_t>, Domain);

}  // namespace clers::internal

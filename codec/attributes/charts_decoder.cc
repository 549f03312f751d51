// Bytes -> values of charts.
#include "codec/attributes/charts.h"
#include "codec/attributes/charts_model.h"
#include "codec/attributes/charts_options.h"
#include "codec/numbers/ranks.h"

namespace clers::internal {

template <class Int>
Expected<Done> decode_charts(std::span<const std::byte> bytes, std::uint64_t at,
                             std::span<const Axis> axes, const ValueSurface& along,
                             std::span<Int> rows) {
  const auto invalid = [&](const char* what) {
    return fail(ErrorCode::invalid, Place::byte, at, what);
  };
  if (!may_be_charts(axes)) return invalid("charts of other than two components");
  const std::size_t width = axes.size();
  if (rows.empty()) return bytes.empty() ? Expected<Done>(Done{}) : invalid("bytes of no values");
  const std::vector<Axis> ranked = with_ranks(axes.first(2));
  ByteReader in(bytes, at);
  const auto options = read_charts_options(in, ranked, !along.surface.twins.empty());
  if (!options) return Failure{options.error()};
  LaneDecoder coder(in);
  if (!in.ok()) return Failure{in.error()};
  const std::vector<GridPlace> places = places_of(along.position);
  std::vector<Int> pairs(width == 2 ? 0 : rows.size() / width * 2);
  const std::span<Int> two = width == 2 ? rows : std::span<Int>(pairs);
  ChartsModel<Int> model(two, ranked, along, places, *options);
  if (!model.code(coder)) return invalid("a value of a chart is outside of its range");
  if (!coder.finished()) return invalid("values do not end where their bytes end");
  if (width > 2)
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i] = i % width < 2 ? pairs[i / width * 2 + i % width] : 0;
  ranks_to_integers(Lattice<Int>{rows, axes});
  return Done{};
}

std::uint64_t charts_memory(std::uint64_t values, std::uint64_t components,
                            std::uint64_t vertices) {
  return (components > 2 ? 16 * values : 0) + ChartsModel<std::int64_t>::memory(values) +
         ValueRepeats<std::int64_t>::memory(values) + visit_order_memory(values) +
         places_memory(vertices) + LastAtVertex::memory(vertices);
}

template Expected<Done> decode_charts(std::span<const std::byte>, std::uint64_t,
                                      std::span<const Axis>, const ValueSurface&,
                                      std::span<std::int32_t>);
template Expected<Done> decode_charts(std::span<const std::byte>, std::uint64_t,
                                      std::span<const Axis>, const ValueSurface&,
                                      std::span<std::int64_t>);

}  // namespace clers::internal

// Chooses a model by what coding with it would take.
#include "codec/attributes/named_values_encoder.h"

#include <algorithm>
#include <vector>

#include "codec/attributes/named_values.h"
#include "codec/entropy/measure.h"
#include "codec/entropy/stream.h"

namespace clers::internal {
namespace {

// Values that models are tried on; and those that show whether that is worth it.
constexpr std::size_t sample = 12288, small_sample = 3072;

template <class Int, class Coder>
void code_all(Coder& coder, const NamedModel& model, std::span<const std::uint64_t> tops,
              std::span<Int> rows, const ValueSurface& along, Domain domain, std::size_t most) {
  NamedValueCoder<Int, Coder> values(coder, model, tops, rows);
  for_each_nearby(domain, along, rows.size() / tops.size(), most,
                  [&](std::uint32_t v, const Nearby& nearby) { return values.code(v, nearby); });
}

/// A model, and what the sample took with it, in 1/256 bits.
struct Choice {
  NamedModel model;
  std::uint64_t cost = ~std::uint64_t(0);
};

/// First what values are predicted by, then the rest.
template <class Int>
Choice choose_model(std::span<const std::uint64_t> tops, std::span<Int> rows,
                    const ValueSurface& along, Domain domain, std::size_t most) {
  Choice best;
  const auto try_one = [&](const NamedModel& model) {
    if (!model.fits(tops.size())) return;
    Measure coder;
    code_all(coder, model, tops, rows, along, domain, most);
    if (coder.cost() < best.cost) best = {model, coder.cost()};
  };
  for (std::uint32_t p = 0; p < named_predictors; ++p) {
    const auto predictor = static_cast<NamedPredictor>(p);
    if (along.surface.corners.empty() && predictor > NamedPredictor::before) break;
    for (const Repeats repeats : {Repeats::none, Repeats::values, Repeats::components})
      try_one({predictor, Relation::none, repeats});
  }
  const NamedModel so_far = best.model;
  for (const Relation relation : {Relation::green, Relation::sum})
    try_one({so_far.predictor, relation, so_far.repeats});
  return best;
}

}  // namespace

template <class Int>
Bytes encode_named_values(const Lattice<Int>& values, const ValueSurface& along, Domain domain,
                          std::optional<std::size_t> beside) {
  Bytes bytes;
  if (values.rows.empty()) return bytes;
  const std::size_t components = values.axes.size();
  std::vector<Int> rows(values.rows.begin(), values.rows.end());
  std::vector<std::uint64_t> tops;
  for (std::size_t c = 0; c < components; ++c) {
    const Axis& axis = values.axes[c];
    tops.push_back(coded_top(axis));
    if (axis.palette.empty()) continue;
    for (std::size_t i = c; i < rows.size(); i += components)
      rows[i] = static_cast<Int>(std::lower_bound(axis.palette.begin(), axis.palette.end(),
                                                  static_cast<std::uint64_t>(rows[i])) -
                                 axis.palette.begin());
  }
  if (beside) {
    const std::size_t tried = std::min(small_sample, values.count());
    const std::uint64_t cost = choose_model<Int>(tops, rows, along, domain, tried).cost;
    // In 1/256 bits. A longer stream is cheaper a value, since models learn.
    if (cost / tried * values.count() / 10 * 7 / 2048 > *beside) return bytes;
  }
  const NamedModel model = choose_model<Int>(tops, rows, along, domain, sample).model;
  put_u8(bytes, number_of(model));
  put_bytes(bytes, encode_stream([&](EncodeTo& coder) {
              code_all<Int>(coder, model, tops, rows, along, domain, values.count());
            }));
  return bytes;
}

template Bytes encode_named_values(const Lattice<std::int32_t>&, const ValueSurface&, Domain,
                                   std::optional<std::size_t>);
template Bytes encode_named_values(const Lattice<std::int64_t>&, const ValueSurface&, Domain,
                                   std::optional<std::size_t>);

}  // namespace clers::internal

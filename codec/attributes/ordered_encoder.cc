// Chooses a predictor by samples, finds residuals and their classes, and writes a stream for each
// component.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "codec/attributes/ordered_integers.h"
#include "codec/attributes/ordered_model.h"
#include "codec/attributes/prediction.h"
#include "codec/attributes/residual_streams.h"
#include "codec/attributes/two_sets.h"

namespace clers::internal {
namespace {

template <class Int>
CLERS_ALWAYS_INLINE Int residual_of(const Int* rows, std::size_t components, std::size_t v,
                                    const OrderStep<std::uint32_t>& step) {
  using U = std::make_unsigned_t<Int>;
  return static_cast<Int>(static_cast<U>(rows[v * components]) - predicted(rows, components, step));
}

/// Residuals of values begin .. end - 1 and their classes, which are counted.
template <class Int, class Components>
void find_residuals(const Lattice<const Int>& values, Components components, OrderSteps& steps,
                    std::size_t begin, std::size_t end, std::span<Int> residuals,
                    std::uint8_t* classes, std::vector<ClassCounts>& counts) {
  const Int* rows = values.rows.data();
  Int* out = residuals.data();
  if (begin == 0) out = std::copy_n(rows, std::size_t(components), out);
  for_each_step(steps, begin, end, [&](std::size_t v, auto step) {
    for (std::size_t c = 0; c < components; ++c)
      *out++ = residual_of(rows + c, components, v, step);
  });
  classes_of(std::span<const Int>(residuals), classes);
  for (std::size_t i = 0; i < residuals.size(); i += components)
    for (std::size_t c = 0; c < components; ++c) ++counts[c][classes[i + c]];
}

/// The predictor that costs least, by samples.
template <class Int, class Components>
OrderPredictor choose(const Lattice<const Int>& values, Components components,
                      const CodedSurface& surface) {
  constexpr std::size_t run = 64, runs = 32;
  const std::size_t count = values.count(), stride = std::max(run, count / runs);
  std::vector<Int> residuals(run * components);
  std::vector<std::uint8_t> classes(residuals.size());
  OrderPredictor best = OrderPredictor::hexagon;
  std::uint64_t least = ~std::uint64_t(0);
  for (unsigned p = order_predictors; p-- > 0;) {
    const OrderPredictor predictor = static_cast<OrderPredictor>(p);
    OrderSteps steps(surface, predictor);
    std::vector<ClassCounts> counts(components, ClassCounts{});
    for (std::size_t begin = 0; begin < count; begin += stride) {
      const std::size_t end = std::min(count, begin + run);
      find_residuals(values, components, steps, begin, end,
                     std::span(residuals).first((end - begin) * components), classes.data(),
                     counts);
    }
    std::uint64_t cost = 0;
    for (const ClassCounts& of_component : counts) cost += cost_of(of_component);
    if (cost < least) {
      least = cost;
      best = predictor;
    }
  }
  return best;
}

/// Shares above 2^10 pay next to nothing, and tables would no longer fit into a cache of 32 KiB.
ShareSets model_for(std::span<const std::uint8_t> classes, const std::vector<ClassCounts>& counts,
                    std::span<const std::size_t> coded, bool may_have_two) {
  const std::size_t count = classes.size() / counts.size();
  ShareSets model;
  model.log = count < 4096 ? 9 : 10;
  model.significant = count < 4096 ? 2 : count < 65536 ? 3 : 4;
  if (may_have_two) {
    TwoSets two(classes, counts.size());
    if (two.pays(counts)) {
      for (const std::vector<ClassCounts>& of_set : two.counts)
        model.sets.push_back(weights_by_component(of_set, coded, model.significant));
      model.set_of = std::move(two.set_of);
      return model;
    }
  }
  model.sets.push_back(weights_by_component(counts, coded, model.significant));
  return model;
}

}  // namespace

template <class Int>
Bytes encode_ordered(const Lattice<const Int>& values, const CodedSurface& surface, int level) {
  const std::size_t count = values.count(), components = values.axes.size();
  const CodedComponents which(values.axes);
  Bytes out;
  if (count == 0 || which.coded.empty()) return out;

  std::vector<Int> residuals(values.rows.size());
  std::vector<std::uint8_t> classes(values.rows.size());
  std::vector<ClassCounts> counts(components, ClassCounts{});
  OrderPredictor predictor{};
  with_components(components, [&](auto n) {
    predictor = choose(values, n, surface);
    OrderSteps steps(surface, predictor);
    for (std::size_t begin = 0; begin < count; begin += OrderSteps::most) {
      const std::size_t end = std::min(count, begin + OrderSteps::most);
      find_residuals(values, n, steps, begin, end,
                     std::span(residuals).subspan(begin * n, (end - begin) * n),
                     classes.data() + begin * n, counts);
    }
  });

  ShareSets model = model_for(classes, counts, which.coded, level > 1);
  put_u8(out, static_cast<unsigned>(predictor) | (model.significant - 1) << 2 |
                  (model.log - ShareSets::least_log) << 4 |
                  static_cast<unsigned>(model.sets.size() - 1) << 6);
  const Bytes head = encode_stream([&](EncodeTo& coder) { model.code(coder, which.coded); });
  put_varint(out, head.size());
  put_bytes(out, head);

  std::vector<std::size_t> streams;
  for (const std::size_t c : which.coded)
    if (!model.all_zero(c)) streams.push_back(c);
  for_each_abreast(streams, [&](auto side_by_side) {
    constexpr std::size_t n = side_by_side.size();
    std::array<std::uint64_t, n> raw{};
    for (std::size_t i = 0; i < n; ++i)
      for (unsigned k = 0; k < residual_classes; ++k)
        raw[i] += counts[side_by_side[i]][k] * raw_bits(k);
    encode_abreast<Int, n>(residuals, classes, components, side_by_side, model, raw, out);
  });
  return out;
}

template Bytes encode_ordered(const Lattice<const std::int32_t>&, const CodedSurface&, int);
template Bytes encode_ordered(const Lattice<const std::int64_t>&, const CodedSurface&, int);

}  // namespace clers::internal

#include "codec/attributes/ordered_integers.h"

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "codec/attributes/hexagon.h"
#include "codec/attributes/prediction.h"
#include "codec/attributes/residual_streams.h"

namespace clers::internal {
namespace {

using Counts = std::array<std::uint64_t, residual_classes>;

/// log2(x) in 1/256, rounded down. x > 0.
std::uint64_t log2_of(std::uint64_t x) {
  const unsigned whole = static_cast<unsigned>(std::bit_width(x)) - 1;
  std::uint64_t m = whole > 31 ? x >> (whole - 31) : x << (31 - whole), fraction = 0;
  for (unsigned i = 0; i < 8; ++i) {
    m = m * m >> 31;
    fraction = fraction << 1 | m >> 32;
    if (m >> 32 != 0) m >>= 1;
  }
  return whole << 8 | fraction;
}

/// What residuals in these classes take at least, in 1/256 bits.
std::uint64_t cost_of(const Counts& counts) {
  std::uint64_t all = 0, cost = 0;
  for (unsigned c = 0; c < residual_classes; ++c) {
    if (counts[c] == 0) continue;
    all += counts[c];
    cost += counts[c] * ((std::uint64_t(raw_bits(c)) << 8) - log2_of(counts[c]));
  }
  return all == 0 ? 0 : cost + all * log2_of(all);
}

/// What a step predicts of a component, and more, modulo the word. `rows` begin at it. The value
/// that is added last mostly is the one before, which may just have been computed.
template <class Int>
CLERS_ALWAYS_INLINE std::make_unsigned_t<Int> predicted(const Int* rows, std::size_t components,
                                                        const Step<std::uint32_t>& step,
                                                        std::make_unsigned_t<Int> more = 0) {
  using U = std::make_unsigned_t<Int>;
  const auto at = [&](std::uint32_t v) { return static_cast<U>(rows[v * components]); };
  const Int way = static_cast<Int>(at(step.to) - at(step.origin));
  more += static_cast<U>(way >> step.halving);
  return more + at(step.from);
}
template <class Int>
CLERS_ALWAYS_INLINE Int residual_of(const Int* rows, std::size_t components, std::size_t v,
                                    const Step<std::uint32_t>& step) {
  using U = std::make_unsigned_t<Int>;
  return static_cast<Int>(static_cast<U>(rows[v * components]) - predicted(rows, components, step));
}

/// Residuals of values begin .. end - 1 and their classes, which are counted.
template <class Int, class Components>
void find_residuals(const Lattice<const Int>& values, Components components, Steps& steps,
                    std::size_t begin, std::size_t end, std::span<Int> residuals,
                    std::uint8_t* classes, std::vector<Counts>& counts) {
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
    Steps steps(surface, predictor);
    std::vector<Counts> counts(components, Counts{});
    for (std::size_t begin = 0; begin < count; begin += stride) {
      const std::size_t end = std::min(count, begin + run);
      find_residuals(values, components, steps, begin, end,
                     std::span(residuals).first((end - begin) * components), classes.data(),
                     counts);
    }
    std::uint64_t cost = 0;
    for (const Counts& of_component : counts) cost += cost_of(of_component);
    if (cost < least) {
      least = cost;
      best = predictor;
    }
  }
  return best;
}

/// Which components have residuals, and the greatest top of all.
struct Components {
  explicit Components(std::span<const Axis> axes) {
    for (std::size_t c = 0; c < axes.size(); ++c) {
      if (axes[c].top == 0) continue;
      coded.push_back(c);
      top = std::max(top, axes[c].top);
    }
  }
  std::vector<std::size_t> coded;
  std::uint64_t top = 0;
};

/// Calls use(which) for three components, two or one at a time, as an array.
template <class Use>
void for_each_abreast(std::span<const std::size_t> which, Use use) {
  std::size_t i = 0;
  for (; i + abreast <= which.size(); i += abreast)
    use(std::array<std::size_t, 3>{which[i], which[i + 1], which[i + 2]});
  if (which.size() - i == 2) use(std::array<std::size_t, 2>{which[i], which[i + 1]});
  if (which.size() - i == 1) use(std::array<std::size_t, 1>{which[i]});
}

/// Finer shares pay from some number of vertices on; above 2^10 next to nothing, and tables would
/// no longer fit into a cache of 32 KiB.
SharePrecision precision_for(std::size_t count) {
  if (count < 4096) return {9, 2};
  return {10, count < 65536 ? 3u : 4u};
}

/// Weights of the components that are coded; neighbours have the same where that takes least.
std::vector<Weights> weights_by_component(const std::vector<Counts>& counts,
                                          std::span<const std::size_t> coded,
                                          unsigned significant) {
  std::vector<Weights> weights(counts.size());
  for (std::size_t first = 0, next = 0; first < coded.size(); first = next) {
    Counts together = counts[coded[first]];
    std::uint64_t cost = cost_of(together);
    for (next = first + 1; next < coded.size(); ++next) {
      const Counts& other = counts[coded[next]];
      Counts sum = together;
      std::uint64_t own = cost_of(other);
      for (unsigned c = 0; c < residual_classes; ++c) {
        sum[c] += other[c];
        if (other[c] != 0) own += 4 * 256;  // about what its weight takes
      }
      const std::uint64_t both = cost_of(sum);
      if (both > cost + own) break;
      together = sum;
      cost = both;
    }
    const Weights of_all = weights_of(together, significant);
    for (std::size_t i = first; i < next; ++i) weights[coded[i]] = of_all;
  }
  return weights;
}

}  // namespace

template <class Int>
Bytes encode_ordered(const Lattice<const Int>& values, const CodedSurface& surface) {
  const std::size_t count = values.count(), components = values.axes.size();
  const Components which(values.axes);
  Bytes out;
  if (count == 0 || which.coded.empty()) return out;

  std::vector<Int> residuals(values.rows.size());
  std::vector<std::uint8_t> classes(values.rows.size());
  std::vector<Counts> counts(components, Counts{});
  OrderPredictor predictor{};
  with_components(components, [&](auto n) {
    predictor = choose(values, n, surface);
    Steps steps(surface, predictor);
    for (std::size_t begin = 0; begin < count; begin += Steps::most) {
      const std::size_t end = std::min(count, begin + Steps::most);
      find_residuals(values, n, steps, begin, end,
                     std::span(residuals).subspan(begin * n, (end - begin) * n),
                     classes.data() + begin * n, counts);
    }
  });

  const SharePrecision precision = precision_for(count);
  std::vector<Weights> weights = weights_by_component(counts, which.coded, precision.significant);
  put_u8(out,
         static_cast<unsigned>(predictor) | (precision.significant - 1) << 2 | precision.log << 4);
  const Bytes head = encode_stream([&](EncodeTo& coder) {
    ComponentWeights model;
    for (const std::size_t c : which.coded) model.code(coder, precision.significant, weights[c]);
  });
  put_varint(out, head.size());
  put_bytes(out, head);

  std::vector<std::size_t> streams;
  for (const std::size_t c : which.coded)
    if (!all_zero(weights[c])) streams.push_back(c);
  for_each_abreast(streams, [&](auto side_by_side) {
    constexpr std::size_t n = side_by_side.size();
    std::array<Shares, n> shares;
    std::array<std::uint64_t, n> raw{};
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t c = side_by_side[i];
      shares[i] = shares_of(weights[c], precision.log);
      for (unsigned k = 0; k < residual_classes; ++k) raw[i] += counts[c][k] * raw_bits(k);
    }
    encode_abreast<Int, n>(residuals, classes, components, side_by_side, shares, raw, out);
  });
  return out;
}

template <class Int>
Expected<OrderPredictor> decode_residuals(std::span<const std::byte> bytes, std::uint64_t at,
                                          const Lattice<Int>& rows) {
  const auto invalid = [&](std::string what) {
    return fail(ErrorCode::invalid, Place::byte, at, std::move(what));
  };
  const std::size_t components = rows.axes.size();
  const Components which(rows.axes);
  if (rows.count() == 0 || which.coded.empty()) {
    std::fill(rows.rows.begin(), rows.rows.end(), Int(0));
    if (!bytes.empty()) return invalid("residuals where there are none");
    return OrderPredictor::previous;
  }
  ByteReader in(bytes, at);
  const std::uint32_t how = in.u8();
  const SharePrecision precision{how >> 4, (how >> 2 & 3) + 1};
  if ((how & 3) >= order_predictors) return invalid("predictor " + std::to_string(how & 3));
  if (in.ok() && (precision.log < 9 || precision.log > tans::most_log))
    return invalid("shares of 2^" + std::to_string(precision.log));
  const Stream head = read_stream(in, {});
  if (!in.ok()) return Failure{in.error()};
  std::vector<Weights> weights(components);
  const auto read = decode_stream(head, "the weights", [&](DecodeFrom& coder) -> std::string {
    ComponentWeights model;
    for (const std::size_t c : which.coded) {
      model.code(coder, precision.significant, weights[c]);
      if (weights[c].size() > classes_below(which.top)) return "residuals of values beyond all";
      if (!can_share(weights[c], precision.log)) return "weights that are no shares";
    }
    return {};
  });
  if (!read) return Failure{read.error()};

  std::vector<std::size_t> streams;
  for (std::size_t c = 0; c < components; ++c)
    if (rows.axes[c].top != 0 && !all_zero(weights[c]))
      streams.push_back(c);
    else
      for (std::size_t i = c; i < rows.rows.size(); i += components) rows.rows[i] = 0;
  bool finished = true;
  for_each_abreast(streams, [&](auto side_by_side) {
    constexpr std::size_t n = side_by_side.size();
    std::array<Shares, n> shares;
    std::array<std::span<const std::byte>, n> parts;
    for (std::size_t i = 0; i < n; ++i) {
      shares[i] = shares_of(weights[side_by_side[i]], precision.log);
      parts[i] = read_stream(in, {}).bytes;
    }
    if (in.ok())
      finished &= decode_abreast<Int, n>(parts, shares, components, side_by_side, rows.rows);
  });
  if (!in.ok()) return Failure{in.error()};
  if (!finished || in.left() != 0) return invalid("residuals do not end where their bytes end");
  return static_cast<OrderPredictor>(how & 3);
}

template <class Int>
Expected<Done> add_steps(OrderPredictor predictor, const CodedSurface& surface, std::uint64_t at,
                         const Lattice<Int>& rows) {
  using U = std::make_unsigned_t<Int>;
  const std::size_t count = rows.count();
  bool beyond = false;
  with_components(rows.axes.size(), [&](auto n) {
    Int* const values = rows.rows.data();
    std::array<U, 255> tops;
    for (std::size_t c = 0; c < n; ++c) tops[c] = static_cast<U>(rows.axes[c].top);
    for (std::size_t c = 0; count > 0 && c < n; ++c) beyond |= static_cast<U>(values[c]) > tops[c];
    Steps steps(surface, predictor);
    for_each_step(steps, 0, count, [&](std::size_t v, auto step) {
      for (std::size_t c = 0; c < n; ++c) {
        Int& value = values[v * n + c];
        const U sum = predicted(values + c, n, step, static_cast<U>(value));
        beyond |= sum > tops[c];
        value = static_cast<Int>(sum);
      }
    });
  });
  if (!beyond) return Done{};
  return fail(ErrorCode::invalid, Place::byte, at, "a value is beyond the greatest of its axis");
}

template Bytes encode_ordered(const Lattice<const std::int32_t>&, const CodedSurface&);
template Bytes encode_ordered(const Lattice<const std::int64_t>&, const CodedSurface&);
template Expected<OrderPredictor> decode_residuals(std::span<const std::byte>, std::uint64_t,
                                                   const Lattice<std::int32_t>&);
template Expected<OrderPredictor> decode_residuals(std::span<const std::byte>, std::uint64_t,
                                                   const Lattice<std::int64_t>&);
template Expected<Done> add_steps(OrderPredictor, const CodedSurface&, std::uint64_t,
                                  const Lattice<std::int32_t>&);
template Expected<Done> add_steps(OrderPredictor, const CodedSurface&, std::uint64_t,
                                  const Lattice<std::int64_t>&);

}  // namespace clers::internal

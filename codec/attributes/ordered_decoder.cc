// Reads residuals, a stream for each component, and adds them up along the order of triangles.
#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "codec/attributes/ordered_integers.h"
#include "codec/attributes/ordered_model.h"
#include "codec/attributes/prediction.h"
#include "codec/attributes/residual_streams.h"

namespace clers::internal {

template <class Int>
Expected<OrderPredictor> decode_residuals(std::span<const std::byte> bytes, std::uint64_t at,
                                          const Lattice<Int>& rows) {
  const auto invalid = [&](std::string what) {
    return fail(ErrorCode::invalid, Place::byte, at, std::move(what));
  };
  const std::size_t components = rows.axes.size();
  const CodedComponents which(rows.axes);
  if (rows.count() == 0 || which.coded.empty()) {
    std::fill(rows.rows.begin(), rows.rows.end(), Int(0));
    if (!bytes.empty()) return invalid("residuals where there are none");
    return OrderPredictor::previous;
  }
  ByteReader in(bytes, at);
  const std::uint32_t how = in.u8();
  ShareSets model;
  model.significant = (how >> 2 & 3) + 1;
  model.log = (how >> 4 & 3) + ShareSets::least_log;
  model.sets.assign((how >> 6) + 1, std::vector<Weights>(components));
  if ((how & 3) >= order_predictors || model.log > tans::most_log || model.sets.size() > 2)
    return invalid("residuals of no kind that is known");
  const Stream head = read_stream(in, {});
  if (!in.ok()) return Failure{in.error()};
  if (model.sets.size() > 1)
    model.set_of.resize((rows.count() + rows_in_block - 1) / rows_in_block);
  const auto read = decode_stream(head, "the weights", [&](DecodeFrom& coder) -> std::string {
    model.code(coder, which.coded);
    for (const std::vector<Weights>& set : model.sets)
      for (const std::size_t c : which.coded) {
        if (set[c].size() > classes_below(which.top)) return "residuals of values beyond all";
        if (!can_share(set[c], model.log)) return "weights that are no shares";
      }
    return {};
  });
  if (!read) return Failure{read.error()};

  std::vector<std::size_t> streams;
  for (std::size_t c = 0; c < components; ++c)
    if (rows.axes[c].top != 0 && !model.all_zero(c))
      streams.push_back(c);
    else
      for (std::size_t i = c; i < rows.rows.size(); i += components) rows.rows[i] = 0;
  bool finished = true;
  for_each_abreast(streams, [&](auto side_by_side) {
    constexpr std::size_t n = side_by_side.size();
    std::array<std::span<const std::byte>, n> parts;
    for (std::span<const std::byte>& part : parts) part = read_stream(in, {}).bytes;
    if (in.ok())
      finished &= decode_abreast<Int, n>(parts, model, components, side_by_side, rows.rows);
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
    OrderSteps steps(surface, predictor);
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

template Expected<OrderPredictor> decode_residuals(std::span<const std::byte>, std::uint64_t,
                                                   const Lattice<std::int32_t>&);
template Expected<OrderPredictor> decode_residuals(std::span<const std::byte>, std::uint64_t,
                                                   const Lattice<std::int64_t>&);
template Expected<Done> add_steps(OrderPredictor, const CodedSurface&, std::uint64_t,
                                  const Lattice<std::int32_t>&);
template Expected<Done> add_steps(OrderPredictor, const CodedSurface&, std::uint64_t,
                                  const Lattice<std::int64_t>&);

}  // namespace clers::internal

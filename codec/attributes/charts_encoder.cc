// Values of charts -> bytes, in the way that takes least.
#include <algorithm>
#include <utility>
#include <vector>

#include "codec/attributes/charts.h"
#include "codec/attributes/charts_model.h"
#include "codec/attributes/charts_options.h"
#include "codec/numbers/ranks.h"

namespace clers::internal {
namespace {

/// Ways of being alike that many values are.
template <class Int>
std::vector<Likeness> find_likenesses(std::span<const Int> rows) {
  std::vector<Likeness> found;
  std::vector<std::array<Int, 2>> values(rows.size() / 2);
  const std::size_t enough = values.size() / 16 + 1;
  for (std::uint32_t axis = 0; axis < 2; ++axis) {
    for (std::size_t v = 0; v < values.size(); ++v)
      values[v] = {rows[2 * v + 1 - axis], rows[2 * v + axis]};
    std::sort(values.begin(), values.end());
    if (axis == 0) {
      std::size_t equal = 0;
      for (std::size_t i = 1; i < values.size(); ++i) equal += values[i] == values[i - 1];
      if (equal >= enough) found.push_back({});
    }
    // What sums of the coordinates of values that are alike in the other one are many.
    constexpr std::size_t most_alike = 24;
    std::vector<std::int64_t> sums;
    for (std::size_t i = 0, end; i < values.size(); i = end) {
      for (end = i + 1; end < values.size() && values[end][0] == values[i][0];) ++end;
      if (end - i > most_alike) continue;
      for (std::size_t j = i; j < end; ++j)
        for (std::size_t k = j + 1; k < end; ++k)
          if (values[j][1] != values[k][1])
            sums.push_back(std::int64_t(values[j][1]) + values[k][1]);
    }
    std::sort(sums.begin(), sums.end());
    // Sums may be 1 off, either way.
    std::size_t most = 0, best = 0;
    for (std::size_t i = 0, begin = 0, end = 0; i < sums.size(); ++i) {
      while (sums[begin] < sums[i] - 1) ++begin;
      while (end < sums.size() && sums[end] <= sums[i] + 1) ++end;
      if (end - begin > most) most = end - begin, best = i;
    }
    if (most >= enough)
      found.push_back({Likeness::reflected, axis, static_cast<std::uint64_t>(sums[best])});
  }
  return found;
}

}  // namespace

template <class Int>
Bytes encode_charts(const Lattice<Int>& values, const ValueSurface& along, int level) {
  Bytes best;
  if (values.rows.empty()) return best;
  std::vector<Int> rows;
  rows.reserve(2 * values.count());
  for (std::size_t i = 0; i < values.rows.size(); i += values.axes.size())
    rows.insert(rows.end(), {values.rows[i], values.rows[i + 1]});
  integers_to_ranks(Lattice<Int>{rows, values.axes.first(2)});
  const std::vector<Axis> axes = with_ranks(values.axes.first(2));
  const std::vector<GridPlace> places = places_of(along.position);
  ChartsOptions chosen;
  const auto consider = [&](const ChartsOptions& options) {
    Bytes bytes;
    put_charts_options(bytes, options);
    LaneEncoder coder;
    ChartsModel<Int>(rows, axes, along, places, options).code(coder);
    coder.finish(bytes);
    if (!best.empty() && bytes.size() >= best.size()) return;
    best = std::move(bytes);
    chosen = options;
  };
  consider({});
  const auto consider_with = [&](auto change) {
    ChartsOptions options = chosen;
    change(options);
    consider(options);
  };
  if (!along.surface.twins.empty()) {
    for (const Likeness& likeness : find_likenesses<Int>(rows))
      consider_with([&](ChartsOptions& o) { o.likeness = likeness; });
    if (level >= 7) consider_with([](ChartsOptions& o) { o.by_parallelograms = true; });
  }
  if (!along.vertex_of.empty()) consider_with([](ChartsOptions& o) { o.same = true; });
  consider_with([](ChartsOptions& o) { o.fractions = true; });
  return best;
}

template Bytes encode_charts(const Lattice<std::int32_t>&, const ValueSurface&, int);
template Bytes encode_charts(const Lattice<std::int64_t>&, const ValueSurface&, int);

}  // namespace clers::internal

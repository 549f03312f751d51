// Bounds, then a grid, then the nearest point of it for each number.
#include "codec/numbers/quantise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include "codec/base/difference.h"
#include "codec/base/portable.h"
#include "codec/numbers/directions.h"
#include "codec/numbers/find_system.h"
#include "codec/numbers/floating_maps.h"
#include "codec/numbers/move_to_grid.h"
#include "codec/numbers/near_grid.h"
#include "codec/numbers/number_format.h"
#include "codec/numbers/number_maps.h"
#include "codec/numbers/outliers.h"
#include "codec/numbers/place_numbers.h"

namespace clers::internal {
namespace {

using Kind = Precision::Kind;

/// The numbers of a component, in the order of the values.
template <class T>
std::vector<T> numbers_of(const AttributeView& a, std::size_t count, std::size_t component) {
  std::vector<T> numbers(count);
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(&numbers[i], a.value(i) + component * sizeof(T), sizeof(T));
  return numbers;
}

Failure<Error> not_on_grid(const AttributeView& a, std::size_t i, const char* what) {
  const Place place = a.domain == Domain::vertex   ? Place::vertex
                      : a.domain == Domain::corner ? Place::corner
                                                   : Place::face;
  return fail(ErrorCode::not_on_grid, place, i, "'" + std::string(a.name) + "' " + what);
}

/// Refuses the first value that is not finite.
template <class T>
Expected<Done> check_finite(const AttributeView& a, const std::vector<std::vector<T>>& numbers) {
  if constexpr (std::is_floating_point_v<T>) {
    bool finite = true;
    for (const std::vector<T>& component : numbers)
      for (const T x : component) finite &= std::fabs(x) <= std::numeric_limits<T>::max();
    if (finite) return Done{};
    std::size_t first = numbers[0].size();
    for (const std::vector<T>& component : numbers)
      for (std::size_t i = 0; i < first; ++i)
        if (!std::isfinite(component[i])) first = i;
    const bool nan = std::any_of(numbers.begin(), numbers.end(), [&](const auto& component) {
      return std::isnan(component[first]);
    });
    return not_on_grid(
        a, first,
        nan ? "is NaN, which cannot be quantised" : "is infinite, which cannot be quantised");
  }
  return Done{};
}

/// The system whose numbers are those of a grid.
NumberSystem system_of(const Grid& grid, Scalar scalar, double largest) {
  NumberSystem system;
  system.map = NumberMap::affine;
  system.origin = grid.origin;
  system.length = grid.step;
  if (!is_float(scalar) || grid.origin != 0) return system;
  // Steps of a fraction with small terms, as 3 / 100: rounded once only, so that decimals come out.
  const auto fraction = [&](double divisor) {
    const double step = grid.step * divisor;
    return step == std::floor(step) && step >= 1 && step <= 1e6 && step / divisor == grid.step &&
           largest * divisor < 0.5 * double(most_exact);
  };
  for (const double divisor : {1., 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12,
                               std::round(1 / std::min(1., grid.step))}) {
    if (!(divisor < double(most_exact)) || !fraction(divisor)) continue;
    NumberSystem quotient;
    quotient.map = NumberMap::quotient;
    quotient.divisor = static_cast<std::uint64_t>(divisor);
    quotient.step = static_cast<std::uint64_t>(grid.step * divisor);
    return quotient;
  }
  return system;
}

/// Whether a file may have a system with the points of a grid that are near numbers.
template <class T>
bool is_writable(const NumberSystem& system, const Grid& grid, const Bounds<T>& bounds) {
  if (system.map != NumberMap::affine) return true;
  if (!fault_of_affine(system).empty()) return false;
  const double farthest = std::max(std::fabs(double(bounds.least) - grid.origin),
                                   std::fabs(double(bounds.greatest) - grid.origin));
  return farthest / grid.step + 2 < double(most_integer<NumberType<T>>(system));
}

/// Whether two numbers of a sample are nearer to each other than points a step apart can be. On
/// no such grid, few are enough to show it.
template <class T>
bool has_nearer(SortedSamples<T>& samples, double largest, double step) {
  const double rounding =
      std::is_floating_point_v<T> ? largest * double(std::numeric_limits<T>::epsilon()) : 0;
  for (std::size_t s = 0; s < samples.count; ++s) {
    const std::vector<T>& sample = samples[s];
    for (std::size_t i = 1; i < sample.size(); ++i)
      if (sample[i] != sample[i - 1] &&
          difference(sample[i], sample[i - 1]) + rounding < 0.9 * step)
        return true;
  }
  return false;
}

/// The system that numbers are in already, if its points are at least as far apart as those of a
/// grid: so they are fewer, and nothing is lost.
template <class T>
std::optional<NumberSystem> coarser_system(const std::vector<T>& numbers, SortedSamples<T>& samples,
                                           double largest, double step) {
  using Number = NumberType<T>;
  if (has_nearer(samples, largest, step)) return std::nullopt;
  std::vector<WordOf<Number>> words;
  words.reserve(numbers.size());
  for (const T x : numbers) words.push_back(word_of(x));
  // A few numbers show of which kind the system is; many, which steps those have in common that do
  // not occur often.
  for (const Search search : {Search::quick, Search::thorough}) {
    const NumberSystem found = find_system<Number>(words, search);
    if (found.low_bits > 0 || found.ulps > 0) return std::nullopt;
    if (found.map != (std::is_floating_point_v<T> ? NumberMap::quotient : NumberMap::word))
      return std::nullopt;
    const bool has_all = with_map<Number>(found, scalar_of<T>(), [&](const auto& map) {
      const Placing<Number, std::decay_t<decltype(map)>> placing(found, map);
      return std::all_of(words.begin(), words.end(),
                         [&](auto word) { return placing.place(word).exact; });
    });
    const double apart = std::is_floating_point_v<T> ? spacing(found) : double(found.step);
    if (has_all) return apart >= step ? std::optional(found) : std::nullopt;
  }
  return std::nullopt;
}

template <class T>
class Quantiser {
 public:
  Quantiser(const AttributeView& a, const Precision& precision, bool as_values)
      : a_(a), precision_(precision), as_values_(as_values), count_(value_count(a)) {
    for (std::size_t c = 0; c < a.components; ++c) numbers_.push_back(numbers_of<T>(a, count_, c));
  }

  Expected<QuantisedValues> run() {
    if (count_ == 0) return QuantisedValues{};
    if (auto ok = check_finite(a_, numbers_); !ok) return Failure{ok.error()};
    for (const std::vector<T>& component : numbers_) {
      bounds_.push_back(bounds_of(component));
      longest_ = std::max(longest_, bounds_.back().range());
      largest_ = std::max(largest_, bounds_.back().largest());
    }
    if (precision_.kind == Kind::error) return within(precision_.size);
    if (precision_.kind == Kind::bits && std::isinf(longest_))
      return fail(ErrorCode::not_on_grid,
                  "'" + std::string(a_.name) + "' has numbers too far apart for a grid of bits");
    std::vector<Grid> grids;
    for (std::size_t c = 0; c < numbers_.size(); ++c) grids.push_back(grid_of(c));
    auto quantised = move_all(grids, precision_.kind != Kind::bits);
    if (quantised && precision_.kind == Kind::bits)
      quantised->outliers = outliers_of(numbers_, bounds_, longest_, precision_.bits);
    return quantised;
  }

 private:
  Grid grid_of(std::size_t c) const {
    if (precision_.kind == Kind::step) return {0, precision_.size};
    if (precision_.kind == Kind::grid)
      return {precision_.origin.size() == 1 ? precision_.origin[0] : precision_.origin[c],
              precision_.size};
    const double steps = static_cast<double>((std::uint64_t(1) << precision_.bits) - 1);
    const double step = std::max(longest_ / steps, std::numeric_limits<double>::denorm_min());
    return {static_cast<double>(bounds_[c].least), longest_ == 0 ? 1 : step};
  }

  /// No component off by more than `error`: steps of twice that, or a little less where the type
  /// rounds points of that grid too far away; or nothing is moved.
  Expected<QuantisedValues> within(double error) {
    if (!std::is_floating_point_v<T>) error = std::floor(error);
    const double step = std::is_floating_point_v<T> ? 2 * error : 2 * error + 1;
    const double unit = [&] {
      if constexpr (std::is_floating_point_v<T>) {
        const T top = static_cast<T>(largest_);
        return static_cast<double>(std::nextafter(top, std::numeric_limits<T>::max())) -
               static_cast<double>(top);
      }
      return 0.;
    }();
    for (const double size : {step, step - 2 * unit}) {
      if (!(size > 0) || std::isinf(size)) break;
      auto quantised = move_all(std::vector<Grid>(numbers_.size(), Grid{0, size}), false);
      if (quantised && quantised->plan.error <= error) return quantised;
    }
    return QuantisedValues{};
  }

  Expected<QuantisedValues> move_all(const std::vector<Grid>& grids, bool keep_zeros) {
    if (!std::is_floating_point_v<T> && grids[0].step <= 1) return QuantisedValues{};
    std::vector<Target> targets;
    for (std::size_t c = 0; c < numbers_.size(); ++c)
      targets.push_back(target(c, grids[c], keep_zeros));
    if constexpr (std::is_floating_point_v<T>)
      if (auto integers = as_values_ ? std::nullopt : as_integers(targets, keep_zeros))
        return std::move(*integers);
    return as_values(targets, keep_zeros);
  }

  /// Where the numbers of a component go.
  struct Target {
    Grid grid;
    NumberSystem system;                  ///< with the points of the grid
    std::optional<NumberSystem> coarser;  ///< that they are in already
  };

  Target target(std::size_t c, const Grid& asked, bool keep_zeros) {
    SortedSamples<T> samples(numbers_[c]);
    Target to{asked, {}, {}};
    const double largest = bounds_[c].largest();
    if (std::is_floating_point_v<T> && !keep_zeros)
      if (const auto near = NearGrid(asked.step).find(numbers_[c], samples)) to.grid = *near;
    to.system = system_of(to.grid, a_.scalar, largest);
    // Grids that do not depend on the values are left for a coarser one only if that changes none.
    if (!keep_zeros || all_on(numbers_[c], to.grid, to.system))
      to.coarser = coarser_system(numbers_[c], samples, largest, asked.step);
    return to;
  }

  /// As integers, if there are some that give all numbers back as they are decoded.
  std::optional<QuantisedValues> as_integers(const std::vector<Target>& targets, bool keep_zeros) {
    QuantisedValues all;
    const std::size_t components = targets.size();
    all.values.resize(count_ * components * sizeof(std::int32_t));
    for (std::size_t c = 0; c < components; ++c) {
      const Column<std::int32_t> column{all.values.data() + c * sizeof(std::int32_t),
                                        components * sizeof(std::int32_t)};
      const Target& to = targets[c];
      if (to.coarser) {
        if (!place_all(numbers_[c], *to.coarser, column)) return std::nullopt;
      } else {
        if (!is_writable<T>(to.system, to.grid, bounds_[c]) ||
            !is_plain(numbers_[c], bounds_[c], to.grid, keep_zeros))
          return std::nullopt;
        all.plan.error =
            std::max(all.plan.error, move_to_integers(numbers_[c], to.grid, to.system, column));
      }
      all.plan.systems.push_back(to.coarser ? *to.coarser : to.system);
    }
    if (all.plan.error == 0) return QuantisedValues{};
    all.plan.integers_of = a_.scalar;
    return all;
  }

  Expected<QuantisedValues> as_values(const std::vector<Target>& targets, bool keep_zeros) {
    QuantisedValues all;
    all.values.resize(count_ * a_.value_size());
    bool all_writable = true;
    for (std::size_t c = 0; c < numbers_.size(); ++c) {
      const Target& to = targets[c];
      const Column<T> column{all.values.data() + c * sizeof(T), a_.value_size()};
      if (to.coarser) {
        for (std::size_t i = 0; i < count_; ++i) column.set(i, numbers_[c][i]);
        all.plan.systems.push_back(*to.coarser);
        continue;
      }
      const Moved component = move_to(numbers_[c], to.grid, keep_zeros, to.system, column);
      if (component.too_far)
        return not_on_grid(a_, *component.too_far, "is too many steps away from the origin");
      all_writable &= is_writable<T>(to.system, to.grid, bounds_[c]);
      all.plan.error = std::max(all.plan.error, component.error);
      all.plan.systems.push_back(to.system);
    }
    if (all.plan.error == 0) return QuantisedValues{};
    if (!all_writable) all.plan.systems.clear();
    return all;
  }

  const AttributeView& a_;
  const Precision& precision_;
  const bool as_values_;
  const std::size_t count_;
  std::vector<std::vector<T>> numbers_;  // of each component
  std::vector<Bounds<T>> bounds_;
  double longest_ = 0, largest_ = 0;
};

}  // namespace

std::string precision_fault(const Precision& precision) {
  switch (precision.kind) {
    case Kind::lossless: return "";
    case Kind::directions:
      if (precision.bits >= min_direction_bits && precision.bits <= max_direction_bits) return "";
      return std::to_string(precision.bits) + " bits of directions, expected " +
             std::to_string(min_direction_bits) + " to " + std::to_string(max_direction_bits);
    case Kind::recomputed:
      if (precision.size > 0 && precision.size <= 180) return "";
      return "an angle that is not in 0 to 180 degrees";
    case Kind::bits:
      if (precision.bits >= min_bits && precision.bits <= max_bits) return "";
      return std::to_string(precision.bits) + " bits, expected " + std::to_string(min_bits) +
             " to " + std::to_string(max_bits);
    case Kind::grid:
      for (const double origin : precision.origin)
        if (!std::isfinite(origin)) return "an origin that is not finite";
      [[fallthrough]];
    case Kind::step:
    case Kind::error:
      if (precision.size > 0 && std::isfinite(precision.size)) return "";
      return precision.kind == Kind::error ? "an error that is not a positive number"
                                           : "steps that are not a positive number";
  }
  return "no such precision";
}

Expected<QuantisedValues> quantise(const AttributeView& attribute, const Precision& precision,
                                   bool as_values) {
  if (precision.kind == Kind::lossless) return QuantisedValues{};
  const bool directions = precision.kind == Kind::directions ||
                          (precision.kind == Kind::bits && precision.or_directions &&
                           precision.bits >= min_direction_bits &&
                           precision.bits <= max_direction_bits && are_unit_vectors(attribute));
  if (directions && (attribute.components != 3 || !is_float(attribute.scalar)))
    return fail(ErrorCode::bad_option, "'" + std::string(attribute.name) + "' has " +
                                           std::to_string(attribute.components) + " " +
                                           name(attribute.scalar) +
                                           " a value, and directions have 3 floats");
  if (directions) return quantise_directions(attribute, static_cast<unsigned>(precision.bits));
  const DoublePrecision doubles;
  const std::size_t origins = precision.origin.size();
  if (precision.kind == Kind::grid && origins != 1 && origins != attribute.components)
    return fail(ErrorCode::bad_option, "a grid of " + std::to_string(origins) +
                                           " components for '" + std::string(attribute.name) +
                                           "', which has " + std::to_string(attribute.components));
  return with_type(attribute.scalar, [&](auto type) {
    return Quantiser<decltype(type)>(attribute, precision, as_values).run();
  });
}

}  // namespace clers::internal

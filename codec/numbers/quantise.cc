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
#include "codec/numbers/near_grid.h"
#include "codec/numbers/number_format.h"
#include "codec/numbers/number_maps.h"
#include "codec/numbers/outliers.h"
#include "codec/numbers/place_numbers.h"

namespace clers::internal {
namespace {

using Kind = Precision::Kind;

/// So far from its origin a number may be: there doubles still tell all points of a grid apart.
constexpr double most_steps = double(std::int64_t(1) << 50);

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

/// What a number is to maps: a float, or a whole number of any type.
template <class T>
using NumberType = std::conditional_t<std::is_floating_point_v<T>, T, Whole>;

template <class T>
WordOf<NumberType<T>> word_of(T x) {
  if constexpr (std::is_floating_point_v<T>)
    return std::bit_cast<WordOf<T>>(x);
  else
    return static_cast<std::make_unsigned_t<T>>(x) ^ key_mask(scalar_of<T>());
}
template <class T>
T number_of(WordOf<NumberType<T>> word) {
  if constexpr (std::is_floating_point_v<T>)
    return std::bit_cast<T>(word);
  else
    return static_cast<T>(static_cast<std::make_unsigned_t<T>>(word ^ key_mask(scalar_of<T>())));
}

/// Calls use with a function that gives point k of a grid.
template <class T, class Use>
auto with_points(const NumberSystem& system, Use use) {
  const auto step = static_cast<std::int64_t>(system.step);
  return with_map<NumberType<T>>(system, scalar_of<T>(), [&](const auto& map) {
    return use([step, &map](std::int64_t k) { return number_of<T>(map.word(k * step, 0)); });
  });
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

/// The point of a grid that is nearest to a number, the lower of two. `k` is near it, and
/// `error` how far off.
template <class T, class Points>
std::int64_t nearest_point(T x, std::int64_t k, const Points& point, double& error) {
  for (const std::int64_t way : {-1, 1})
    for (;;) {
      const double other = difference(x, point(k + way));
      if (!(other < error || (way < 0 && other == error && point(k + way) < point(k)))) break;
      k += way;
      error = other;
    }
  return k;
}

struct Moved {
  double error = 0;                         ///< the largest difference
  std::optional<std::size_t> too_far = {};  ///< the first number that is too far away
};

/// Where the numbers of a component go: packed values.
template <class T>
struct Column {
  std::byte* first;
  std::size_t stride;

  void set(std::size_t i, T x) const { std::memcpy(first + i * stride, &x, sizeof(T)); }
};

/// Moves the numbers of a component to a grid.
template <class T>
Moved move_to(const std::vector<T>& numbers, const Grid& grid, bool keep_zeros,
              const NumberSystem& system, const Column<T>& to) {
  Moved moved;
  const double sure = 0.49 * grid.step;  // no other point is as near
  with_points<T>(system, [&](const auto& point) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const T x = numbers[i];
      const double k = (static_cast<double>(x) - grid.origin) / grid.step;
      if (!(std::fabs(k) < most_steps)) {
        moved.too_far = i;
        return;
      }
      const std::int64_t near = nearest_integer(k);
      T y = point(near);
      double error = 0;
      if constexpr (std::is_floating_point_v<T>)
        error = std::fabs(static_cast<double>(x) - static_cast<double>(y));
      else
        error = difference(x, y);
      if (!(error <= sure)) {
        error = difference(x, y);
        y = point(nearest_point(x, near, point, error));
      }
      to.set(i, keep_zeros && x == y ? x : y);
      moved.error = std::max(moved.error, error);
    }
  });
  return moved;
}

/// Whether two numbers of a sample are nearer to each other than points a step apart can be. On
/// no such grid, few are enough to show it.
template <class T>
bool has_nearer(const std::vector<T>& numbers, double largest, double step) {
  const double rounding =
      std::is_floating_point_v<T> ? largest * double(std::numeric_limits<T>::epsilon()) : 0;
  for (const std::size_t most : {std::size_t(128), std::size_t(2048)}) {
    const std::size_t every = numbers.size() / most + 1;
    std::vector<T> sample;
    for (std::size_t i = 0; i < numbers.size(); i += every) sample.push_back(numbers[i]);
    std::sort(sample.begin(), sample.end());
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
std::optional<NumberSystem> coarser_system(const std::vector<T>& numbers, double largest,
                                           double step) {
  using Number = NumberType<T>;
  if (has_nearer(numbers, largest, step)) return std::nullopt;
  std::vector<WordOf<Number>> words;
  words.reserve(numbers.size());
  for (const T x : numbers) words.push_back(word_of(x));
  const NumberSystem found = find_system<Number>(words, Search::thorough);
  if (found.low_bits > 0 || found.ulps > 0) return std::nullopt;
  if (found.map != (std::is_floating_point_v<T> ? NumberMap::quotient : NumberMap::word))
    return std::nullopt;
  const double apart = std::is_floating_point_v<T> ? spacing(found) : double(found.step);
  if (!(apart >= step)) return std::nullopt;
  const bool has_all = with_map<Number>(found, scalar_of<T>(), [&](const auto& map) {
    const Placing<Number, std::decay_t<decltype(map)>> placing(found, map);
    return std::all_of(words.begin(), words.end(),
                       [&](auto word) { return placing.place(word).exact; });
  });
  return has_all ? std::optional(found) : std::nullopt;
}

template <class T>
class Quantiser {
 public:
  Quantiser(const AttributeView& a, const Precision& precision)
      : a_(a), precision_(precision), count_(value_count(a)) {
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
    QuantisedValues all;
    if (!std::is_floating_point_v<T> && grids[0].step <= 1) return all;
    all.values.resize(count_ * a_.value_size());
    bool all_writable = true;
    for (std::size_t c = 0; c < numbers_.size(); ++c) {
      Grid grid = grids[c];
      if (std::is_floating_point_v<T> && !keep_zeros)
        if (const auto near = NearGrid(grid.step).find(numbers_[c])) grid = *near;
      NumberSystem system = system_of(grid, a_.scalar, bounds_[c].largest());
      bool writable = is_writable<T>(system, grid, bounds_[c]);
      const Column<T> column{all.values.data() + c * sizeof(T), a_.value_size()};
      Moved component = move_to(numbers_[c], grid, keep_zeros, system, column);
      if (component.too_far)
        return not_on_grid(a_, *component.too_far, "is too many steps away from the origin");
      if (!keep_zeros || component.error == 0)
        if (const auto coarser = coarser_system(numbers_[c], bounds_[c].largest(), grids[c].step)) {
          for (std::size_t i = 0; i < count_; ++i) column.set(i, numbers_[c][i]);
          component = {};
          system = *coarser;
          writable = true;
        }
      all_writable &= writable;
      all.plan.error = std::max(all.plan.error, component.error);
      all.plan.systems.push_back(system);
    }
    if (all.plan.error == 0) return QuantisedValues{};
    if (!all_writable) all.plan.systems.clear();
    return all;
  }

  const AttributeView& a_;
  const Precision& precision_;
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

Expected<QuantisedValues> quantise(const AttributeView& attribute, const Precision& precision) {
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
    return Quantiser<decltype(type)>(attribute, precision).run();
  });
}

}  // namespace clers::internal

// A grid that numbers nearly lie on, as those that were scaled or printed after they were rounded.
#ifndef CLERS_CODEC_NUMBERS_NEAR_GRID_H
#define CLERS_CODEC_NUMBERS_NEAR_GRID_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace clers::internal {

/// origin + k * step.
struct Grid {
  double origin = 0, step = 0;
};

/// A few of many numbers, then more of them, sorted when they are asked for: where numbers are on
/// no grid few show it.
template <class T>
class SortedSamples {
 public:
  static constexpr std::size_t count = 3;

  explicit SortedSamples(const std::vector<T>& numbers) : numbers_(numbers) {}

  const std::vector<T>& operator[](std::size_t i) {
    constexpr std::array<std::size_t, count> most = {128, 512, 2048};
    std::vector<T>& sample = samples_[i];
    if (!sample.empty()) return sample;
    const std::size_t every = numbers_.size() / most[i] + 1;
    for (std::size_t k = 0; k < numbers_.size(); k += every) sample.push_back(numbers_[k]);
    std::sort(sample.begin(), sample.end());
    return sample;
  }

 private:
  const std::vector<T>& numbers_;
  std::array<std::vector<T>, count> samples_;
};

/// Finds the grid of numbers, if its steps are longer than `step`, and no number is further from
/// its nearest point than 0.08 of them and 0.45 `step`: to move them there is nearer than to move
/// them to a grid of `step`, whose numbers are larger.
///
///     o  oo      o        o  o     o       numbers
///     |      |       |       |       |     too far from all points: no grid
///
/// Cost: that of sorting samples, and a look at all numbers if these have a grid.
class NearGrid {
 public:
  explicit NearGrid(double step) : step_(step) {}

  template <class T>
  std::optional<Grid> find(const std::vector<T>& numbers, SortedSamples<T>& samples) {
    for (std::size_t i = 0; i < samples.count; ++i)
      if (!cluster(samples[i]) && (i + 1 == samples.count || too_near_)) return std::nullopt;
    double least = centres_.back() - centres_.front();
    for (std::size_t i = 1; i < centres_.size(); ++i)
      least = std::min(least, centres_[i] - centres_[i - 1]);
    for (const double parts : {1., 2., 3.}) {
      if (least / parts < step_) break;
      auto grid = fit(least / parts);
      if (grid && has_all(numbers, *grid)) return grid;
    }
    return std::nullopt;
  }

 private:
  /// Numbers that are one point of the grid have one centre. Fails where two are neither near each
  /// other nor a step apart, which is soon where there is no grid.
  template <class T>
  bool cluster(const std::vector<T>& sorted) {
    const auto at = [&](std::size_t i) { return static_cast<double>(sorted[i]); };
    centres_.clear();
    too_near_ = false;
    for (std::size_t begin = 0, i = 1; i <= sorted.size(); ++i) {
      const double gap = i < sorted.size() ? at(i) - at(i - 1) : step_;
      if (gap <= 0.1 * step_) continue;
      if (gap < 0.9 * step_) {
        too_near_ = true;
        return false;
      }
      centres_.push_back(0.5 * at(begin) + 0.5 * at(i - 1));  // no overflow
      begin = i;
    }
    return centres_.size() > 2;
  }

  /// The steps between centres by least squares, from the nearest to the farthest: the longer the
  /// way, the better the step is known.
  std::optional<Grid> fit(double step) const {
    double products = 0, squares = 0;
    for (const double centre : centres_) {
      const double way = centre - centres_[0], k = std::floor(way / step + 0.5);
      if (std::fabs(way - k * step) > 0.16 * step) return std::nullopt;
      products += way * k;
      squares += k * k;
      if (squares > 0) step = products / squares;
    }
    // Products of the greatest numbers may overflow.
    return step >= 1.05 * step_ && std::isfinite(step) ? std::optional(Grid{centres_[0], step})
                                                       : std::nullopt;
  }

  static double off(double x, const Grid& grid) {
    const double k = std::floor((x - grid.origin) / grid.step + 0.5);
    return x - (grid.origin + k * grid.step);
  }

  /// Moves the origin to the middle of how far numbers are off.
  template <class T>
  bool has_all(const std::vector<T>& numbers, Grid& grid) const {
    double least = 0, greatest = 0;
    for (const T x : numbers) {
      const double d = off(static_cast<double>(x), grid);
      least = std::min(least, d);
      greatest = std::max(greatest, d);
    }
    grid.origin += 0.5 * (least + greatest);
    return 0.5 * (greatest - least) <= std::min(0.08 * grid.step, 0.45 * step_);
  }

  double step_;
  std::vector<double> centres_;
  bool too_near_ = false;  ///< cluster() failed, and would whatever other numbers there are
};

}  // namespace clers::internal

#endif

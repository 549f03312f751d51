// Steps that numbers have in common, but for noise.
#ifndef CLERS_CODEC_NUMBERS_APPROXIMATE_STEPS_H
#define CLERS_CODEC_NUMBERS_APPROXIMATE_STEPS_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace clers::internal {

struct ApproximateSteps {
  double origin;  ///< one of the numbers, nearly
  double length;
  double error;  ///< of the length, about
  double noise;  ///< of each number
};

/// Finds the length of steps of which the differences of nearly all numbers are multiples, if each
/// number may be `noise` beside its step. Differences, because numbers may be large beside a step.
///
/// The smallest gap between neighbours is a step, or some. Longer and longer gaps are counted in
/// steps, and make the step that much more exact, before the next is too long to be counted.
/// Precondition: numbers are finite and sorted. Cost: linear but for a sort of the gaps.
inline std::optional<ApproximateSteps> approximate_steps(const std::vector<double>& numbers,
                                                         double noise) {
  // Numbers that are one but for noise are replaced by their mean.
  std::vector<double> distinct;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t end = i + 1;
    while (end < numbers.size() && numbers[end] - numbers[end - 1] <= 2 * noise) ++end;
    distinct.push_back(numbers[i] + (numbers[end - 1] - numbers[i]) / 2);
    i = end;
  }
  if (distinct.size() < 16) return std::nullopt;
  std::vector<double> gaps;
  for (std::size_t i = 1; i < distinct.size(); ++i) gaps.push_back(distinct[i] - distinct[i - 1]);
  std::sort(gaps.begin(), gaps.end());
  for (const double parts : {1., 2., 3.}) {
    double length = gaps[gaps.size() / 100] / parts, sum = 0, steps = 0;
    if (!(length > 4 * noise)) break;
    std::size_t off = 0;
    for (const double gap : gaps) {
      const double n = std::floor(gap / length + .5);
      if (n < 1 || std::fabs(gap - n * length) > 2 * noise + 1e-9 * gap) {
        ++off;
        continue;
      }
      sum += gap;
      steps += n;
      length = sum / steps;
    }
    if (off * 20 > gaps.size()) continue;
    return ApproximateSteps{distinct[distinct.size() / 2], length, 2 * noise / steps, noise};
  }
  return std::nullopt;
}

}  // namespace clers::internal

#endif

#include "bench/schedule.h"

#include <algorithm>

namespace clers::bench {

bool is_sampled(const Trial& trial, const Sampling& sampling) {
  return std::max(trial.encode_seconds, trial.decode_seconds) <= sampling.budget;
}

double seconds_for(const Trial& trial, const Sampling& sampling) {
  if (!is_sampled(trial, sampling)) return 0;
  double sum = 0;
  for (const double once : {trial.encode_seconds, trial.decode_seconds}) {
    const double sample = std::max(once, sampling.min_sample);
    const int least = std::min(sampling.least, sampling.repeats);
    const double spent = std::clamp(sampling.budget, least * sample, sampling.repeats * sample);
    sum += once + spent;  // once to warm up
  }
  return sum;
}

Sampling fitted(const Sampling& sampling, const std::vector<const Trial*>& trials, double seconds) {
  const auto with = [&](double budget) {
    Sampling s = sampling;
    s.budget = budget;
    return s;
  };
  const auto fits = [&](double budget) {
    double sum = 0;
    for (const Trial* t : trials) sum += seconds_for(*t, with(budget));
    return sum <= seconds;
  };
  if (fits(sampling.budget)) return sampling;
  double low = 0, high = sampling.budget;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (fits(middle) ? low : high) = middle;
  }
  return with(low);
}

}  // namespace clers::bench

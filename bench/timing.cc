#include "bench/timing.h"

#include <time.h>

#include <algorithm>
#include <cmath>

namespace clers::bench {
namespace {

// What a pair of clock calls costs, which is not the task's.
double clock_cost() {
  double best = 1;
  for (int i = 0; i < 1000; ++i) {
    const double start = thread_seconds();
    best = std::min(best, thread_seconds() - start);
  }
  return best;
}

double run_once(const Task& task, double overhead) {
  const double start = thread_seconds();
  task.run();
  const double taken = thread_seconds() - start - overhead;
  task.reset();
  return std::max(taken, 1e-9);
}

double median(std::vector<double> values) {
  const std::size_t half = values.size() / 2;
  std::sort(values.begin(), values.end());
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

// samples[i][r] is task i's in round r; a task may have stopped early.
using Samples = std::vector<std::vector<double>>;

Samples take_samples(const std::vector<Task>& tasks, const Sampling& sampling) {
  const double overhead = clock_cost();
  struct State {
    int runs = 1;  // in a sample
    double spent = 0;
    bool enough = false;
  };
  std::vector<State> states(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const double first = run_once(tasks[i], overhead);
    states[i].runs = std::max(1, static_cast<int>(std::ceil(sampling.min_sample / first)));
  }
  Samples samples(tasks.size());
  for (bool more = !tasks.empty(); more;) {
    more = false;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      State& state = states[i];
      if (state.enough) continue;
      double sum = 0;
      for (int r = 0; r < state.runs; ++r) sum += run_once(tasks[i], overhead);
      samples[i].push_back(sum / state.runs);
      state.spent += sum;
      const auto count = static_cast<int>(samples[i].size());
      state.enough = count >= sampling.repeats || (count >= 3 && state.spent >= sampling.budget);
      more |= !state.enough;
    }
  }
  return samples;
}

}  // namespace

double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

std::vector<Timing> time_in_turns(const std::vector<Task>& tasks, const Sampling& sampling) {
  Samples samples = take_samples(tasks, sampling);
  std::vector<Timing> timings(tasks.size());
  std::size_t rounds = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    timings[i].samples = samples[i].size();
    timings[i].median = median(samples[i]);
    timings[i].best = *std::min_element(samples[i].begin(), samples[i].end());
    rounds = std::max(rounds, samples[i].size());
  }
  for (std::size_t r = 0; r < rounds; ++r) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      if (r >= samples[i].size()) continue;
      sum += std::log(samples[i][r] / timings[i].median);
      ++count;
    }
    const double slowness = std::exp(sum / count);
    for (std::vector<double>& s : samples)
      if (r < s.size()) s[r] /= slowness;
  }
  double to_best = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    timings[i].even = median(samples[i]);
    to_best += std::log(timings[i].best / timings[i].even) / static_cast<double>(tasks.size());
  }
  for (Timing& t : timings) t.even *= std::exp(to_best);
  return timings;
}

}  // namespace clers::bench

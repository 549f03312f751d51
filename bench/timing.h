// CPU time of encodes and decodes, taken in turns.
#ifndef CLERS_BENCH_TIMING_H
#define CLERS_BENCH_TIMING_H

#include <cstddef>
#include <functional>
#include <vector>

namespace clers::bench {

/// Seconds of CPU time that this thread has used.
double thread_seconds();

/// Something to be timed: `run` is, `reset` is not.
struct Task {
  std::function<void()> run;
  std::function<void()> reset;
};

struct Sampling {
  int repeats = 15;          ///< samples wanted of each task
  double min_sample = 2e-3;  ///< seconds: short runs are repeated within a sample
  double budget = 0.4;       ///< seconds for one task, after which three samples are enough
};

/// Seconds for one run.
struct Timing {
  double even = 0;  ///< what speeds and ratios are made of, see time_in_turns
  double median = 0, best = 0;
  std::size_t samples = 0;
};

/// Times all tasks in turns: one sample of each, then the next round, so that whatever else the
/// machine does falls on all alike. Before that each runs once, to warm up.
///
/// A busy machine slows whole rounds, by tens of percent, and neither the best sample nor the
/// median of a task then has a steady ratio to another's. So each sample is divided by the slowness
/// of its round: the geometric mean, over the tasks, of its sample over the task's median. `even`
/// is the median of these, scaled for all tasks by the same factor, so that they agree on average
/// with the best samples. On a quiet machine all three are the same.
std::vector<Timing> time_in_turns(const std::vector<Task>& tasks, const Sampling& sampling);

}  // namespace clers::bench

#endif

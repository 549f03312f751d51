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
  int repeats = 60;          ///< rounds: samples wanted of each task
  double min_sample = 2e-5;  ///< seconds: shorter runs are repeated within a sample
  double budget = 1;         ///< seconds for one task; a slow one sits rounds out
  int least = 3;             ///< samples that a slow task gets nevertheless
};

/// Seconds for a run, as they were taken.
using Samples = std::vector<double>;

/// Runs all tasks in turns: one sample of each, then the next round, so that whatever else the
/// machine does falls on all alike, and that no task finds the branch predictor trained on its own
/// input by the run before. Before that each runs once, to warm up. A task that takes long is left
/// out of rounds evenly.
std::vector<Samples> sample_in_turns(const std::vector<Task>& tasks, const Sampling& sampling);

/// Seconds for one run.
struct Timing {
  double quiet = 0;  ///< mean of the fastest quarter, three at least: what speeds are made of
  double median = 0, best = 0;
  std::size_t samples = 0;
};

/// Whoever shares caches and memory with us only ever slows a sample, by tens of percent and some
/// codecs more than others. The median is then a measure of the neighbours, and the best sample one
/// of luck; the mean of the fastest quarter has the steadiest ratios from run to run.
/// Precondition: there is a sample.
Timing summary(Samples samples);

}  // namespace clers::bench

#endif

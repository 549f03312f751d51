#include "bench/timing.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

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

// Makes the branch predictor forget what it learnt from the run before, by branches that cannot be
// predicted. A decoder of 20 000 triangles that runs again on the same bytes, or after another one
// of the same symbols, is up to 30 % faster: who decodes a mesh once never sees that.
void forget_branches() {
  static std::uint64_t random = 1;
  static volatile std::uint32_t paths[4];
  for (int i = 0; i < 1 << 15; ++i) {
    random = random * 6364136223846793005u + 1442695040888963407u;
    const auto bits = static_cast<std::uint32_t>(random >> 60);
    if (bits & 1) paths[0] = paths[0] + 1;
    if (bits & 2) paths[1] = paths[1] + 3;
    if (bits & 4) {
      paths[2] = paths[2] + 5;
    } else {
      paths[3] = paths[3] + 7;
    }
  }
}

double run_once(const Task& task, double overhead) {
  const double start = thread_seconds();
  task.run();
  const double taken = thread_seconds() - start - overhead;
  task.reset();
  return std::max(taken, 1e-9);
}

}  // namespace

double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

std::vector<Samples> sample_in_turns(const std::vector<Task>& tasks, const Sampling& sampling) {
  const double overhead = clock_cost();
  const int least = std::min(sampling.least, sampling.repeats);
  struct Pace {
    int runs = 1;  // in a sample
    double budget = 0, spent = 0;
  };
  std::vector<Pace> paces(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const double first = run_once(tasks[i], overhead);
    paces[i].runs = std::max(1, static_cast<int>(std::ceil(sampling.min_sample / first)));
    paces[i].budget = std::max(sampling.budget, least * first * paces[i].runs);
  }
  std::vector<Samples> samples(tasks.size());
  const auto sample = [&](std::size_t i) {
    forget_branches();
    double sum = 0;
    for (int r = 0; r < paces[i].runs; ++r) sum += run_once(tasks[i], overhead);
    samples[i].push_back(sum / paces[i].runs);
    paces[i].spent += sum;
  };
  for (int round = 0; round < sampling.repeats; ++round)
    for (std::size_t i = 0; i < tasks.size(); ++i)
      if (paces[i].spent <= paces[i].budget * round / sampling.repeats) sample(i);
  // Where the first run was the fastest by far.
  for (std::size_t i = 0; i < tasks.size(); ++i)
    while (static_cast<int>(samples[i].size()) < least) sample(i);
  return samples;
}

Timing summary(Samples s) {
  std::sort(s.begin(), s.end());
  const std::size_t half = s.size() / 2;
  const std::size_t quarter = std::min(s.size(), std::max<std::size_t>(3, s.size() / 4));
  Timing t;
  t.quiet = std::accumulate(s.begin(), s.begin() + std::ptrdiff_t(quarter), 0.0) / double(quarter);
  t.median = s.size() % 2 ? s[half] : 0.5 * (s[half - 1] + s[half]);
  t.best = s.front();
  t.samples = s.size();
  return t;
}

}  // namespace clers::bench

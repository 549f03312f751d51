// How much time a run of all samples may take, and who gets how much of it.
#ifndef CLERS_BENCH_SCHEDULE_H
#define CLERS_BENCH_SCHEDULE_H

#include <vector>

#include "bench/timing.h"
#include "bench/trial.h"

namespace clers::bench {

/// Are samples taken of this codec on this mesh, or was the first run so slow that it stands?
bool is_sampled(const Trial& trial, const Sampling& sampling);

/// Seconds that sample_in_turns takes for encodes and decodes, by what the first run took.
double seconds_for(const Trial& trial, const Sampling& sampling);

/// `sampling` with the largest budget, at most its own, with which all `trials` take no more than
/// `seconds`.
Sampling fitted(const Sampling& sampling, const std::vector<const Trial*>& trials, double seconds);

}  // namespace clers::bench

#endif

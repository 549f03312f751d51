// Pieces decoded by several threads, as far as memory allows. Knows no piece.
#ifndef CLERS_CODEC_FILE_DECODE_JOBS_H
#define CLERS_CODEC_FILE_DECODE_JOBS_H

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "codec/base/budget.h"
#include "codec/base/parallel.h"
#include "codec/error.h"
#include "codec/options.h"

namespace clers::internal {

/// Calls decode(j) for each j below work.size(), from as many of the threads that options ask for
/// as find room where job j takes work[j] of `left` bytes. Returns the outcomes, for which the
/// caller has taken memory. Reports progress. What decode throws passes through.
template <class Decode>
std::vector<Expected<Done>> run_decode_jobs(std::vector<std::uint64_t> work, std::uint64_t left,
                                            const DecodeOptions& options, const Decode& decode) {
  const std::size_t jobs = work.size();
  std::vector<Expected<Done>> outcomes(jobs, Done{});
  std::atomic<std::size_t> done{0};
  const unsigned workers = workers_that_fit(std::move(work), options.threads, left);
  for_each_item(jobs, workers, [&](std::size_t j, unsigned worker) {
    if (options.progress && worker == 0)
      options.progress("decode", static_cast<double>(done) / static_cast<double>(jobs));
    outcomes[j] = decode(j);
    ++done;
  });
  return outcomes;
}

}  // namespace clers::internal

#endif

// What a call may still take of Limits::memory. Knows what bytes were counted, and not for what.
//
// Headers say how large everything will be. So the peak of a call is known before any of it is
// made, and a file is refused or decoded whatever the number of threads: only as many work at a
// time as there is memory for.
#ifndef CLERS_CODEC_BASE_BUDGET_H
#define CLERS_CODEC_BASE_BUDGET_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "codec/base/parallel.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace clers::internal {

class Budget {
 public:
  Budget(const Limits& limits, std::size_t file_size)
      : limit_(std::min<std::uint64_t>(
            limits.memory.value_or(
                std::max(std::uint64_t(1) << 30, 4096 * std::uint64_t(file_size))),
            PTRDIFF_MAX)) {}  // no more than can be addressed, so that sizes fit in std::size_t

  std::uint64_t left() const { return limit_ - used_; }

  /// Is there room for so many bytes more? To be asked before they are allocated. Error: limit.
  Expected<Done> check(std::uint64_t bytes) const {
    if (bytes <= left()) return Done{};
    auto failure =
        fail(ErrorCode::limit, "the file needs " + std::to_string(used_ + bytes) +
                                   " bytes of memory, the limit is " + std::to_string(limit_));
    failure.error.limited = Limited::memory;
    failure.error.needed = used_ + bytes;
    return failure;
  }
  /// Checks, and counts what stays until the end of the call.
  Expected<Done> take(std::uint64_t bytes) {
    if (auto ok = check(bytes); !ok) return ok;
    used_ += bytes;
    return Done{};
  }

 private:
  std::uint64_t limit_, used_ = 0;
};

/// How many workers, of those that are asked for (0: one a core), may take items that need `bytes`
/// each while `left` bytes are: at least 1.
inline unsigned workers_that_fit(std::vector<std::uint64_t> bytes, unsigned threads,
                                 std::uint64_t left) {
  const unsigned most = worker_count(threads, bytes.size());
  std::sort(bytes.begin(), bytes.end(), std::greater<>());
  unsigned fit = 0;
  for (std::uint64_t sum = 0; fit < most && fit < bytes.size(); ++fit)
    if ((sum += bytes[fit]) > left) break;
  return std::max(fit, 1u);
}

}  // namespace clers::internal

#endif

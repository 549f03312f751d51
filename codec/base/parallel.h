// Independent pieces of work, done by several threads. No other file of the library starts one.
#ifndef CLERS_CODEC_BASE_PARALLEL_H
#define CLERS_CODEC_BASE_PARALLEL_H

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace clers::internal {

/// How many threads there is work for, when so many are asked for (0: one a core): at least 1.
inline unsigned worker_count(unsigned threads, std::size_t items) {
  if (threads == 0) threads = std::thread::hardware_concurrency();
  return static_cast<unsigned>(std::clamp<std::size_t>(items, 1, std::max(threads, 1u)));
}

/// Calls work(item, worker) once for each item 0 .. items - 1, from up to `threads` threads (0: one
/// a core). Workers have numbers below worker_count(threads, items); worker 0 is the calling
/// thread. Items are begun in their order. When one throws, no more are begun, and what it threw is
/// thrown again at the end.
template <class Work>
void for_each_item(std::size_t items, unsigned threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr thrown;
  std::mutex guards_thrown;
  const auto run = [&](unsigned worker) {
    try {
      for (std::size_t item; (item = next.fetch_add(1)) < items;) work(item, worker);
    } catch (...) {
      next = items;
      const std::lock_guard lock(guards_thrown);
      if (!thrown) thrown = std::current_exception();
    }
  };
  {
    const unsigned most = worker_count(threads, items);
    std::vector<std::jthread> others;
    others.reserve(most);
    try {
      for (unsigned worker = 1; worker < most; ++worker) others.emplace_back(run, worker);
    } catch (const std::system_error&) {  // no more threads to be had: those there are do it
    }
    run(0);
  }
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace clers::internal

#endif

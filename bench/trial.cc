#include "bench/trial.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>

#include "bench/heap.h"
#include "bench/timing.h"

namespace clers::bench {
namespace {

// Trivially copyable: it crosses a pipe.
struct Report {
  char failure[240];
  std::uint64_t bytes, position_bytes, encode_peak, decode_peak;
  double encode_seconds, decode_seconds;
  Fidelity fidelity;
};

Report run(const CodecEntry& entry, const Input& input, Mode mode) {
  Report report{};
  try {
    const auto codec = entry.make();
    codec->prepare(input, mode);
    const auto seconds = [](const auto& work, std::uint64_t& peak) {
      start_counting_heap();
      const double start = thread_seconds();
      work();
      const double taken = thread_seconds() - start;
      peak = stop_counting_heap();
      return taken;
    };
    report.encode_seconds = seconds([&] { codec->encode(); }, report.encode_peak);
    report.bytes = codec->bytes();
    report.position_bytes = codec->position_bytes();
    report.decode_seconds = seconds([&] { codec->decode(); }, report.decode_peak);
    report.fidelity = check(input, codec->output(), mode);
    codec->discard();
    // Once more, since the first had to fetch its memory: an encoder that is too slow to be sampled
    // should not make its decoder look slow.
    std::uint64_t peak = 0;
    report.decode_seconds =
        std::min(report.decode_seconds, seconds([&] { codec->decode(); }, peak));
  } catch (const std::exception& e) {
    stop_counting_heap();
    std::snprintf(report.failure, sizeof report.failure, "%s", *e.what() ? e.what() : "failed");
  }
  return report;
}

std::string fate(int status) {
  if (WIFSIGNALED(status)) {
    if (WTERMSIG(status) == SIGXCPU) return "takes too long";
    return std::string("crashes (") + strsignal(WTERMSIG(status)) + ")";
  }
  return "ends the process";
}

}  // namespace

Trial try_codec(const CodecEntry& entry, const Input& input, Mode mode, unsigned seconds) {
  Trial trial;
  int ends[2];
  if (pipe(ends) != 0) {
    trial.failure = "no pipe to be had";
    return trial;
  }
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    const rlimit cpu{seconds, seconds + 1};
    setrlimit(RLIMIT_CPU, &cpu);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const Report report = run(entry, input, mode);
    const bool sent = write(ends[1], &report, sizeof report) == ssize_t(sizeof report);
    _exit(sent ? 0 : 1);  // no destructors: a codec that corrupted its heap has told its result
  }
  close(ends[1]);
  Report report{};
  const bool told = child > 0 && read(ends[0], &report, sizeof report) == ssize_t(sizeof report);
  close(ends[0]);
  int status = 0;
  if (child > 0) waitpid(child, &status, 0);
  if (!told) {
    trial.failure = child > 0 ? fate(status) : "no process to be had";
    return trial;
  }
  trial.failure = report.failure;
  trial.bytes = report.bytes;
  trial.position_bytes = report.position_bytes;
  trial.encode_seconds = report.encode_seconds;
  trial.decode_seconds = report.decode_seconds;
  trial.encode_peak = report.encode_peak;
  trial.decode_peak = report.decode_peak;
  trial.fidelity = report.fidelity;
  return trial;
}

}  // namespace clers::bench

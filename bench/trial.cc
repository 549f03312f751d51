#include "bench/trial.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <exception>

#include "bench/heap.h"

namespace clers::bench {
namespace {

// Trivially copyable: it crosses a pipe.
struct Report {
  char failure[240];
  std::uint64_t bytes, encode_peak, decode_peak;
  Fidelity fidelity;
};

Report run(const CodecEntry& entry, const Input& input, Mode mode) {
  Report report{};
  try {
    const auto codec = entry.make();
    codec->prepare(input, mode);
    start_counting_heap();
    codec->encode();
    report.encode_peak = stop_counting_heap();
    report.bytes = codec->bytes();
    start_counting_heap();
    codec->decode();
    report.decode_peak = stop_counting_heap();
    report.fidelity = check(input, codec->output(), mode);
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
  trial.encode_peak = report.encode_peak;
  trial.decode_peak = report.decode_peak;
  trial.fidelity = report.fidelity;
  return trial;
}

}  // namespace clers::bench

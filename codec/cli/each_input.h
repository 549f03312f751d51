// What commands have in common: they work on one input after the other.
#ifndef CLERS_CODEC_CLI_EACH_INPUT_H
#define CLERS_CODEC_CLI_EACH_INPUT_H

#include <fmt/format.h>

#include <new>
#include <span>
#include <stdexcept>
#include <string>

#include "codec/cli/commands.h"
#include "codec/cli/destination.h"
#include "codec/cli/files.h"
#include "codec/cli/job.h"

namespace clers::cli {

/// Runs one piece of work and prints why it stops, running out of memory included.
template <class Work>
Exit attempt(const std::string& file, Work work) {
  Stop why{Exit::limit, input_name(file) + ": not enough memory"};
  try {
    const Outcome<Exit> outcome = work();
    if (outcome) return *outcome;
    why = outcome.error();
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {  // a container asked for more than there can be
  }
  complain(why.line);
  return why.exit;
}

/// Runs a command on every input: `work(Job&)`. One that fails does not keep the others from being
/// done; the first failure decides the status.
template <class Work>
Exit for_each_input(const Options& options, std::span<const Stage> plan, Work work) {
  Exit all = Exit::done;
  const std::size_t count = options.inputs.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& input = options.inputs[i];
    const std::string which = count > 1 ? fmt::format("{}/{} ", i + 1, count) : "";
    const Exit one = attempt(input, [&]() -> Outcome<Exit> {
      Job job(options, input, which + input_name(input), plan);
      const Outcome<Done> done = work(job);
      if (!done) return Failure{done.error()};
      return Exit::done;
    });
    if (all == Exit::done) all = one;
  }
  return all;
}

/// The same for commands that write a file for each: `work(const Options&, Job&, const
/// Destination&)`.
template <class Work>
Exit for_each_output(const Options& options, const char* suffix, std::span<const Stage> plan,
                     Work work) {
  const auto to = Destination::find(options, suffix);
  if (!to) {
    complain(to.error().line);
    return to.error().exit;
  }
  return for_each_input(options, plan, [&](Job& job) { return work(options, job, *to); });
}

}  // namespace clers::cli

#endif

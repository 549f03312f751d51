// A first run of a codec on a mesh in a process of its own, where a crash harms nobody.
#ifndef CLERS_BENCH_TRIAL_H
#define CLERS_BENCH_TRIAL_H

#include <cstddef>
#include <cstdint>
#include <string>

#include "bench/codec.h"
#include "bench/fidelity.h"

namespace clers::bench {

/// What need not be repeated, since it is the same every time.
struct Trial {
  std::string failure;  ///< why the codec cannot be measured on this mesh; empty if it can
  std::uint64_t bytes = 0, position_bytes = 0;
  double encode_seconds = 0, decode_seconds = 0;   ///< of processor time; the faster of two decodes
  std::uint64_t encode_peak = 0, decode_peak = 0;  ///< heap, without what prepare() made
  Fidelity fidelity;
};

/// Forks, encodes, decodes and checks. `seconds` of CPU time are allowed.
Trial try_codec(const CodecEntry& entry, const Input& input, Mode mode, unsigned seconds);

}  // namespace clers::bench

#endif

// Google's Draco, the yardstick.
#ifndef CLERS_BENCH_RIVALS_DRACO_H
#define CLERS_BENCH_RIVALS_DRACO_H

#include <string>
#include <vector>

#include "bench/codec.h"

namespace clers::bench {

/// draco-standard and draco-valence (connectivity), draco-cl5, -cl7, -cl10 (whole file; cl as in
/// the draco_encoder program: speed 10 - cl).
std::vector<CodecEntry> draco_codecs();
std::string draco_version();

}  // namespace clers::bench

#endif

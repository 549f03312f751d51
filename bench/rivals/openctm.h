// OpenCTM: MG1 (lossless) and MG2 (positions on a grid).
#ifndef CLERS_BENCH_RIVALS_OPENCTM_H
#define CLERS_BENCH_RIVALS_OPENCTM_H

#include <string>
#include <vector>

#include "bench/codec.h"

namespace clers::bench {

std::vector<CodecEntry> openctm_codecs();
std::string openctm_version();

}  // namespace clers::bench

#endif

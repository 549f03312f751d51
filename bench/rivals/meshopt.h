// meshoptimizer: index and vertex codecs, with zstd after them as its author advises.
#ifndef CLERS_BENCH_RIVALS_MESHOPT_H
#define CLERS_BENCH_RIVALS_MESHOPT_H

#include <string>
#include <vector>

#include "bench/codec.h"

namespace clers::bench {

/// meshopt-{vcache,strip} by the order of triangles, raw and with -zstd19.
std::vector<CodecEntry> meshopt_codecs();
std::string meshopt_version();

}  // namespace clers::bench

#endif

// A newer meshoptimizer than the distribution's: WebAssembly of the npm registry, run by node.
#ifndef CLERS_BENCH_RIVALS_MESHOPT_NPM_H
#define CLERS_BENCH_RIVALS_MESHOPT_NPM_H

#include <string>
#include <vector>

#include "bench/codec.h"

namespace clers::bench {

/// meshopt-VERSION-strip-zstd19, for its bytes alone; none if the build had no node or npm.
std::vector<CodecEntry> meshopt_npm_codecs();
std::string meshopt_npm_version();

}  // namespace clers::bench

#endif

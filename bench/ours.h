// clers itself, through its public API.
#ifndef CLERS_BENCH_OURS_H
#define CLERS_BENCH_OURS_H

#include <string>
#include <vector>

#include "bench/codec.h"

namespace clers::bench {

/// clers-1, clers-3, clers-5, clers-7, clers-9.
std::vector<CodecEntry> clers_codecs();

}  // namespace clers::bench

#endif

// fpzip: floats as arrays, without knowledge of faces.
#ifndef CLERS_BENCH_RIVALS_FPZIP_H
#define CLERS_BENCH_RIVALS_FPZIP_H

#include <string>
#include <vector>

#include "bench/codec.h"

namespace clers::bench {

/// fpzip-zstd19: positions by fpzip, in the file's order and in that shape of the array that takes
/// least; indices by zstd -19.
std::vector<CodecEntry> fpzip_codecs();
std::string fpzip_version();

}  // namespace clers::bench

#endif

// zstd, of the plain index buffer: what one has without any mesh codec.
#ifndef CLERS_BENCH_RIVALS_ZSTD_H
#define CLERS_BENCH_RIVALS_ZSTD_H

#include <string>
#include <vector>

#include "bench/codec.h"

namespace clers::bench {

/// One zstd frame.
std::vector<std::uint8_t> zstd_compress(const void* data, std::size_t size, int level);
/// Precondition: `out` holds as many bytes as were compressed. Throws CodecFailure otherwise.
void zstd_decompress(const std::vector<std::uint8_t>& frame, void* out, std::size_t size);

/// zstd19: -19 on u32 indices, for the whole file with the floats after them.
std::vector<CodecEntry> zstd_codecs();
std::string zstd_version();

}  // namespace clers::bench

#endif

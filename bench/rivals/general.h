// zstd -19 and xz -9e: what one has without any mesh codec.
#ifndef CLERS_BENCH_RIVALS_GENERAL_H
#define CLERS_BENCH_RIVALS_GENERAL_H

#include <string>
#include <vector>

#include "bench/codec.h"

namespace clers::bench {

/// One zstd frame, of level 19.
std::vector<std::uint8_t> zstd19(const void* data, std::size_t size);
/// Precondition: `out` holds as many bytes as were compressed. Throws CodecFailure otherwise.
void zstd_decompress(const std::vector<std::uint8_t>& frame, void* out, std::size_t size);

/// zstd19, xz9e: of u32 indices, and of positions apart from them: floats, or 16-bit numbers on the
/// grid. In mode file file-zstd19, file-xz9e: of the file as it is; ply-zstd19, ply-xz9e: of its
/// meshes written as a binary PLY. What they give back is then a file, which nobody has read yet.
std::vector<CodecEntry> general_codecs();
std::string zstd_version();
std::string xz_version();

}  // namespace clers::bench

#endif

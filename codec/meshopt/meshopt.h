// Buffers that meshoptimizer compressed -> plain ones, by its library.
#ifndef CLERS_CODEC_MESHOPT_MESHOPT_H
#define CLERS_CODEC_MESHOPT_MESHOPT_H

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include <clers/error.h>
#include <clers/topology/export.h>

namespace clers {
namespace CLERS_VISIBLE meshopt {

/// The hook for gltf::Decoders: what a bufferView with EXT_meshopt_compression stands for. `count`
/// elements of `stride` bytes, `mode` and `filter` as the extension has them: "ATTRIBUTES",
/// "TRIANGLES" or "INDICES"; "NONE", "OCTAHEDRAL", "QUATERNION" or "EXPONENTIAL". What filters give
/// may be 1 off what other versions of the library give: they round otherwise.
///
/// Errors: malformed; unsupported, a mode or filter of no such name; out_of_memory. Memory: the
/// result, which is at most 64 times as large as the bytes.
Expected<std::vector<std::byte>> decode_for_gltf(std::span<const std::byte> bytes,
                                                 std::size_t count, std::size_t stride,
                                                 std::string_view mode, std::string_view filter);

}  // namespace meshopt
}  // namespace clers

#endif

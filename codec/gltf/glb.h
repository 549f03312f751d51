// The chunks of a .glb (glTF 2.0, 4.4).
#ifndef CLERS_CODEC_GLTF_GLB_H
#define CLERS_CODEC_GLTF_GLB_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <clers/error.h>

namespace clers::gltf {

struct Chunk {
  std::uint32_t type = 0;
  std::span<const std::byte> bytes;
};
inline constexpr std::uint32_t chunk_bin = 0x004e4942;

struct Glb {
  std::string_view json;
  std::vector<Chunk> others;  ///< that of binary data, if there is one, and unknown ones
};

bool is_glb(std::span<const std::byte> bytes);

/// Errors: malformed, unsupported. Precondition: is_glb().
Expected<Glb> split(std::span<const std::byte> bytes);

/// The file of these chunks, filled up to multiples of 4 bytes. Error: too_large.
Expected<std::vector<std::byte>> join(std::string_view json, std::span<const Chunk> others);

}  // namespace clers::gltf

#endif

// Bytes -> meshes.
#ifndef CLERS_CODEC_DECODE_H
#define CLERS_CODEC_DECODE_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "codec/error.h"
#include "codec/mesh.h"

namespace clers {

/// What a caller allows a file to cost. Exceeding one is ErrorCode::limit, found before anything is
/// allocated for it.
struct Limits {
  std::uint64_t meshes = 1u << 20;
  std::uint64_t vertices = 0xffffffffu;           ///< in one mesh
  std::uint64_t faces = 0x55555555u;              ///< in one mesh
  std::uint64_t memory = std::uint64_t(1) << 40;  ///< bytes of all meshes of the file, decoded
};

struct DecodeOptions {
  Limits limits;
  std::function<void(std::string_view stage, double done)> progress;  ///< as in EncodeOptions
};

/// Decodes a .clers file. Trusts nothing: every index of a returned mesh is below its vertex_count,
/// counts are checked against the bytes that remain and the limits before allocation, and what is
/// wrong with the bytes is a named error with the byte offset.
/// Errors: not_clers, unsupported_version, truncated, trailing_bytes, corrupt, invalid, limit,
/// out_of_memory.
/// Cost: linear in the faces. Thread safe: calls share nothing.
Expected<std::vector<Mesh>> decode(std::span<const std::byte> bytes,
                                   const DecodeOptions& options = {});

}  // namespace clers

#endif

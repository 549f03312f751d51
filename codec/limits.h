// What a caller allows a file to cost.
#ifndef CLERS_CODEC_LIMITS_H
#define CLERS_CODEC_LIMITS_H

#include <cstdint>
#include <optional>

namespace clers {

/// Exceeding one is ErrorCode::limit, found before anything is allocated for it; Error::limited
/// says which, Error::needed how much would do.
struct Limits {
  std::uint64_t meshes = 1u << 20;
  std::uint64_t vertices = 0xffffffffu;  ///< in one mesh
  std::uint64_t faces = 0x55555555u;     ///< in one mesh
  /// Bytes that a call may take at any time, results included, whatever the number of threads. Not
  /// counted are the file, memory of the caller, and some MB that depend on no file. An isolated
  /// vertex, which costs a file nothing, counts 4 bytes. None: 1 GiB or 4096 times the size of the
  /// file, whichever is more.
  std::optional<std::uint64_t> memory;
};

}  // namespace clers

#endif

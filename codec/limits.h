// What a caller allows a file to cost.
#ifndef CLERS_CODEC_LIMITS_H
#define CLERS_CODEC_LIMITS_H

#include <cstdint>
#include <optional>

#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// A file that exceeds one is refused with ErrorCode::limit before anything is allocated for it;
/// Error::limited says which limit, Error::needed what it must be at least.
struct Limits {
  std::uint64_t meshes = 1u << 20;
  std::uint64_t vertices = 0xffffffffu;  ///< in one mesh
  std::uint64_t faces = 0x55555555u;     ///< in one mesh
  /// Bytes that a call may hold at any time, its result and what a Decoder keeps included, whatever
  /// the number of threads. Not counted: the bytes of the file, memory of the caller, and some MB
  /// that depend on no file. A vertex that no face uses costs a file nothing, but counts 4 bytes.
  /// Not set: 1 GiB or 4096 times the size of the file, whichever is more.
  std::optional<std::uint64_t> memory;
};

}  // namespace clers

#endif

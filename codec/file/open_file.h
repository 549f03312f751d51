// A file whose headers were read, and what they say of it: what decoding and inspecting share.
#ifndef CLERS_CODEC_FILE_OPEN_FILE_H
#define CLERS_CODEC_FILE_OPEN_FILE_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/base/budget.h"
#include "codec/error.h"
#include "codec/file/mesh_reader.h"
#include "codec/info.h"
#include "codec/limits.h"

namespace clers::internal {

struct OpenFile {
  std::vector<MeshSections> meshes;
  SceneSections scene;
  std::uint32_t minor = 0;
  int level = 0;
  std::uint64_t size = 0;
  Budget budget;  ///< what a call may take besides
};

/// Everything that can be checked before anything is decoded. The bytes must outlive what it
/// returns.
Expected<OpenFile> open_file(std::span<const std::byte> bytes, const Limits& limits);

/// What info_of takes of the budget.
std::uint64_t info_memory(const OpenFile& file);
/// Errors: invalid, of metadata, if that is wanted.
Expected<FileInfo> info_of(const OpenFile& file, bool metadata);

}  // namespace clers::internal

#endif

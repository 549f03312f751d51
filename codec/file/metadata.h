// What a mesh's file said besides the mesh <-> bytes. Knows keys and values, and no meaning.
// codec/format.md, Metadata.
#ifndef CLERS_CODEC_FILE_METADATA_H
#define CLERS_CODEC_FILE_METADATA_H

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "codec/entropy/bytes.h"
#include "codec/entropy/zstd_frame.h"
#include "codec/error.h"
#include "codec/mesh.h"

namespace clers::internal {

/// What stands before the entries.
struct MetadataHeader {
  std::uint64_t entries = 0, size = 0;  ///< how many, and the bytes they take unpacked
  std::span<const std::byte> packed;
  std::uint64_t payload_size = 0;  ///< of the section
  std::uint64_t at = 0;            ///< offset of the packed bytes in the file

  /// What decoding allocates, at most.
  std::uint64_t memory() const { return entries * sizeof(MetadataEntry) + 2 * size; }
};

/// Checks that the entries can come from so many bytes.
Expected<MetadataHeader> read_metadata_header(std::span<const std::byte> payload, std::uint64_t at);

/// The caller has checked header.memory() against its limits.
Expected<std::vector<MetadataEntry>> decode_metadata(const MetadataHeader& header);

/// What keeps entries from being coded; empty if nothing does.
std::string metadata_fault(std::span<const MetadataEntry> entries);

/// One zstd frame of all entries. Precondition: no metadata_fault. Throws std::bad_alloc; zstd
/// failing is internal.
inline Expected<Bytes> encode_metadata(std::span<const MetadataEntry> entries) {
  Bytes plain;
  for (const MetadataEntry& e : entries) {
    put_u8(plain, static_cast<std::uint32_t>(e.key.size()));
    put_bytes(plain, std::as_bytes(std::span(e.key)));
    put_varint(plain, e.value.size());
    put_bytes(plain, std::as_bytes(std::span(e.value)));
  }
  // Comments are short and few; more effort than this buys little.
  const auto packed = pack_frame(plain, 9);
  if (!packed) return packed;
  Bytes payload;
  put_varint(payload, entries.size());
  put_varint(payload, plain.size());
  put_bytes(payload, *packed);
  return payload;
}

}  // namespace clers::internal

#endif

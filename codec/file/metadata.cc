// Checks and reads metadata; what writes it is in the header, so that who decodes links none of it.
#include "codec/file/metadata.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "codec/base/utf8.h"
#include "codec/entropy/zstd_frame.h"

namespace clers::internal {
namespace {

constexpr std::size_t longest_key = 255;
/// The length of a key, a byte of it, and the length of a value.
constexpr std::uint64_t least_entry = 3;

}  // namespace

std::string metadata_fault(std::span<const MetadataEntry> entries) {
  std::vector<std::string_view> keys;
  keys.reserve(entries.size());
  for (const MetadataEntry& e : entries) {
    if (e.key.empty() || e.key.size() > longest_key || !is_utf8(e.key))
      return "a key of metadata is not UTF-8 of 1 to 255 bytes";
    keys.push_back(e.key);
  }
  std::sort(keys.begin(), keys.end());
  if (std::adjacent_find(keys.begin(), keys.end()) != keys.end())
    return "two entries of metadata have one key";
  return {};
}

Expected<MetadataHeader> read_metadata_header(std::span<const std::byte> payload,
                                              std::uint64_t at) {
  ByteReader in(payload, at);
  MetadataHeader header;
  header.entries = in.varint();
  header.size = in.varint();
  if (!in.ok()) return Failure{in.error()};
  header.packed = payload.subspan(in.position());
  header.at = in.offset();
  header.payload_size = payload.size();
  if (header.entries > header.size / least_entry || header.entries == 0)
    return fail(ErrorCode::invalid, Place::byte, at,
                std::to_string(header.entries) + " entries of metadata in " +
                    std::to_string(header.size) + " bytes");
  if (auto ok = check_frame(header.packed, header.at, header.size, "the metadata"); !ok)
    return Failure{ok.error()};
  return header;
}

Expected<std::vector<MetadataEntry>> decode_metadata(const MetadataHeader& header) {
  const auto invalid = [&](std::string what) {
    return fail(ErrorCode::invalid, Place::byte, header.at, std::move(what));
  };
  const auto plain = unpack_frame(header.packed, header.at, header.size, "the metadata");
  if (!plain) return Failure{plain.error()};
  std::vector<MetadataEntry> entries;
  entries.reserve(static_cast<std::size_t>(header.entries));
  ByteReader in(*plain, 0);
  const auto text = [&](std::uint64_t size) {
    const auto bytes = in.take(size);
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  for (std::uint64_t i = 0; i < header.entries && in.ok(); ++i) {
    MetadataEntry entry;
    entry.key = text(in.u8());
    entry.value = text(in.varint());
    entries.push_back(std::move(entry));
  }
  if (!in.ok()) return invalid("metadata: " + in.error().what);
  if (in.left() > 0) return invalid("bytes after the last entry of metadata");
  if (std::string what = metadata_fault(entries); !what.empty()) return invalid(std::move(what));
  return entries;
}

}  // namespace clers::internal

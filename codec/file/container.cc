// Sections, each with a checksum of all that was written before it.
#include "codec/file/container.h"

#include <xxhash.h>

#include <array>
#include <string>

namespace clers::internal {
namespace {

constexpr std::array<char, 5> magic = {'C', 'L', 'E', 'R', 'S'};
constexpr std::size_t header_size = magic.size() + 2;

/// Every checksum is seeded with the one before, so that sections cannot be left out, repeated or
/// exchanged either.
std::uint32_t checksum(std::span<const std::byte> bytes, std::uint32_t seed) {
  return XXH32(bytes.data(), bytes.size(), seed);
}

}  // namespace

ContainerWriter::ContainerWriter(int level) {
  for (const char c : magic) put_u8(bytes_, static_cast<unsigned char>(c));
  put_u8(bytes_, format_major << 4 | format_minor);
  put_u8(bytes_, static_cast<std::uint32_t>(level));
  check_ = checksum(bytes_, 0);
}

void ContainerWriter::section(SectionKind kind, std::span<const std::byte> payload) {
  const std::size_t start = bytes_.size();
  put_u8(bytes_, static_cast<std::uint32_t>(kind));
  put_varint(bytes_, payload.size());
  put_bytes(bytes_, payload);
  check_ = checksum(std::span(bytes_).subspan(start), check_);
  put_u32(bytes_, check_);
}

Bytes ContainerWriter::finish(std::uint64_t meshes) {
  Bytes payload;
  put_varint(payload, meshes);
  section(SectionKind::end, payload);
  return std::move(bytes_);
}

Expected<Done> ContainerReader::open() {
  for (std::size_t i = 0; i < magic.size() && i < bytes_.size(); ++i)
    if (std::to_integer<char>(bytes_[i]) != magic[i])
      return fail(ErrorCode::not_clers, Place::byte, i,
                  "not a .clers file: it does not begin with CLERS");
  in_.take(magic.size());
  const std::uint32_t version = in_.u8();
  if (in_.ok() && version != (format_major << 4 | format_minor))
    return fail(ErrorCode::unsupported_version, Place::byte, magic.size(),
                "format " + std::to_string(version >> 4) + "." + std::to_string(version & 15) +
                    ", this program reads " + std::to_string(format_major) + "." +
                    std::to_string(format_minor));
  level_ = static_cast<int>(in_.u8());
  if (!in_.ok()) return Failure{in_.error()};
  if (level_ < 1 || level_ > 9)
    return fail(ErrorCode::invalid, Place::byte, header_size - 1,
                "made with level " + std::to_string(level_) + ", expected 1 to 9");
  minor_ = version & 15;
  check_ = checksum(bytes_.first(header_size), 0);
  return Done{};
}

ContainerReader::Tally ContainerReader::tally() const {
  Tally tally;
  for (ByteReader in = in_; in.left() > 0;) {
    const std::uint32_t kind = in.u8();
    const std::uint64_t size = in.varint();
    in.take(size);
    in.take(sizeof(std::uint32_t));
    if (!in.ok() || kind >= tally.sections.size()) break;
    ++tally.sections[kind];
    tally.bytes[kind] += size;
  }
  return tally;
}

Expected<Section> ContainerReader::next() {
  const std::size_t start = in_.position();
  const std::uint32_t kind = in_.u8();
  const std::uint64_t size = in_.varint();
  Section section;
  section.kind = static_cast<SectionKind>(kind);
  section.at = in_.offset();
  section.payload = in_.take(size);
  const std::size_t end = in_.position();
  const std::uint32_t stored = in_.u32();
  if (!in_.ok()) return Failure{in_.error()};
  check_ = checksum(bytes_.subspan(start, end - start), check_);
  if (check_ != stored)
    return fail(ErrorCode::corrupt, Place::byte, start,
                "the section here does not match its checksum");
  if (kind > last_section_kind)
    return fail(ErrorCode::invalid, Place::byte, start,
                "a section of unknown kind " + std::to_string(kind));
  if (section.kind == SectionKind::end) {
    ByteReader payload(section.payload, section.at);
    meshes_ = payload.varint();
    if (!payload.ok()) return Failure{payload.error()};
    if (payload.left() > 0)
      return fail(ErrorCode::invalid, Place::byte, payload.offset(),
                  "bytes after the number of meshes");
    if (in_.left() > 0)
      return fail(ErrorCode::trailing_bytes, Place::byte, in_.offset(),
                  std::to_string(in_.left()) + " bytes after the end of the file's content");
  }
  return section;
}

}  // namespace clers::internal

// The frame of a .clers file: a header, then sections, each with its kind, length and checksum.
// Knows no payload. codec/format.md describes the bytes.
#ifndef CLERS_CODEC_FILE_CONTAINER_H
#define CLERS_CODEC_FILE_CONTAINER_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/entropy/bytes.h"
#include "codec/error.h"

namespace clers::internal {

inline constexpr std::uint32_t format_major = 0, format_minor = 2;

/// Kinds of sections; the numbers are the file format's.
enum class SectionKind : std::uint8_t {
  end = 0,
  mesh = 1,
  attribute = 2,
  name = 3,
  order = 4,
  pieces = 5,
  seam = 6,
  metadata = 7,
  document = 8,
  array = 9,
  blob = 10,
};
inline constexpr std::uint32_t last_section_kind = static_cast<std::uint32_t>(SectionKind::blob);

/// Writes a file section by section.
class ContainerWriter {
 public:
  explicit ContainerWriter(int level);
  void section(SectionKind kind, std::span<const std::byte> payload);
  /// The section that says that nothing is missing.
  Bytes finish(std::uint64_t meshes);

 private:
  Bytes bytes_;
  std::uint32_t check_;  ///< of all that was written
};

struct Section {
  SectionKind kind = SectionKind::end;
  std::span<const std::byte> payload;
  std::uint64_t at = 0;  ///< offset of the payload in the file
};

/// Reads a file section by section.
class ContainerReader {
 public:
  explicit ContainerReader(std::span<const std::byte> bytes) : bytes_(bytes), in_(bytes, 0) {}

  /// Checks the header. Errors: not_clers, unsupported_version, truncated, invalid.
  Expected<Done> open();
  int level() const { return level_; }
  std::uint32_t minor() const { return minor_; }

  /// The next section, checked against its checksum; the end section once, at the end.
  /// Errors: truncated, corrupt, invalid (an unknown kind), trailing_bytes.
  Expected<Section> next();

  /// How many sections of a kind are still to come and how long their payloads are, as far as their
  /// lengths lead; nothing else of them is checked. Precondition: open().
  struct Tally {
    std::array<std::uint64_t, last_section_kind + 1> sections{}, bytes{};
    std::uint64_t count(SectionKind k) const { return sections[static_cast<std::size_t>(k)]; }
    std::uint64_t size(SectionKind k) const { return bytes[static_cast<std::size_t>(k)]; }
  };
  Tally tally() const;

  /// What the end section says. Precondition: next() gave it.
  std::uint64_t meshes() const { return meshes_; }

 private:
  std::span<const std::byte> bytes_;
  ByteReader in_;
  int level_ = 0;
  std::uint32_t minor_ = 0;
  std::uint32_t check_ = 0;
  std::uint64_t meshes_ = 0;
};

}  // namespace clers::internal

#endif

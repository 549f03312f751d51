// What a file holds besides meshes, by its headers: arrays, blobs, a document. Knows no mesh but by
// its number. codec/format.md, Arrays, Blobs, Document.
#ifndef CLERS_CODEC_FILE_SCENE_SECTIONS_H
#define CLERS_CODEC_FILE_SCENE_SECTIONS_H

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "codec/attributes/attribute_decoder.h"
#include "codec/base/budget.h"
#include "codec/error.h"
#include "codec/file/container.h"
#include "codec/file/metadata.h"
#include "codec/info.h"
#include "codec/limits.h"
#include "codec/scene.h"

namespace clers::internal {

struct ArraySection {
  AttributeHeader header;
  std::span<const std::byte> bytes;  ///< of the attribute that its values are
  std::uint64_t at = 0, count = 0;
  std::optional<std::uint64_t> vertices_of;
  std::uint64_t payload_size = 0;
};

/// Bytes as they are, or one zstd frame of them.
struct PackedBytes {
  std::uint64_t size = 0;
  bool packed = false;
  std::span<const std::byte> bytes;
  std::uint64_t at = 0;
  std::uint64_t payload_size = 0;
};

struct BlobSection : PackedBytes {
  std::string name;
};

struct SceneSections {
  std::vector<ArraySection> arrays;
  std::vector<BlobSection> blobs;
  std::optional<PackedBytes> document;
  std::optional<MetadataHeader> metadata;

  bool any_after_meshes() const { return !arrays.empty() || !blobs.empty(); }
};

/// Each reads and checks a section, as far as can be seen without decoding it. Errors: truncated,
/// invalid.
Expected<ArraySection> read_array(const Section& section);
Expected<BlobSection> read_blob(const Section& section);
Expected<PackedBytes> read_document(const Section& section);

/// Whether arrays name meshes that there are, of which mesh i has so many vertices: all is known
/// once the file is read. Errors: invalid.
Expected<Done> check_vertices_of(const SceneSections& scene, std::uint64_t meshes);

/// What such sections become besides the results of decoding them, names included.
std::uint64_t tables_memory(const ContainerReader::Tally& tally);

/// What describe() takes.
std::uint64_t info_memory(const SceneSections& scene);
/// Errors: invalid, of metadata, if that is wanted, and of numbers.
Expected<SceneInfo> describe(const SceneSections& scene, bool metadata);

/// Takes what all of it needs once decoded, then decodes it. The meshes of `scene` are left alone.
/// Errors: limit, before anything is decoded; invalid. Throws std::bad_alloc only.
Expected<Done> decode(const SceneSections& sections, Budget& budget, Scene& scene);

/// Refuses vertices that a mesh does not have. Precondition: check_vertices_of, and the meshes are
/// there. Errors: invalid.
Expected<Done> check_vertices(const SceneSections& sections, const Scene& scene);

}  // namespace clers::internal

#endif

// Section by section; what they say of each other comes last.
#include "codec/file/scene_sections.h"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>

#include "codec/base/utf8.h"
#include "codec/entropy/zstd_frame.h"

namespace clers::internal {
namespace {

constexpr std::uint64_t most_values = 0xffffffffu;

Failure<Error> invalid(std::uint64_t at, std::string what) {
  return fail(ErrorCode::invalid, Place::byte, at, std::move(what));
}

/// The rest of a payload, which holds `size` bytes.
Expected<Done> read_packed(ByteReader& in, const Section& section, const char* what,
                           PackedBytes& out) {
  out.size = in.varint();
  const std::uint32_t packed = in.u8();
  if (!in.ok()) return Failure{in.error()};
  if (packed > 1) return invalid(section.at, "bytes that are packed in an unknown way");
  out.packed = packed == 1;
  out.at = in.offset();
  out.bytes = in.take(in.left());
  out.payload_size = section.payload.size();
  if (out.packed) return check_frame(out.bytes, out.at, out.size, what);
  if (out.bytes.size() != out.size)
    return invalid(out.at, std::to_string(out.bytes.size()) + " bytes of " + what + ", expected " +
                               std::to_string(out.size));
  return Done{};
}

Expected<Bytes> unpack(const PackedBytes& from, const char* what) {
  if (from.packed) return unpack_frame(from.bytes, from.at, from.size, what);
  return Bytes(from.bytes.begin(), from.bytes.end());
}

constexpr char blob_words[] = "a blob", document_words[] = "the document";

std::uint64_t memory_of(const ArraySection& a) {
  return a.count * a.header.attribute.stride();
}

std::uint64_t decoding_memory(const ArraySection& a) {
  const AttributeMemory memory = decoding_memory(a.bytes, a.header, a.count, {});
  return memory.begun + std::max(memory.beginning, memory.finishing);
}

Expected<Array> decode_array(const ArraySection& from) {
  auto begun = begin_attribute(from.bytes, from.at, from.header, from.count);
  if (!begun) return Failure{begun.error()};
  auto attribute =
      finish_attribute(from.bytes, from.at, from.header, from.count, std::move(*begun), {});
  if (!attribute) return Failure{attribute.error()};
  Array array{std::move(attribute->name), attribute->scalar, attribute->components,
              std::move(attribute->data)};
  if (from.vertices_of) array.vertices_of = static_cast<std::size_t>(*from.vertices_of);
  return array;
}

}  // namespace

Expected<ArraySection> read_array(const Section& section) {
  ByteReader in(section.payload, section.at);
  ArraySection array;
  array.count = in.varint();
  const std::uint64_t owner = in.varint();
  if (!in.ok()) return Failure{in.error()};
  if (owner > 0) array.vertices_of = owner - 1;
  array.bytes = section.payload.subspan(in.position());
  array.at = in.offset();
  array.payload_size = section.payload.size();
  auto header = read_attribute_header(array.bytes, array.at);
  if (!header) return Failure{header.error()};
  array.header = std::move(*header);
  const Attribute& a = array.header.attribute;
  if (a.domain != Domain::face || array.header.structure.any ||
      array.header.measure != ErrorMeasure::difference || along(array.header) != Along::nothing ||
      needs_position(array.header) || needs_joints(array.header))
    return invalid(section.at, "an array that is no plain list of values");
  if (array.count > most_values)
    return invalid(section.at, std::to_string(array.count) + " values are more than an array has");
  if (array.vertices_of && (a.scalar != Scalar::uint32 || a.components != 1))
    return invalid(section.at, "vertices that are not single numbers of 32 bits");
  if (auto ok = check_values(array.bytes, array.at, array.header, array.count); !ok)
    return Failure{ok.error()};
  return array;
}

Expected<BlobSection> read_blob(const Section& section) {
  ByteReader in(section.payload, section.at);
  BlobSection blob;
  const auto name = in.take(in.u8());
  blob.name.assign(reinterpret_cast<const char*>(name.data()), name.size());
  if (auto ok = read_packed(in, section, blob_words, blob); !ok) return Failure{ok.error()};
  if (const std::size_t i = first_not_utf8(blob.name); i < blob.name.size())
    return invalid(section.at + 1 + i, "the name is not UTF-8 from here");
  return blob;
}

Expected<PackedBytes> read_document(const Section& section) {
  ByteReader in(section.payload, section.at);
  PackedBytes document;
  if (auto ok = read_packed(in, section, document_words, document); !ok) return Failure{ok.error()};
  if (document.size == 0) return invalid(section.at, "a document without a byte");
  return document;
}

Expected<Done> check_vertices_of(const SceneSections& scene, std::uint64_t meshes) {
  for (const ArraySection& a : scene.arrays)
    if (a.vertices_of && *a.vertices_of >= meshes)
      return invalid(a.at, "vertices of mesh " + std::to_string(*a.vertices_of) + ", there are " +
                               std::to_string(meshes));
  return Done{};
}

std::uint64_t tables_memory(const ContainerReader::Tally& tally) {
  const auto names = [&](SectionKind kind) {
    return std::min(tally.size(kind), 256 * tally.count(kind));
  };
  return 3 * (tally.count(SectionKind::array) * sizeof(ArraySection) +
              tally.count(SectionKind::blob) * sizeof(BlobSection)) +
         names(SectionKind::array) + names(SectionKind::blob);
}

std::uint64_t info_memory(const SceneSections& scene) {
  std::uint64_t memory = scene.blobs.size() * sizeof(BlobInfo), most = 0;
  for (const BlobSection& b : scene.blobs) memory += b.name.size();
  for (const ArraySection& a : scene.arrays) {
    // A line of text for each component, at most.
    memory += sizeof(ArrayInfo) + a.header.attribute.name.size() +
              64 * std::uint64_t(a.header.attribute.components);
    most = std::max(most, describing_memory(a.bytes, a.header, a.count));
  }
  return memory + most;
}

Expected<SceneInfo> describe(const SceneSections& scene, bool metadata) {
  SceneInfo info;
  for (const ArraySection& a : scene.arrays) {
    const AttributeInfo values = info_of(a.header);
    auto numbers = describe_numbers(a.bytes, a.at, a.header, a.count);
    if (!numbers) return Failure{numbers.error()};
    info.arrays.push_back({values.name, values.scalar, values.components, a.count, a.payload_size,
                           std::move(*numbers), values.coder, a.vertices_of, values.error});
    info.array_bytes += a.payload_size;
  }
  for (const BlobSection& b : scene.blobs) {
    info.blobs.push_back({b.name, b.size, b.payload_size});
    info.blob_bytes += b.payload_size;
  }
  if (scene.document) {
    info.document_size = scene.document->size;
    info.document_bytes = scene.document->payload_size;
  }
  if (scene.metadata) info.metadata_bytes = scene.metadata->payload_size;
  if (scene.metadata && metadata) {
    auto entries = decode_metadata(*scene.metadata);
    if (!entries) return Failure{entries.error()};
    info.metadata = std::move(*entries);
  }
  return info;
}

Expected<Done> decode(const SceneSections& sections, Budget& budget, Scene& scene) {
  std::uint64_t work = 0;
  std::uint64_t results =
      sections.arrays.size() * sizeof(Array) + sections.blobs.size() * sizeof(Blob);
  const auto add = [&](std::uint64_t bytes) {  // sums of 64 bits that could overflow do not
    results = bytes > ~results ? ~std::uint64_t(0) : results + bytes;
  };
  for (const ArraySection& a : sections.arrays) {
    add(memory_of(a) + a.header.attribute.name.size());
    work = std::max(work, decoding_memory(a));
  }
  for (const BlobSection& b : sections.blobs) add(b.size + b.name.size());
  if (sections.document) {
    add(sections.document->size);
    work = std::max(work, sections.document->size);
  }
  if (auto ok = budget.take(results); !ok) return ok;
  if (auto ok = budget.check(work); !ok) return ok;
  scene.arrays.reserve(sections.arrays.size());
  scene.blobs.reserve(sections.blobs.size());
  for (const ArraySection& a : sections.arrays) {
    auto array = decode_array(a);
    if (!array) return Failure{array.error()};
    scene.arrays.push_back(std::move(*array));
  }
  for (const BlobSection& b : sections.blobs) {
    auto bytes = unpack(b, blob_words);
    if (!bytes) return Failure{bytes.error()};
    scene.blobs.push_back({b.name, std::move(*bytes)});
  }
  if (sections.document) {
    const auto text = unpack(*sections.document, document_words);
    if (!text) return Failure{text.error()};
    scene.document.assign(reinterpret_cast<const char*>(text->data()), text->size());
  }
  if (sections.metadata) {
    auto entries = decode_metadata(*sections.metadata);
    if (!entries) return Failure{entries.error()};
    scene.metadata = std::move(*entries);
  }
  return Done{};
}

Expected<Done> check_vertices(const SceneSections& sections, const Scene& scene) {
  for (std::size_t i = 0; i < sections.arrays.size(); ++i) {
    if (!sections.arrays[i].vertices_of) continue;
    const std::vector<std::byte>& data = scene.arrays[i].data;
    const std::uint32_t vertices =
        scene.meshes[static_cast<std::size_t>(*sections.arrays[i].vertices_of)].vertex_count;
    for (std::size_t at = 0; at < data.size(); at += sizeof(std::uint32_t)) {
      std::uint32_t v = 0;
      std::memcpy(&v, data.data() + at, sizeof v);
      if (v >= vertices)
        return invalid(sections.arrays[i].at, "vertex " + std::to_string(v) + " of " +
                                                  std::to_string(vertices) + " in an array");
    }
  }
  return Done{};
}

}  // namespace clers::internal

// Headers, and sums over them.
#include "codec/file/open_file.h"

#include <algorithm>
#include <utility>

#include "codec/base/in_mesh.h"
#include "codec/file/attribute_sums.h"
#include "codec/file/container.h"
#include "codec/file/metadata.h"

namespace clers::internal {
namespace {

Expected<MeshInfo> info_of(const MeshSections& s, bool with_metadata) {
  MeshInfo mesh;
  mesh.name = s.name;
  mesh.vertices = s.vertices;
  mesh.faces = s.faces;
  mesh.corners = s.corners;
  mesh.triangles_only = !s.may_have_sizes();
  mesh.pieces = s.pieces.size();
  mesh.order_bytes = mesh.connectivity_bytes = s.order.bytes.size();
  AttributeSums sums(mesh);
  mesh.attributes.reserve(s.pieces[0].attributes.size());
  for (const PieceSections& piece : s.pieces) {
    mesh.copied_vertices += piece.copies.copies;
    mesh.welded_vertices += piece.vertices - piece.places;
    mesh.repeated_faces += piece.repeats.faces;
    mesh.degenerate_faces += piece.folded.faces + piece.degenerate.faces;
    mesh.connectivity_bytes += piece.payload_size + piece.seam_size;
    mesh.polygon_bytes += piece.polygons.stream.bytes.size();
    mesh.stitching_bytes += piece.reversed.stream.bytes.size() + piece.copies.stream.bytes.size() +
                            piece.repeats.stream.bytes.size() + piece.folded.stream.bytes.size() +
                            piece.degenerate.stream.bytes.size() +
                            piece.points.stream.bytes.size() + piece.seam_size;
    for (std::size_t i = 0; i < piece.attributes.size(); ++i) {
      const PieceSections::AttributeSection& a = piece.attributes[i];
      AttributeInfo what = info_of(a.header);
      what.count = a.header.result_values(a.count);
      what.bytes = a.bytes.size();
      if (&piece == s.pieces.data()) {
        auto numbers = describe_numbers(a.bytes, a.at, a.header, a.values());
        if (!numbers) return Failure{numbers.error()};
        what.numbers = std::move(*numbers);
      }
      const std::uint64_t own =
          what.count - (what.domain == Domain::vertex ? piece.seam.shared : 0);
      sums.add(i, std::move(what), own);
    }
  }
  if (s.metadata) mesh.metadata_bytes = s.metadata->payload_size;
  if (s.metadata && with_metadata) {
    auto metadata = decode_metadata(*s.metadata);
    if (!metadata) return Failure{metadata.error()};
    mesh.metadata = std::move(*metadata);
  }
  return mesh;
}

}  // namespace

Expected<OpenFile> open_file(std::span<const std::byte> bytes, const Limits& limits) {
  OpenFile result{{}, {}, 0, 0, bytes.size(), Budget(limits, bytes.size())};
  ContainerReader file(bytes);
  auto sections = read_sections(file, limits, result.budget);
  if (!sections) return Failure{sections.error()};
  result.meshes = std::move(sections->meshes);
  result.scene = std::move(sections->scene);
  result.minor = file.minor();
  result.level = file.level();
  return result;
}

std::uint64_t info_memory(const OpenFile& file) {
  std::uint64_t memory = 0, most = 0;
  for (const MeshSections& mesh : file.meshes) {
    memory += sizeof(MeshInfo);
    for (const PieceSections::AttributeSection& a : mesh.pieces[0].attributes) {
      // A line of text for each component, at most.
      memory += sizeof(AttributeInfo) + a.header.attribute.name.size() +
                64 * std::uint64_t(a.header.attribute.components);
      most = std::max(most, describing_memory(a.bytes, a.header, a.values()));
    }
  }
  return memory + most + info_memory(file.scene);
}

Expected<FileInfo> info_of(const OpenFile& file, bool metadata) {
  FileInfo info;
  info.format_major = format_major;
  info.format_minor = file.minor;
  info.level = file.level;
  info.total_bytes = info.overhead_bytes = file.size;
  info.meshes.reserve(file.meshes.size());
  for (std::size_t i = 0; i < file.meshes.size(); ++i) {
    auto mesh = info_of(file.meshes[i], metadata);
    if (!mesh) return in_mesh(mesh.error(), i, file.meshes.size());
    info.overhead_bytes -= mesh->connectivity_bytes + mesh->position_bytes + mesh->attribute_bytes +
                           mesh->metadata_bytes;
    info.meshes.push_back(std::move(*mesh));
  }
  auto scene = describe(file.scene, metadata);
  if (!scene) return Failure{scene.error()};
  info.scene = std::move(*scene);
  info.overhead_bytes -= info.scene.bytes();
  return info;
}

}  // namespace clers::internal

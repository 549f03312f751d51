#include "codec/inspect.h"

#include <new>

#include "codec/mesh_reader.h"

namespace clers {

Expected<FileInfo> inspect(std::span<const std::byte> bytes) try {
  ContainerReader file(bytes);
  auto sections = read_meshes(file, Limits{});
  if (!sections) return Failure{sections.error()};
  FileInfo info;
  info.format_major = format_major;
  info.format_minor = file.minor();
  info.level = file.level();
  info.total_bytes = info.overhead_bytes = bytes.size();
  for (const MeshSections& s : *sections) {
    std::vector<std::uint32_t> corners(3 * std::size_t(s.connectivity.faces));
    auto counts =
        decode_connectivity(s.connectivity_bytes, s.connectivity_at, s.connectivity, corners);
    if (!counts) return Failure{counts.error()};
    MeshInfo mesh;
    mesh.name = s.name;
    mesh.shape.vertices = s.vertices;
    mesh.shape.faces = mesh.shape.triangles = s.connectivity.faces;
    mesh.shape.components = counts->components;
    mesh.shape.boundary_curves = counts->boundary_curves;
    mesh.shape.genus = counts->handles;
    mesh.shape.isolated_vertices = s.isolated;
    mesh.clers = in_word_order(counts->letters);
    mesh.connectivity_bytes = s.payload_size;
    bool position_seen = false;
    for (const MeshSections::AttributeSection& a : s.attributes) {
      const Attribute& what = a.header.attribute;
      mesh.attributes.push_back(
          {what.name, what.domain, what.scalar, what.components, a.count, a.bytes.size()});
      const bool position =
          !position_seen && what.domain == Domain::vertex && what.name == position_name;
      position_seen |= position;
      (position ? mesh.position_bytes : mesh.attribute_bytes) += a.bytes.size();
    }
    info.overhead_bytes -= mesh.connectivity_bytes + mesh.position_bytes + mesh.attribute_bytes;
    info.meshes.push_back(std::move(mesh));
  }
  return info;
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::out_of_memory, "not enough memory to inspect");
}

}  // namespace clers

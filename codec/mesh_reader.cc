#include "codec/mesh_reader.h"

#include <algorithm>
#include <cstdint>

namespace clers {
namespace {

Failure<Error> over(std::uint64_t at, const char* what, std::uint64_t value, std::uint64_t limit) {
  return fail(ErrorCode::limit, Place::byte, at,
              std::to_string(value) + " " + what + ", the limit is " + std::to_string(limit));
}

Expected<MeshSections> read_mesh(const Section& section, const Limits& limits) {
  MeshSections mesh;
  ByteReader in(section.payload, section.at);
  mesh.isolated = in.varint();
  const std::uint64_t turned_at = in.offset();
  const std::uint64_t runs = in.varint();
  std::uint64_t end = 0;
  for (std::uint64_t i = 0; i < runs && in.ok(); ++i) {
    const std::uint64_t first = end + in.varint(), count = in.varint();
    if (!in.ok()) break;
    if (first < end || first > max_faces || count == 0 || count > max_faces - first ||
        (i > 0 && first == end))
      return fail(ErrorCode::invalid, Place::byte, turned_at,
                  "a run of turned faces is out of order");
    end = first + count;
    mesh.turned.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)});
  }
  if (!in.ok()) return Failure{in.error()};
  mesh.payload_size = section.payload.size();
  mesh.connectivity_bytes = section.payload.subspan(in.position());
  mesh.connectivity_at = in.offset();
  auto header = read_connectivity_header(mesh.connectivity_bytes, mesh.connectivity_at);
  if (!header) return Failure{header.error()};
  mesh.connectivity = *header;
  if (end > header->faces)
    return fail(
        ErrorCode::invalid, Place::byte, turned_at,
        "turned faces up to " + std::to_string(end) + " of " + std::to_string(header->faces));
  if (mesh.isolated > 0xffffffffu - std::uint64_t(header->vertices))
    return fail(
        ErrorCode::invalid, Place::byte, section.at,
        std::to_string(mesh.isolated) + " isolated vertices are more than there are numbers");
  mesh.vertices = mesh.isolated + header->vertices;
  if (mesh.vertices > limits.vertices)
    return over(section.at, "vertices", mesh.vertices, limits.vertices);
  if (header->faces > limits.faces) return over(section.at, "faces", header->faces, limits.faces);
  return mesh;
}

Expected<MeshSections::AttributeSection> read_attribute(const Section& section,
                                                        const MeshSections& mesh) {
  auto header = read_attribute_header(section.payload, section.at);
  if (!header) return Failure{header.error()};
  MeshSections::AttributeSection result{*header, section.payload, section.at, 0};
  switch (header->attribute.domain) {
    case Domain::vertex: result.count = mesh.vertices; break;
    case Domain::corner: result.count = 3 * std::uint64_t(mesh.connectivity.faces); break;
    case Domain::face: result.count = mesh.connectivity.faces; break;
  }
  return result;
}

}  // namespace

Expected<std::vector<MeshSections>> read_meshes(ContainerReader& file, const Limits& limits) {
  if (auto ok = file.open(); !ok) return Failure{ok.error()};
  std::vector<MeshSections> meshes;
  // No more than can be addressed, so that sizes below fit in std::size_t.
  std::uint64_t left = std::min<std::uint64_t>(limits.memory, PTRDIFF_MAX);
  const auto take = [&](std::uint64_t bytes) {
    if (bytes > left) return false;
    left -= bytes;
    return true;
  };
  for (;;) {
    auto section = file.next();
    if (!section) return Failure{section.error()};
    if (section->kind == SectionKind::end) break;
    if (section->kind != SectionKind::mesh && meshes.empty())
      return fail(ErrorCode::invalid, Place::byte, section->at, "expected a mesh first");
    switch (section->kind) {
      case SectionKind::mesh: {
        if (meshes.size() >= limits.meshes)
          return over(section->at, "meshes or more", meshes.size() + 1, limits.meshes);
        auto mesh = read_mesh(*section, limits);
        if (!mesh) return Failure{mesh.error()};
        if (!take(12 * std::uint64_t(mesh->connectivity.faces)))
          return over(section->at, "bytes for faces and more",
                      12 * std::uint64_t(mesh->connectivity.faces), limits.memory);
        meshes.push_back(std::move(*mesh));
        break;
      }
      case SectionKind::attribute: {
        auto attribute = read_attribute(*section, meshes.back());
        if (!attribute) return Failure{attribute.error()};
        const std::uint64_t size = attribute->count * attribute->header.attribute.stride();
        if (!take(size)) return over(section->at, "bytes for values and more", size, limits.memory);
        meshes.back().attributes.push_back(std::move(*attribute));
        break;
      }
      case SectionKind::name:
        meshes.back().name.assign(reinterpret_cast<const char*>(section->payload.data()),
                                  section->payload.size());
        break;
      case SectionKind::end: break;
    }
  }
  if (file.meshes() != meshes.size())
    return fail(ErrorCode::invalid, std::to_string(meshes.size()) + " meshes, but the file says " +
                                        std::to_string(file.meshes()));
  return meshes;
}

}  // namespace clers

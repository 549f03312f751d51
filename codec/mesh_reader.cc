#include "codec/mesh_reader.h"

#include <algorithm>
#include <cstdint>

namespace clers {
namespace {

Failure<Error> over(std::uint64_t at, const char* what, std::uint64_t value, std::uint64_t limit) {
  return fail(ErrorCode::limit, Place::byte, at,
              std::to_string(value) + " " + what + ", the limit is " + std::to_string(limit));
}

MeshSections::Stream read_stream(ByteReader& in) {
  const std::uint64_t size = in.varint();
  const std::uint64_t at = in.offset();
  return {in.take(size), at};
}

/// Sizes of a mesh of plain faces.
Expected<Done> read_plain(const Section& section, ByteReader& in, MeshSections& mesh) {
  mesh.vertices = in.varint();
  mesh.faces = in.varint();
  mesh.corners = in.varint();
  mesh.plain = {section.payload.subspan(in.position()), in.offset()};
  if (!in.ok()) return Failure{in.error()};
  const std::uint64_t most =
      std::min(max_decisions_per_byte * mesh.plain.bytes.size(), max_corners);
  if (mesh.vertices > 0xffffffffu || mesh.faces > most || mesh.corners > most)
    return fail(ErrorCode::invalid, Place::byte, section.at,
                std::to_string(mesh.faces) + " faces of " + std::to_string(mesh.corners) +
                    " corners on " + std::to_string(mesh.vertices) +
                    " vertices cannot be coded in " + std::to_string(mesh.plain.bytes.size()) +
                    " bytes");
  return Done{};
}

/// Sizes of a mesh that is a surface, as far as it is one.
Expected<Done> read_surface(const Section& section, ByteReader& in, MeshSections& mesh) {
  const auto invalid = [&](std::string what) {
    return fail(ErrorCode::invalid, Place::byte, section.at, std::move(what));
  };
  if (mesh.features & ~feature::on_surface)
    return invalid("unknown features " + std::to_string(mesh.features));
  const std::uint64_t others = in.varint();
  if (mesh.features & feature::turned) {
    mesh.turned_runs = in.varint();
    mesh.turned = read_stream(in);
  }
  std::uint64_t polygons = 0;
  if (mesh.features & feature::polygons) {
    polygons = in.varint();
    mesh.polygons = read_stream(in);
  }
  if (mesh.features & feature::copies) {
    mesh.copies = in.varint();
    mesh.stitches = read_stream(in);
  }
  if (mesh.features & feature::loose) {
    mesh.loose_faces = in.varint();
    mesh.loose_corners = in.varint();
    mesh.loose = read_stream(in);
  }
  if (!in.ok()) return Failure{in.error()};
  mesh.connectivity_bytes = section.payload.subspan(in.position());
  mesh.connectivity_at = in.offset();
  auto header = read_connectivity_header(mesh.connectivity_bytes, mesh.connectivity_at);
  if (!header) return Failure{header.error()};
  mesh.connectivity = *header;

  mesh.surface_faces = header->faces;
  if (mesh.features & feature::polygons) {
    if (polygons == 0 || polygons >= header->faces)
      return invalid(std::to_string(polygons) + " polygons cannot be made of " +
                     std::to_string(header->faces) + " triangles");
    mesh.surface_faces = polygons;
  }
  if (mesh.features & feature::turned &&
      (mesh.turned_runs == 0 || mesh.turned_runs > mesh.surface_faces))
    return invalid(std::to_string(mesh.turned_runs) + " runs of turned faces among " +
                   std::to_string(mesh.surface_faces));
  if (mesh.features & feature::copies && (mesh.copies == 0 || mesh.copies >= header->vertices))
    return invalid(std::to_string(mesh.copies) + " copies among " +
                   std::to_string(header->vertices) + " vertices");
  if (mesh.features & feature::loose) {
    const std::uint64_t most = max_decisions_per_byte * mesh.loose.bytes.size();
    if (mesh.loose_faces == 0 || mesh.loose_faces > most || mesh.loose_corners > most)
      return invalid(std::to_string(mesh.loose_faces) + " loose faces of " +
                     std::to_string(mesh.loose_corners) + " corners cannot be coded in " +
                     std::to_string(mesh.loose.bytes.size()) + " bytes");
  }
  mesh.surface_vertices = header->vertices - mesh.copies;
  if (others > 0xffffffffu - mesh.surface_vertices)
    return invalid(std::to_string(others) + " further vertices are more than there are numbers");
  mesh.vertices = mesh.surface_vertices + others;
  mesh.faces = mesh.surface_faces + mesh.loose_faces;
  // A polygon of n corners is n - 2 triangles.
  mesh.corners = header->faces + 2 * mesh.surface_faces + mesh.loose_corners;
  if (mesh.corners > max_corners)
    return invalid(std::to_string(mesh.corners) + " corners are more than there are numbers");
  return Done{};
}

Expected<MeshSections> read_mesh(const Section& section, const Limits& limits) {
  MeshSections mesh;
  mesh.payload_size = section.payload.size();
  ByteReader in(section.payload, section.at);
  mesh.features = in.u8();
  const auto ok = mesh.features == feature::plain ? read_plain(section, in, mesh)
                                                  : read_surface(section, in, mesh);
  if (!ok) return Failure{ok.error()};
  if (mesh.vertices > limits.vertices)
    return over(section.at, "vertices", mesh.vertices, limits.vertices);
  if (mesh.faces > limits.faces) return over(section.at, "faces", mesh.faces, limits.faces);
  return mesh;
}

Expected<MeshSections::AttributeSection> read_attribute(const Section& section,
                                                        const MeshSections& mesh) {
  auto header = read_attribute_header(section.payload, section.at);
  if (!header) return Failure{header.error()};
  MeshSections::AttributeSection result{*header, section.payload, section.at, 0};
  switch (header->attribute.domain) {
    case Domain::vertex: result.count = mesh.vertices; break;
    case Domain::corner: result.count = mesh.corners; break;
    case Domain::face: result.count = mesh.faces; break;
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
        const bool sizes = mesh->features & (feature::polygons | feature::loose | feature::plain);
        const std::uint64_t size = 4 * (mesh->corners + (sizes ? mesh->faces : 0));
        if (!take(size)) return over(section->at, "bytes for faces and more", size, limits.memory);
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
      case SectionKind::order: {
        MeshSections& mesh = meshes.back();
        if (!mesh.order.bytes.empty() || mesh.features == feature::plain)
          return fail(ErrorCode::invalid, Place::byte, section->at, "an order where none can be");
        mesh.order = {section->payload, section->at};
        // A face takes a decision at least.
        if (mesh.faces > max_decisions_per_byte * section->payload.size())
          return fail(ErrorCode::invalid, Place::byte, section->at,
                      "the order of " + std::to_string(mesh.faces) + " faces cannot be coded in " +
                          std::to_string(section->payload.size()) + " bytes");
        break;
      }
      case SectionKind::end: break;
    }
  }
  if (file.meshes() != meshes.size())
    return fail(ErrorCode::invalid, std::to_string(meshes.size()) + " meshes, but the file says " +
                                        std::to_string(file.meshes()));
  return meshes;
}

}  // namespace clers

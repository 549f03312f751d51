#include "codec/inspect.h"

#include <new>

#include "codec/mesh_decoder.h"

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
    auto decoded = decode_faces(s);
    if (!decoded) return Failure{decoded.error()};
    turn_back(decoded->mesh, decoded->turned);
    if (auto ok = restore_order(s, decoded->mesh); !ok) return Failure{ok.error()};
    MeshInfo mesh;
    mesh.name = s.name;
    auto shape = measure(decoded->mesh);
    if (!shape) return Failure{shape.error()};
    mesh.shape = *shape;
    for (const TurnedRun& run : decoded->turned) mesh.cuts.turned_faces += run.count;
    mesh.cuts.copied_vertices = s.copies;
    mesh.cuts.loose_faces = s.loose_faces;
    mesh.clers = in_word_order(decoded->counts.letters);
    mesh.polygon_bytes = s.polygons.bytes.size();
    mesh.stitching_bytes = s.turned.bytes.size() + s.stitches.bytes.size() + s.loose.bytes.size();
    mesh.order_bytes = s.order.bytes.size();
    mesh.connectivity_bytes = s.payload_size + mesh.order_bytes;
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

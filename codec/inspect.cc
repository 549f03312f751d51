#include "codec/inspect.h"

#include <algorithm>
#include <utility>

#include "codec/base/budget.h"
#include "codec/base/guarded.h"
#include "codec/file/mesh_decoder.h"
#include "codec/soup/measure.h"

namespace clers {
namespace {

using namespace internal;

/// What the attributes of a piece cost; those of all pieces are the same ones.
void add_attributes(const PieceSections& piece, MeshInfo& mesh) {
  const bool first = mesh.attributes.empty();
  bool position_seen = false;
  if (first) mesh.attributes.reserve(piece.attributes.size());
  for (std::size_t i = 0; i < piece.attributes.size(); ++i) {
    const PieceSections::AttributeSection& a = piece.attributes[i];
    const Attribute& what = a.header.attribute;
    if (first)
      mesh.attributes.push_back({what.name, what.domain, what.scalar, what.components, 0, 0});
    mesh.attributes[i].count += a.count - (what.domain == Domain::vertex ? piece.seam.shared : 0);
    mesh.attributes[i].bytes += a.bytes.size();
    const bool position =
        !position_seen && what.domain == Domain::vertex && what.name == position_name;
    position_seen |= position;
    (position ? mesh.position_bytes : mesh.attribute_bytes) += a.bytes.size();
  }
}

/// What stays of a mesh, with what add_attributes makes.
std::uint64_t info_memory(const MeshSections& mesh) {
  std::uint64_t memory = sizeof(MeshInfo);
  for (const PieceSections::AttributeSection& a : mesh.pieces[0].attributes)
    memory += sizeof(AttributeInfo) + a.header.attribute.name.size();
  return memory;
}

/// What comes and goes while a mesh is looked at: its faces, and more.
std::uint64_t looking_memory(const MeshSections& mesh) {
  const bool whole = mesh.pieces.size() == 1;
  const std::uint64_t result =
      whole ? memory_of(mesh.pieces[0], Values::skip).result : room_memory(mesh, Values::skip);
  std::uint64_t most =
      std::max(finishing_memory(mesh, Values::skip),
               measuring_memory(mesh.corners, mesh.faces, mesh.vertices, mesh.may_have_sizes()));
  for (const PieceSections& piece : mesh.pieces) {
    const PieceMemory memory = memory_of(piece, Values::skip);
    most = std::max(
        most, whole ? memory.peak() - memory.result : memory.peak() + numbering_memory(piece));
  }
  return result + most;
}

Expected<MeshInfo> look_at(const MeshSections& s) {
  MeshInfo mesh;
  mesh.name = s.name;
  mesh.pieces = s.pieces.size();
  Mesh faces;
  if (s.pieces.size() > 1) faces = make_room(s, Values::skip);
  mesh.order_bytes = mesh.connectivity_bytes = s.order.bytes.size();
  for (const PieceSections& piece : s.pieces) {
    auto decoded = decode_piece(piece, Values::skip);
    if (!decoded) return Failure{decoded.error()};
    if (s.pieces.size() == 1)
      faces = std::move(decoded->mesh);
    else if (auto ok = put_piece(piece, decoded->mesh, faces); !ok)
      return Failure{ok.error()};
    mesh.cuts.turned_faces += decoded->reversed_faces;
    mesh.cuts.copied_vertices += piece.copies.copies;
    mesh.cuts.repeated_faces += piece.repeats.faces;
    mesh.cuts.loose_faces += piece.folded.faces + piece.degenerate.faces;
    const auto symbols = in_word_order(decoded->counts.symbols);
    for (std::size_t i = 0; i < symbols.size(); ++i) mesh.clers[i] += symbols[i];
    mesh.connectivity_bytes += piece.payload_size + piece.seam_size;
    mesh.polygon_bytes += piece.polygons.stream.bytes.size();
    mesh.stitching_bytes += piece.reversed.stream.bytes.size() + piece.copies.stream.bytes.size() +
                            piece.repeats.stream.bytes.size() + piece.folded.stream.bytes.size() +
                            piece.degenerate.stream.bytes.size() + piece.seam_size;
    add_attributes(piece, mesh);
  }
  if (auto ok = finish_mesh(s, faces); !ok) return Failure{ok.error()};
  auto shape = measure(faces);
  if (!shape) return Failure{shape.error()};
  mesh.shape = *shape;
  mesh.metadata = std::move(faces.metadata);
  if (s.metadata) mesh.metadata_bytes = s.metadata->payload_size;
  return mesh;
}

}  // namespace

Expected<FileInfo> inspect(std::span<const std::byte> bytes, const Limits& limits) {
  return guarded("inspect", [&]() -> Expected<FileInfo> {
    Budget budget(limits, bytes.size());
    ContainerReader file(bytes);
    const auto sections = read_meshes(file, limits, budget);
    if (!sections) return Failure{sections.error()};
    std::uint64_t stays = 0, most = 0;
    for (const MeshSections& s : *sections) {
      stays += info_memory(s);
      most = std::max(most, looking_memory(s));
    }
    if (auto ok = budget.check(stays + most); !ok) return Failure{ok.error()};
    FileInfo info;
    info.format_major = format_major;
    info.format_minor = file.minor();
    info.level = file.level();
    info.total_bytes = info.overhead_bytes = bytes.size();
    info.meshes.reserve(sections->size());
    for (const MeshSections& s : *sections) {
      auto mesh = look_at(s);
      if (!mesh) return Failure{mesh.error()};
      info.overhead_bytes -= mesh->connectivity_bytes + mesh->position_bytes +
                             mesh->attribute_bytes + mesh->metadata_bytes;
      info.meshes.push_back(std::move(*mesh));
    }
    return info;
  });
}

Expected<MeshShape> measure(const Mesh& mesh) {
  return guarded("measure", [&] { return shape_of(mesh); });
}

}  // namespace clers

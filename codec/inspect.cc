// Decodes the faces of a mesh at a time, and measures them.
#include "codec/inspect.h"

#include <algorithm>
#include <utility>

#include "codec/base/guarded.h"
#include "codec/base/in_mesh.h"
#include "codec/file/mesh_decoder.h"
#include "codec/file/open_file.h"
#include "codec/soup/measure.h"

namespace CLERS_VISIBLE clers {
namespace {

using namespace internal;

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

/// Moves the metadata, which come with the faces, to `info`.
Expected<InspectedMesh> look_at(const MeshSections& s, MeshInfo& info) {
  InspectedMesh result;
  Mesh faces;
  if (s.pieces.size() > 1) faces = make_room(s, Values::skip);
  for (const PieceSections& piece : s.pieces) {
    auto decoded = decode_piece(piece, Values::skip);
    if (!decoded) return Failure{decoded.error()};
    if (s.pieces.size() == 1)
      faces = std::move(decoded->mesh);
    else if (auto ok = put_piece(piece, decoded->mesh, faces); !ok)
      return Failure{ok.error()};
    result.counts.reversed_faces += decoded->reversed_faces;
    const auto symbols = in_word_order(decoded->counts.symbols);
    for (std::size_t i = 0; i < symbols.size(); ++i) result.counts.symbols[i] += symbols[i];
  }
  if (auto ok = finish_mesh(s, faces); !ok) return Failure{ok.error()};
  auto shape = shape_of(faces);
  if (!shape) return Failure{shape.error()};
  result.shape = *shape;
  info.metadata = std::move(faces.metadata);
  return result;
}

}  // namespace

Expected<Inspection> inspect(std::span<const std::byte> bytes, const Limits& limits) {
  return guarded("inspect", [&]() -> Expected<Inspection> {
    const auto file = open_file(bytes, limits);
    if (!file) return Failure{file.error()};
    std::uint64_t most = 0;
    for (const MeshSections& s : file->meshes) most = std::max(most, looking_memory(s));
    const std::uint64_t stays = info_memory(*file) + file->meshes.size() * sizeof(InspectedMesh);
    if (auto ok = file->budget.check(stays + most); !ok) return Failure{ok.error()};
    auto info = info_of(*file, false);
    if (!info) return Failure{info.error()};
    Inspection result{std::move(*info), {}};
    if (file->scene.metadata) {
      auto metadata = decode_metadata(*file->scene.metadata);
      if (!metadata) return Failure{metadata.error()};
      result.file.scene.metadata = std::move(*metadata);
    }
    result.meshes.reserve(file->meshes.size());
    for (std::size_t i = 0; i < file->meshes.size(); ++i) {
      auto mesh = look_at(file->meshes[i], result.file.meshes[i]);
      if (!mesh) return in_mesh(mesh.error(), i, file->meshes.size());
      result.meshes.push_back(*mesh);
    }
    return result;
  });
}

Expected<MeshShape> measure(const MeshView& mesh) {
  return guarded("measure", [&] { return shape_of(mesh); });
}

}  // namespace clers

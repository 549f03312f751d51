// Into how many pieces, and by which faces.
#include "codec/file/cut_mesh.h"

#include <string>
#include <utility>

#include "codec/pieces/partition.h"

namespace clers::internal {
namespace {

/// Faces of a piece; 0 where the mesh stays whole: values by index belong to all of it.
std::uint32_t piece_faces(const MeshView& mesh, const EncodeOptions& options) {
  const std::size_t faces = mesh.face_count();
  for (const AttributeView a : mesh.attributes)
    if (!a.indices.empty()) return 0;
  if (!options.piece_faces) {
    // Without positions it takes longer to part a mesh than to code it.
    if (faces <= most_faces_whole || !mesh.position()) return 0;
    // An even number of pieces: two threads have the same to do.
    const std::size_t pairs = (faces + 2 * default_piece_faces - 1) / (2 * default_piece_faces);
    return static_cast<std::uint32_t>((faces + 2 * pairs - 1) / (2 * pairs));
  }
  return faces > *options.piece_faces ? *options.piece_faces : 0;
}

}  // namespace

Expected<CutMesh> cut_mesh(const MeshView& mesh, const EncodeOptions& options, unsigned threads) {
  CutMesh result;
  auto quantised = quantise(mesh, options, threads);
  if (!quantised) return Failure{quantised.error()};
  result.quantised = std::move(*quantised);
  if (const std::uint32_t most = piece_faces(mesh, options); most > 0) {
    Partition parts = partition(mesh, most, threads);
    if (parts.count() > 1)
      result.cutter = std::make_unique<PieceCutter>(result.quantised.mesh, std::move(parts));
  }
  return result;
}

Expected<Done> check_options(const EncodeOptions& options) {
  if (options.level < min_level || options.level > max_level)
    return fail(ErrorCode::bad_option,
                "level " + std::to_string(options.level) + ", expected 1 to 9");
  if (options.piece_faces == 0)
    return fail(ErrorCode::bad_option, "pieces of 0 faces, expected at least 1");
  if (options.order > Order::keep) return fail(ErrorCode::bad_option, "no such order");
  for (const DefectPolicy on :
       {options.on_nonmanifold, options.on_degenerate, options.on_duplicate})
    if (on > DefectPolicy::reject) return fail(ErrorCode::bad_option, "no such policy for defects");
  return Done{};
}

}  // namespace clers::internal

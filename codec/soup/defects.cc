#include "codec/soup/defects.h"

#include <string>

#include "codec/soup/adjacency.h"
#include "codec/soup/duplicates.h"
#include "codec/soup/regular_faces.h"

namespace clers::internal {

Expected<Done> refuse_defects(const Mesh& mesh, const EncodeOptions& options) {
  const bool degenerate = options.on_degenerate == OnOddity::error,
             duplicate = options.on_duplicate == OnOddity::error,
             nonmanifold = options.on_nonmanifold == OnOddity::error;
  if (!degenerate && !duplicate && !nonmanifold) return Done{};
  const Cycles all(mesh.corners, mesh.face_sizes);
  const RegularFaces regular(all, mesh.face_sizes, mesh.vertex_count);
  if (degenerate && !regular.degenerate().empty()) {
    const std::uint32_t f = regular.degenerate()[0];
    return fail(ErrorCode::degenerate_face, Place::face, f,
                all.size(f) < 3
                    ? "has " + std::to_string(all.size(f)) + " corners, expected 3 at least"
                    : "uses a vertex twice");
  }
  if (duplicate) {
    const auto duplicates = duplicate_faces(mesh);
    if (!duplicates.empty())
      return fail(ErrorCode::duplicate_face, Place::face, duplicates[0].second,
                  "has the same vertices as face " + std::to_string(duplicates[0].first));
  }
  if (nonmanifold) {
    const Faces faces(regular.corners(), regular.sizes());
    const auto twins = find_twins(faces, mesh.vertex_count);
    if (!twins) {
      Error error = twins.error();
      if (error.place == Place::face)
        error.at = regular.in_all(static_cast<std::uint32_t>(error.at));
      return Failure{std::move(error)};
    }
    const std::uint32_t v = vertex_of_several_fans(faces, *twins, mesh.vertex_count);
    if (v != Vertex::null_index)
      return fail(ErrorCode::nonmanifold_vertex, Place::vertex, v,
                  "its faces form more than one fan, expected one");
  }
  return Done{};
}

}  // namespace clers::internal

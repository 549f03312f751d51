// A pass over each array that may be wrong.
#include "codec/base/check.h"

#include <algorithm>
#include <utility>

#include "codec/base/faces.h"
#include "codec/base/utf8.h"

namespace clers::internal {
namespace {

std::size_t face_of_corner(const MeshView& mesh, std::size_t h) {
  if (mesh.triangles_only()) return h / 3;
  std::size_t f = 0;
  while (h >= mesh.face_sizes[f]) h -= mesh.face_sizes[f++];
  return f;
}

}  // namespace

Expected<Done> check_attribute(const AttributeView& a, std::size_t count) {
  const auto refuse = [](std::string what) {
    return fail(ErrorCode::inconsistent_mesh, std::move(what));
  };
  if (!is_utf8(a.name)) return refuse("an attribute's name is not UTF-8");
  if (a.name.size() > 255) return refuse("an attribute's name is longer than 255 bytes");
  const std::string attribute = "attribute \"" + std::string(a.name) + "\" has ";
  if (const std::string defect = kind_defect(a); !defect.empty()) return refuse(attribute + defect);
  const std::size_t size = a.value_size(), stride = a.step();
  if (stride < size)
    return refuse(attribute + "values of " + std::to_string(size) + " bytes, " +
                  std::to_string(stride) + " bytes apart");
  if (!a.indices.empty()) {
    if (a.domain == Domain::vertex && a.name == position_name)
      return refuse(attribute + "indices, which positions of vertices cannot have");
    if (a.indices.size() != count)
      return refuse(attribute + std::to_string(a.indices.size()) + " indices, expected " +
                    std::to_string(count));
    if (!a.data.empty() && a.data.size() < size)
      return refuse(attribute + std::to_string(a.data.size()) + " bytes of values of " +
                    std::to_string(size));
    const std::size_t values = a.value_count();
    if (values >= no_value - 1 || !holds_values(a.data.size(), values, size, stride))
      return refuse(attribute + std::to_string(a.data.size()) +
                    " bytes of values, expected a multiple of " + std::to_string(stride));
    for (const std::uint32_t i : a.indices)
      if (i >= values && i != no_value)
        return refuse(attribute + "an element with value " + std::to_string(i) + " of " +
                      std::to_string(values));
    return Done{};
  }
  if (!holds_values(a.data.size(), count, size, stride))
    return refuse(attribute + std::to_string(a.data.size()) + " bytes of values, expected " +
                  std::to_string(count) + " times " + std::to_string(stride));
  return Done{};
}

Expected<Done> check_arrays(const MeshView& mesh) {
  std::uint64_t triangles = 0;  // that polygons become
  if (mesh.triangles_only()) {
    if (mesh.corners.size() % 3 != 0)
      return fail(ErrorCode::inconsistent_mesh,
                  std::to_string(mesh.corners.size()) + " corners, expected a multiple of 3");
  } else {
    std::uint64_t corners = 0;
    for (const std::uint32_t size : mesh.face_sizes) {
      corners += size;
      triangles += size < 3 ? 0 : size - 2;
    }
    if (corners != mesh.corners.size())
      return fail(ErrorCode::inconsistent_mesh,
                  "faces of " + std::to_string(corners) + " corners in all, but " +
                      std::to_string(mesh.corners.size()) + " corners are given");
  }
  if (mesh.corners.size() > max_corners || mesh.face_count() > max_corners)
    return fail(ErrorCode::too_large, std::to_string(mesh.face_count()) + " faces of " +
                                          std::to_string(mesh.corners.size()) +
                                          " corners, expected at most " +
                                          std::to_string(max_corners));
  if (triangles > max_faces)
    return fail(ErrorCode::too_large, "polygons of " + std::to_string(triangles) +
                                          " triangles, expected at most " +
                                          std::to_string(max_faces));
  std::uint32_t largest = 0;
  for (const std::uint32_t v : mesh.corners) largest = std::max(largest, v);
  if (!mesh.corners.empty() && largest >= mesh.vertex_count) {
    std::size_t h = 0;
    while (mesh.corners[h] < mesh.vertex_count) ++h;
    return fail(ErrorCode::inconsistent_mesh, Place::face, face_of_corner(mesh, h),
                "has vertex " + std::to_string(mesh.corners[h]) + ", expected one below " +
                    std::to_string(mesh.vertex_count));
  }
  return Done{};
}

}  // namespace clers::internal

#include "codec/cli/places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "codec/cli/vertex_values.h"

namespace clers::cli {

Expected<std::vector<Vec3>> places_of(const Mesh& mesh, const char* by) {
  const Attribute* position = mesh.position();
  if (position == nullptr || position->components != 3)
    return fail(ErrorCode::unsupported, fmt::format("has no positions to {} by", by));
  std::vector<Vec3> at(mesh.vertex_count);
  for (std::size_t v = 0; v < at.size(); ++v) {
    const auto [x, y, z] = load_three(*position, v);
    at[v] = {x, y, z};
  }
  for (const std::uint32_t v : mesh.corners)
    for (const double x : {at[v].x, at[v].y, at[v].z})
      if (!(std::abs(x) < 1e100))
        return fail(ErrorCode::not_on_grid, Place::vertex, v,
                    fmt::format("is at {}, expected a number below 1e100", x));
  return at;
}

double diagonal_of(const Surface& surface, const std::vector<Vec3>& at) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Vec3 low{far, far, far}, high{-far, -far, -far};
  for (const Vertex v : surface.vertices()) {
    const Vec3& p = at[v.index()];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return surface.characteristic().v == 0 ? 0 : length(high - low);
}

}  // namespace clers::cli

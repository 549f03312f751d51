// Faces with sorted corners, sorted.
#include "codec/soup/duplicates.h"

#include <algorithm>
#include <numeric>

#include "codec/base/faces.h"

namespace clers::internal {

std::vector<std::pair<std::uint32_t, std::uint32_t>> duplicate_faces(const MeshView& mesh) {
  const std::uint32_t faces = static_cast<std::uint32_t>(mesh.face_count());
  std::vector<std::uint32_t> corners(mesh.corners.begin(), mesh.corners.end());
  const Cycles sorted(corners, mesh.face_sizes);
  for (std::uint32_t f = 0; f < faces; ++f)
    std::sort(corners.begin() + sorted.begin(f), corners.begin() + sorted.end(f));
  const auto vertices = [&](std::uint32_t f) { return sorted.cycle(f); };
  std::vector<std::uint32_t> order(faces);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t f, std::uint32_t g) {
    const auto a = vertices(f), b = vertices(g);
    const auto at = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    if (at.first == a.end() || at.second == b.end())
      return a.size() != b.size() ? a.size() < b.size() : f < g;
    return *at.first < *at.second;
  });
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  std::uint32_t first = 0;
  for (std::uint32_t i = 1; i < faces; ++i) {
    const auto a = vertices(order[first]), b = vertices(order[i]);
    if (std::equal(a.begin(), a.end(), b.begin(), b.end()))
      result.push_back({order[first], order[i]});
    else
      first = i;
  }
  std::sort(result.begin(), result.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
  return result;
}

}  // namespace clers::internal

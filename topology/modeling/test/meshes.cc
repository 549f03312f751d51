#include "topology/modeling/test/meshes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include "topology/test/meshes.h"

namespace clers::test {

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Shape shape_of(const Mesh& mesh) {
  Triangles triangles;
  for (std::size_t i = 0; i < mesh.corners.size(); i += 3)
    triangles.push_back({mesh.corners[i], mesh.corners[i + 1], mesh.corners[i + 2]});
  std::vector<Position> positions(mesh.vertex_count);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    float p[3];
    std::memcpy(p, mesh.position()->data.data() + v * sizeof p, sizeof p);
    positions[v] = {p[0], p[1], p[2]};
  }
  return {from_triangles(triangles), Positions(std::move(positions))};
}

Plain plain_of(const Shape& shape) {
  Plain out;
  const Surface& s = shape.surface;
  std::vector<std::uint32_t> number(s.vertex_limit());
  for (const Vertex v : s.vertices()) {
    number[v.index()] = static_cast<std::uint32_t>(out.points.size());
    out.points.push_back(shape.positions[v]);
  }
  for (const Face f : s.faces())
    out.triangles.push_back({number[s.org(half_edge(f, 0)).index()],
                             number[s.org(half_edge(f, 1)).index()],
                             number[s.org(half_edge(f, 2)).index()]});
  return out;
}

Agreement agree(const Plain& a, const Plain& b, double tolerance) {
  if (a.points.size() != b.points.size()) return {"numbers of vertices differ"};
  if (a.triangles.size() != b.triangles.size()) return {"numbers of triangles differ"};
  // The vertices of b by cells of twice the tolerance.
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& c) const {
      return static_cast<std::size_t>((c[0] * 73856093) ^ (c[1] * 19349663) ^ (c[2] * 83492791));
    }
  };
  const auto cell_of = [&](const std::array<double, 3>& p) {
    Cell c;
    for (std::size_t i = 0; i < 3; ++i)
      c[i] = static_cast<std::int64_t>(std::floor(p[i] / (2 * tolerance)));
    return c;
  };
  std::unordered_multimap<Cell, std::uint32_t, Hash> cells;
  for (std::uint32_t i = 0; i < b.points.size(); ++i) cells.emplace(cell_of(b.points[i]), i);

  Agreement found;
  std::vector<std::uint32_t> image(a.points.size());
  std::vector<bool> taken(b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    std::size_t matches = 0;
    const Cell c = cell_of(a.points[i]);
    for (int n = 0; n < 27; ++n) {
      const auto [begin, end] =
          cells.equal_range({c[0] + n % 3 - 1, c[1] + n / 3 % 3 - 1, c[2] + n / 9 - 1});
      for (auto at = begin; at != end; ++at) {
        const double d = distance(a.points[i], b.points[at->second]);
        if (d > tolerance) continue;
        ++matches;
        image[i] = at->second;
        found.distance = std::max(found.distance, d);
      }
    }
    if (matches != 1 || taken[image[i]])
      return {"vertex " + std::to_string(i) + " is near " + std::to_string(matches)};
    taken[image[i]] = true;
  }
  const auto sorted = [](std::vector<std::array<std::uint32_t, 3>> triangles) {
    for (auto& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  };
  auto mapped = a.triangles;
  for (auto& t : mapped)
    for (std::uint32_t& v : t) v = image[v];
  if (sorted(std::move(mapped)) != sorted(b.triangles)) return {"triangles differ"};
  return found;
}

}  // namespace clers::test

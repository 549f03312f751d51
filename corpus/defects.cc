#include <algorithm>
#include <utility>
#include <vector>

#include "corpus/build.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::corpus {
namespace {

/// The faces of `mesh` once more, with their values.
void append_copy(Mesh& out, const Mesh& mesh) {
  out.corners.insert(out.corners.end(), mesh.corners.begin(), mesh.corners.end());
  out.face_sizes.insert(out.face_sizes.end(), mesh.face_sizes.begin(), mesh.face_sizes.end());
  for (std::size_t i = 0; i < out.attributes.size(); ++i)
    if (const Attribute& a = mesh.attributes[i]; a.domain != Domain::vertex)
      out.attributes[i].data.insert(out.attributes[i].data.end(), a.data.begin(), a.data.end());
}

}  // namespace

Mesh doubled(const Mesh& mesh) {
  Mesh out = mesh;
  append_copy(out, mesh);
  return out;
}

Mesh two_sided(const Mesh& mesh) {
  Mesh out = mesh;
  append_copy(out, reversed(mesh));
  return out;
}

Mesh add_fins(const Mesh& mesh, std::uint32_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points = points_of(mesh);
  Points all(points.size() + count);
  for (const Point& p : points) all.add(p[0], p[1], p[2]);
  std::vector<std::uint32_t> corners = mesh.corners;
  const std::uint32_t half_edges = static_cast<std::uint32_t>(mesh.corners.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t h = random.below(half_edges);
    const std::uint32_t a = mesh.corners[h], b = mesh.corners[next_corner(h)];
    const std::uint32_t tip =
        all.add(points[a][0], 0.5 * (points[a][1] + points[b][1]), points[b][2] + 1);
    corners.insert(corners.end(), {a, b, tip});
  }
  return make_mesh(all, std::move(corners));
}

Mesh reverse_some(Mesh mesh, std::uint32_t count, std::uint64_t seed) {
  Random random(seed);
  const std::vector<std::uint32_t> order =
      random.permutation(static_cast<std::uint32_t>(mesh.face_count()));
  for (std::size_t i = 0; i < std::min<std::size_t>(count, order.size()); ++i)
    std::swap(mesh.corners[3 * std::size_t{order[i]} + 1],
              mesh.corners[3 * std::size_t{order[i]} + 2]);
  return mesh;
}

Mesh isolate(const Mesh& mesh, std::uint32_t count) {
  Points points(std::size_t{mesh.vertex_count} + count);
  for (const Point& p : points_of(mesh)) points.add(p[0], p[1], p[2]);
  for (std::uint32_t i = 0; i < count; ++i) points.add(i % 1024, i / 1024, -1);
  return make_mesh(points, mesh.corners);
}

}  // namespace clers::corpus

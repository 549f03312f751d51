#include "corpus/build.h"

#include <cstring>
#include <utility>

namespace clers::corpus {

Mesh make_mesh(const Points& points, std::vector<std::uint32_t> corners) {
  Mesh mesh;
  mesh.vertex_count = points.size();
  mesh.corners = std::move(corners);
  Attribute position{position_name, Domain::vertex, Scalar::float32, 3, {}};
  position.data.resize(points.list().size() * sizeof(Point));
  if (!position.data.empty())
    std::memcpy(position.data.data(), points.list().data(), position.data.size());
  mesh.attributes.push_back(std::move(position));
  return mesh;
}

std::vector<Point> points_of(const Mesh& mesh) {
  std::vector<Point> points(mesh.vertex_count);
  if (!points.empty())
    std::memcpy(points.data(), mesh.position()->data.data(), points.size() * sizeof(Point));
  return points;
}

std::vector<std::uint32_t> twins_of(const std::vector<std::uint32_t>& corners,
                                    std::uint32_t vertex_count) {
  // Half-edges by the vertex they leave, so that a twin is found in the star of the other end.
  std::vector<std::uint32_t> first(std::size_t{vertex_count} + 1, 0);
  for (std::uint32_t v : corners) ++first[v + std::size_t{1}];
  for (std::size_t v = 0; v < vertex_count; ++v) first[v + 1] += first[v];
  std::vector<std::uint32_t> leaving(corners.size());
  std::vector<std::uint32_t> at(first.begin(), first.end() - 1);
  for (std::uint32_t h = 0; h < corners.size(); ++h) leaving[at[corners[h]]++] = h;

  std::vector<std::uint32_t> twin(corners.size(), no_twin);
  for (std::uint32_t h = 0; h < corners.size(); ++h) {
    const std::uint32_t from = corners[h], to = corners[next_corner(h)];
    for (std::uint32_t i = first[to]; i < first[to + std::size_t{1}]; ++i)
      if (corners[next_corner(leaving[i])] == from) twin[h] = leaving[i];
  }
  return twin;
}

Attribute gather(const Attribute& attribute, const std::vector<std::uint32_t>& indices) {
  Attribute out{attribute.name, attribute.domain, attribute.scalar, attribute.components, {}};
  const std::size_t stride = attribute.stride();
  out.data.resize(indices.size() * stride);
  for (std::size_t i = 0; i < indices.size(); ++i)
    std::memcpy(out.data.data() + i * stride, attribute.data.data() + indices[i] * stride, stride);
  return out;
}

}  // namespace clers::corpus

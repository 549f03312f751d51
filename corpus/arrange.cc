#include <cstddef>
#include <vector>

#include "corpus/build.h"
#include "corpus/generate.h"
#include "corpus/random.h"

namespace clers::corpus {
namespace {

// Where each face's corners begin, and at last where all end.
std::vector<std::uint32_t> face_starts(const Mesh& mesh) {
  std::vector<std::uint32_t> starts(mesh.face_count() + 1, 0);
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    starts[f + 1] = starts[f] + (mesh.triangles_only() ? 3 : mesh.face_sizes[f]);
  return starts;
}

// The mesh whose vertices, faces and corners are the old ones in the order given.
Mesh reorder(const Mesh& mesh, const std::vector<std::uint32_t>& vertices,
             const std::vector<std::uint32_t>& faces, const std::vector<std::uint32_t>& corners) {
  std::vector<std::uint32_t> renumbered(mesh.vertex_count);
  for (std::uint32_t i = 0; i < vertices.size(); ++i) renumbered[vertices[i]] = i;

  Mesh out;
  out.name = mesh.name;
  out.vertex_count = mesh.vertex_count;
  out.corners.reserve(corners.size());
  for (const std::uint32_t c : corners) out.corners.push_back(renumbered[mesh.corners[c]]);
  if (!mesh.triangles_only())
    for (const std::uint32_t f : faces) out.face_sizes.push_back(mesh.face_sizes[f]);
  for (const Attribute& a : mesh.attributes)
    out.attributes.push_back(gather(a, a.domain == Domain::vertex   ? vertices
                                       : a.domain == Domain::corner ? corners
                                                                    : faces));
  return out;
}

std::vector<std::uint32_t> identity(std::size_t n) {
  std::vector<std::uint32_t> p(n);
  std::iota(p.begin(), p.end(), 0u);
  return p;
}

}  // namespace

Mesh shuffle(const Mesh& mesh, std::uint64_t seed) {
  Random random(seed);
  const std::vector<std::uint32_t> vertices = random.permutation(mesh.vertex_count);
  const std::vector<std::uint32_t> faces =
      random.permutation(static_cast<std::uint32_t>(mesh.face_count()));
  const std::vector<std::uint32_t> starts = face_starts(mesh);
  std::vector<std::uint32_t> corners;
  corners.reserve(mesh.corners.size());
  for (const std::uint32_t f : faces) {
    const std::uint32_t size = starts[f + 1] - starts[f];
    if (size == 0) continue;
    const std::uint32_t first = random.below(size);
    for (std::uint32_t i = 0; i < size; ++i) corners.push_back(starts[f] + (first + i) % size);
  }
  return reorder(mesh, vertices, faces, corners);
}

Mesh reversed(const Mesh& mesh) {
  const std::vector<std::uint32_t> starts = face_starts(mesh);
  std::vector<std::uint32_t> corners;
  corners.reserve(mesh.corners.size());
  for (std::size_t f = 0; f + 1 < starts.size(); ++f) {
    const std::uint32_t size = starts[f + 1] - starts[f];
    for (std::uint32_t i = 0; i < size; ++i) corners.push_back(starts[f] + (size - i) % size);
  }
  return reorder(mesh, identity(mesh.vertex_count), identity(mesh.face_count()), corners);
}

Mesh disjoint_union(std::span<const Mesh> meshes) {
  Mesh out;
  bool polygons = false;
  for (const Mesh& mesh : meshes) polygons = polygons || !mesh.triangles_only();
  for (const Mesh& mesh : meshes) {
    for (const std::uint32_t v : mesh.corners) out.corners.push_back(out.vertex_count + v);
    out.vertex_count += mesh.vertex_count;
    if (polygons && mesh.triangles_only())
      out.face_sizes.insert(out.face_sizes.end(), mesh.face_count(), 3);
    out.face_sizes.insert(out.face_sizes.end(), mesh.face_sizes.begin(), mesh.face_sizes.end());
    if (&mesh == &meshes.front()) {
      out.attributes = mesh.attributes;
      out.name = mesh.name;
      continue;
    }
    for (std::size_t i = 0; i < out.attributes.size(); ++i)
      out.attributes[i].data.insert(out.attributes[i].data.end(), mesh.attributes[i].data.begin(),
                                    mesh.attributes[i].data.end());
  }
  return out;
}

Mesh copies(const Mesh& mesh, std::uint32_t n) {
  return disjoint_union(std::vector<Mesh>(n, mesh));
}

}  // namespace clers::corpus

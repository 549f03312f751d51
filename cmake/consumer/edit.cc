// A mesh is decoded, edited as a surface, and encoded again; its values follow.
#include <cstdint>
#include <vector>

#include <clers/decode.h>
#include <clers/encode.h>
#include <clers/surface.h>

int main() {
  // A square of two triangles, with a height at each vertex.
  const std::vector<std::uint32_t> corners = {0, 1, 2, 0, 2, 3};
  const std::vector<double> heights = {0, 1, 2, 3};
  const clers::AttributeView height = clers::attribute_view("height", heights, 1);
  clers::MeshView square;
  square.vertex_count = 4;
  square.corners = corners;
  square.attributes = std::span(&height, 1);
  const auto file = clers::encode(square);
  if (!file) return 1;

  const auto meshes = clers::decode(file->bytes);
  if (!meshes) return 1;
  const clers::Mesh& mesh = meshes->front();
  auto surface = clers::to_surface(mesh);
  if (!surface) return 1;
  // The diagonal is the only edge inside.
  for (const clers::Face f : surface->faces()) {
    for (const clers::HalfEdge h : surface->star(f))
      if (!surface->is_boundary(h)) {
        if (!surface->flip(h)) return 1;
        break;
      }
    break;
  }
  const auto flipped = clers::to_mesh(*surface, mesh.attributes);
  if (!flipped) return 1;
  const auto again = clers::encode(flipped->mesh);
  return again && flipped->mesh.corners != mesh.corners && flipped->mesh.vertex_count == 4 ? 0 : 1;
}

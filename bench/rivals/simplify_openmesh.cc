#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "bench/simplifiers.h"

namespace clers::bench {
namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

Triangles run(const Input& input, std::size_t faces) {
  Mesh mesh;
  for (std::size_t v = 0; v < input.vertex_count; ++v)
    mesh.add_vertex(
        {input.positions[3 * v], input.positions[3 * v + 1], input.positions[3 * v + 2]});
  const auto vertex = [&](std::size_t h) { return mesh.vertex_handle(input.triangles[h]); };
  for (std::size_t h = 0; h < input.triangles.size(); h += 3)
    mesh.add_face(vertex(h), vertex(h + 1), vertex(h + 2));
  mesh.update_face_normals();
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  OpenMesh::Decimater::ModNormalFlippingT<Mesh>::Handle flipping;
  decimater.add(quadric);
  decimater.add(flipping);
  decimater.module(quadric).unset_max_err();
  decimater.initialize();
  decimater.decimate_to_faces(0, faces);
  mesh.garbage_collection();
  Triangles out;
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    out.points.push_back({p[0], p[1], p[2]});
  }
  for (const auto f : mesh.faces())
    for (const auto v : mesh.fv_range(f))
      out.corners.push_back(static_cast<std::uint32_t>(v.idx()));
  return out;
}

}  // namespace

Simplifier openmesh_simplifier() {
  return {"OpenMesh quadric", run};
}

}  // namespace clers::bench

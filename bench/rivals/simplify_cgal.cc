#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include "bench/simplifiers.h"

namespace clers::bench {
namespace {

using SurfaceMesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
namespace simplification = CGAL::Surface_mesh_simplification;

/// CGAL counts edges; we ask for faces.
struct Enough {
  std::size_t faces;
  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile& profile, std::size_t, std::size_t) const {
    return profile.surface_mesh().number_of_faces() <= faces;
  }
};

Triangles run(const Input& input, std::size_t faces) {
  SurfaceMesh mesh;
  for (std::size_t v = 0; v < input.vertex_count; ++v)
    mesh.add_vertex(
        {input.positions[3 * v], input.positions[3 * v + 1], input.positions[3 * v + 2]});
  const auto vertex = [&](std::size_t h) { return SurfaceMesh::Vertex_index(input.triangles[h]); };
  for (std::size_t h = 0; h < input.triangles.size(); h += 3)
    mesh.add_face(vertex(h), vertex(h + 1), vertex(h + 2));
  if (mesh.number_of_faces() > faces)
    simplification::edge_collapse(
        mesh, Enough{faces},
        CGAL::parameters::get_cost(simplification::LindstromTurk_cost<SurfaceMesh>())
            .get_placement(simplification::LindstromTurk_placement<SurfaceMesh>()));
  mesh.collect_garbage();
  Triangles out;
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    out.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : mesh.faces())
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      out.corners.push_back(static_cast<std::uint32_t>(v.idx()));
  return out;
}

}  // namespace

Simplifier cgal_simplifier() {
  return {"CGAL " CGAL_VERSION_STR " Lindstrom-Turk", run};
}

}  // namespace clers::bench

// Checks, cuts and twins first, so that Surface::from_twins has nothing left to refuse; back, a
// copy of what is live.
#include "codec/surface.h"

#include <cstring>
#include <string>
#include <utility>

#include "codec/base/check.h"
#include "codec/base/faces.h"
#include "codec/base/guarded.h"
#include "codec/base/wide_corners.h"
#include "codec/soup/adjacency.h"
#include "codec/soup/cut.h"
#include "codec/soup/distinct_faces.h"
#include "codec/soup/regular_faces.h"

namespace CLERS_VISIBLE clers {
namespace {

using namespace internal;

Expected<Done> check_triangles(const MeshView& mesh) {
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f)
    if (mesh.face_sizes[f] != 3)
      return fail(
          ErrorCode::unsupported, Place::face, f,
          "has " + std::to_string(mesh.face_sizes[f]) + " corners, a surface is made of triangles");
  if (mesh.corners.size() / 3 > max_faces)
    return fail(ErrorCode::too_large, std::to_string(mesh.corners.size() / 3) +
                                          " faces, expected at most " + std::to_string(max_faces));
  return Done{};
}

Expected<Done> refuse_degenerate(std::span<const std::uint32_t> c) {
  for (std::size_t f = 0; f < c.size() / 3; ++f)
    if (c[3 * f] == c[3 * f + 1] || c[3 * f + 1] == c[3 * f + 2] || c[3 * f + 2] == c[3 * f])
      return fail(ErrorCode::degenerate_face, Place::face, f, "uses a vertex twice");
  return Done{};
}

Expected<Surface> surface_of(const MeshView& given) {
  std::vector<std::uint32_t> memory;
  const auto mesh = with_wide_corners(given, memory);
  if (!mesh) return Failure{mesh.error()};
  if (auto ok = check_arrays(*mesh); !ok) return Failure{ok.error()};
  if (auto ok = check_triangles(*mesh); !ok) return Failure{ok.error()};
  if (auto ok = refuse_degenerate(mesh->corners); !ok) return Failure{ok.error()};
  const Faces faces(mesh->corners, {});
  const auto twins = find_twins(faces, mesh->vertex_count);
  if (!twins) return Failure{twins.error()};
  if (const std::uint32_t v = vertex_of_several_fans(faces, *twins, mesh->vertex_count); v != ~0u)
    return fail(ErrorCode::nonmanifold_vertex, Place::vertex, v,
                "its faces form more than one fan, expected one");
  std::vector<Vertex> org;
  org.reserve(mesh->corners.size());
  for (const std::uint32_t v : mesh->corners) org.emplace_back(v);
  auto surface = Surface::from_twins(org, *twins, mesh->vertex_count);
  if (!surface) return fail(ErrorCode::internal, describe(surface.error()));
  return *std::move(surface);
}

/// Faces that a surface can have -> the surface, cut only where they are none. `in_mesh` says which
/// of the `count` faces of the mesh each one is.
template <class InMesh>
Expected<SurfaceByCuts> cut_surface(std::span<const std::uint32_t> corners, Adjacency adjacency,
                                    std::uint32_t vertex_count, std::size_t count,
                                    InMesh&& in_mesh) {
  const Faces faces(corners, {});
  SurfaceByCuts result;
  CutSurface made;
  if (adjacency.edges() == 0 &&
      vertex_of_several_fans(faces, adjacency.twins, vertex_count) == ~0u) {
    made.corners.assign(corners.begin(), corners.end());
    made.twins = std::move(adjacency.twins);
  } else {
    made = cut(faces, vertex_count, std::move(adjacency), Fans::all);
  }
  const auto place = [&](std::size_t h) {
    return 3 * std::size_t{in_mesh(static_cast<std::uint32_t>(h / 3))} + h % 3;
  };
  std::vector<Vertex> org(3 * count);
  std::vector<HalfEdge> twins(3 * count);
  for (std::size_t h = 0; h < made.corners.size(); ++h) {
    org[place(h)] = Vertex(made.corners[h]);
    if (made.twins[h])
      twins[place(h)] = HalfEdge(static_cast<std::uint32_t>(place(made.twins[h].index())));
  }
  auto surface = Surface::from_twins(org, twins,
                                     vertex_count + static_cast<std::uint32_t>(made.copied.size()));
  if (!surface) return fail(ErrorCode::internal, describe(surface.error()));
  result.surface = *std::move(surface);
  result.copied = std::move(made.copied);
  for (const std::uint32_t f : made.reversed) result.reversed.push_back(in_mesh(f));
  return result;
}

Expected<SurfaceByCuts> surface_by_cuts(const MeshView& given) {
  std::vector<std::uint32_t> memory;
  const auto mesh = with_wide_corners(given, memory);
  if (!mesh) return Failure{mesh.error()};
  if (auto ok = check_arrays(*mesh); !ok) return Failure{ok.error()};
  if (auto ok = check_triangles(*mesh); !ok) return Failure{ok.error()};
  const RegularFaces regular(Cycles(mesh->corners, {}), {}, mesh->vertex_count);
  const Faces all(regular.corners(), {});
  Adjacency adjacency = match_edges(all, mesh->vertex_count);
  const std::vector<Repeat> repeats = find_repeats(all, adjacency);
  const std::size_t count = mesh->corners.size() / 3;
  Expected<SurfaceByCuts> result = [&] {
    if (repeats.empty())
      return cut_surface(all.org, std::move(adjacency), mesh->vertex_count, count,
                         [&](std::uint32_t f) { return regular.in_all(f); });
    const DistinctFaces distinct(all, repeats);
    return cut_surface(distinct.corners, distinct.adjacency(all, std::move(adjacency)),
                       mesh->vertex_count, count,
                       [&](std::uint32_t f) { return regular.in_all(distinct.faces[f]); });
  }();
  if (!result) return result;
  result->degenerate = regular.degenerate();
  for (const Repeat& repeat : repeats) result->repeated.push_back(regular.in_all(repeat.face));
  return result;
}

Expected<MeshOfSurface> mesh_of(const Surface& surface, const AttributeViews& attributes) {
  MeshOfSurface result;
  Mesh& mesh = result.mesh;
  const auto& counts = surface.characteristic();
  result.vertices.reserve(static_cast<std::size_t>(counts.v));
  result.faces.reserve(static_cast<std::size_t>(counts.f));
  mesh.corners.reserve(3 * static_cast<std::size_t>(counts.f));
  std::vector<std::uint32_t> number(surface.vertex_limit());
  for (const Vertex v : surface.vertices()) {
    number[v.index()] = mesh.vertex_count++;
    result.vertices.push_back(v);
  }
  for (const Face f : surface.faces()) {
    result.faces.push_back(f);
    for (const HalfEdge h : surface.star(f)) mesh.corners.push_back(number[surface.org(h).index()]);
  }
  const std::size_t faces = surface.face_limit();
  const std::size_t limits[domain_count] = {surface.vertex_limit(), 3 * faces, faces};
  mesh.attributes.reserve(attributes.size());
  for (const AttributeView a : attributes) {
    const std::size_t domain = static_cast<std::size_t>(a.domain);
    if (auto ok = check_attribute(a, domain < domain_count ? limits[domain] : 0); !ok)
      return Failure{ok.error()};
    Attribute made{std::string(a.name), a.domain, a.scalar, a.components, {}};
    made.data.resize(mesh.value_count(a.domain) * a.value_size());
    std::byte* to = made.data.data();
    const auto copy = [&](std::size_t i) {
      std::memcpy(to, a.value(i), a.value_size());
      to += a.value_size();
    };
    switch (a.domain) {
      case Domain::vertex:
        for (const Vertex v : result.vertices) copy(v.index());
        break;
      case Domain::corner:
        for (const Face f : result.faces)
          for (unsigned i = 0; i < 3; ++i) copy(half_edge(f, i).index());
        break;
      case Domain::face:
        for (const Face f : result.faces) copy(f.index());
        break;
    }
    mesh.attributes.push_back(std::move(made));
  }
  return result;
}

}  // namespace

Expected<Surface> to_surface(const MeshView& mesh) {
  return guarded("make a surface", [&] { return surface_of(mesh); });
}

Expected<SurfaceByCuts> to_surface_by_cuts(const MeshView& mesh) {
  return guarded("make a surface", [&] { return surface_by_cuts(mesh); });
}

Expected<MeshOfSurface> to_mesh(const Surface& surface, const AttributeViews& attributes) {
  return guarded("make a mesh", [&] { return mesh_of(surface, attributes); });
}

}  // namespace clers

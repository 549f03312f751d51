// 4-8 subdivision by edge splits alone, on tri-quad meshes (Velho and Zorin 2001; Dynamic adaptive
// meshes, §3 and §5).
#ifndef CLERS_TOPOLOGY_MODELING_FOUR_EIGHT_H
#define CLERS_TOPOLOGY_MODELING_FOUR_EIGHT_H

#include <span>
#include <vector>

#include <clers/modeling/creases.h>
#include <clers/modeling/geometry.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

/// A tri-quad mesh is made of blocks: two faces and the edge between them, the split edge, which is
/// half-edge 1 on both sides; a face whose half-edge 1 is on the boundary is half a block. The
/// numbering of corners alone makes a mesh tri-quad, and the split of an edge keeps it so
/// (surface.h): the paper's vertex 0, the weld vertex, is our corner 0, and its edge 0, which is
/// opposite, our half-edge 1.
bool is_split_edge(const Surface& surface, HalfEdge h);
/// The first edge that keeps the surface from being a tri-quad mesh: `tri_quad`.
Result<Done, Violation> check_tri_quad(const Surface& surface);

/// Edges whose pairs of faces do not overlap: the clusters of Program 5. First those of `quads`,
/// then the longest, of which none is sharp, nor of a component that `quads` fill: there the
/// quadrilaterals are blocks as they are. `lengths` by edge of `edges`; equal ones in the order of
/// edges.
struct Clusters {
  std::vector<HalfEdge> pairs;
  std::vector<Face> single;
};
Clusters cluster_faces(const Surface& surface, const Creases& creases,
                       std::span<const HalfEdge> edges, std::span<const double> lengths,
                       std::span<const HalfEdge> quads);

/// Makes any surface a tri-quad mesh (Program 5): splits the edge of every pair, and every face
/// that is in none, so that all old edges but those of pairs are split edges. New vertices are at
/// the mean of the ends or corners, on the null point. F faces in p pairs become 3F - 2p.
///
/// `quads`: blocks that are there already, by their split edges (base_mesh.h makes them of
/// quadrilaterals). A component that is made of them alone stays as it is (§5: "bypass"). Elsewhere
/// they are pairs before all others: an edge is a split edge on both sides or on none, so beside a
/// triangle that was split a quadrilateral must be, too.
///
/// `length(surface, h)`: a double. Preconditions: `tri_quad` of quads, of which each counts
/// once, whichever side names it; `ids_left`; the geometry has values of all vertices. Memory: as
/// subdivide_4_8. Cost: O(F log F). Ids: all stay valid.
template <class Geometry, class Length>
Result<Done, Violation> make_tri_quad(Surface& surface, Geometry& geometry, Creases& creases,
                                      Length&& length, std::span<const HalfEdge> quads = {}) {
  if (surface.characteristic().f > std::int64_t{max_faces} / 3)
    return Failure{Violation{Precondition::ids_left, max_faces}};
  for (const HalfEdge h : quads)
    if (!surface.is_live(h) || !is_split_edge(surface, h))
      return Failure{Violation{Precondition::tri_quad, h.index()}};
  const std::vector<HalfEdge> edges = edges_of(surface);
  std::vector<double> lengths;
  lengths.reserve(edges.size());
  for (const HalfEdge h : edges) lengths.push_back(length(surface, h));
  const Clusters clusters = cluster_faces(surface, creases, edges, lengths, quads);

  std::vector<Term> mask;
  for (const HalfEdge h : clusters.pairs) {
    mask = {{surface.org(h), 0.5}, {surface.dest(h), 0.5}};
    auto value = geometry.combine(mask);
    geometry.set(*creases.split(surface, h, Point()), std::move(value));
  }
  for (const Face f : clusters.single) {
    face_mask(surface, f, mask);
    auto value = geometry.combine(mask);
    geometry.set(*creases.split(surface, f, Point()), std::move(value));
  }
  return Done{};
}

/// Where a vertex goes in a step: halfway to the mean of its neighbours along the edges of blocks.
/// On a sharp curve, whose edges are split in every second step, it stays in the others, and goes
/// to 3/4 and 1/8 for each neighbour on it; corners stay.
void four_eight_vertex_mask(const Surface& surface, const Creases& creases, Vertex v,
                            std::vector<Term>& mask);
/// The vertex put on a split edge: the mean of its block's corners; of the ends if sharp.
void four_eight_edge_mask(const Surface& surface, const Creases& creases, HalfEdge h,
                          std::vector<Term>& mask);

/// One step: splits all split edges. F faces become 2F; b, g and s stay; two steps halve every
/// edge. The surface need not be a simplicial complex.
///
/// Preconditions: `ids_left`; `tri_quad`; the geometry has values of all vertices. When memory runs
/// out it throws std::bad_alloc: the surface is valid, but may be partly subdivided. Cost: O(F),
/// and the degrees of vertices once. Ids: all stay valid. Inverse: welds of the new vertices, in
/// any order, which are those at corner 0 of a face.
template <class Geometry>
Result<Done, Violation> subdivide_4_8(Surface& surface, Geometry& geometry, Creases& creases) {
  if (surface.characteristic().f > std::int64_t{max_faces} / 2)
    return Failure{Violation{Precondition::ids_left, max_faces}};
  if (const auto ok = check_tri_quad(surface); !ok) return ok;
  std::vector<Term> mask;
  const std::vector<Face> faces = newest_faces(surface);
  Moves<Geometry> moves(vertices_along(surface, faces), geometry,
                        [&](Vertex v, std::vector<Term>& of_v) {
                          four_eight_vertex_mask(surface, creases, v, of_v);
                        });
  surface.reserve(static_cast<std::uint32_t>(surface.characteristic().f),
                  static_cast<std::uint32_t>(surface.characteristic().f));
  // Blocks share no face: each is whole when its turn comes, and no mask has new vertices.
  std::vector<HalfEdge> edges;
  edges.reserve(static_cast<std::size_t>(surface.characteristic().f));
  std::vector<bool> taken(surface.face_limit());
  for (const Face f : faces) {
    if (taken[f.index()]) continue;
    edges.push_back(half_edge(f, 1));
    for (const HalfEdge h : surface.star(edges.back())) taken[left(h).index()] = true;
  }
  reserve_values(geometry, surface.vertex_limit() + edges.size());
  for (const HalfEdge h : edges) {
    four_eight_edge_mask(surface, creases, h, mask);
    auto value = geometry.combine(mask);
    geometry.set(*creases.split(surface, h, Point()), std::move(value));
  }
  moves.set(geometry);
  return Done{};
}

}  // namespace clers

#endif

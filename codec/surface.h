// A mesh as a surface of <clers/topology/surface.h>, to be edited by its operators, and back.
#ifndef CLERS_CODEC_SURFACE_H
#define CLERS_CODEC_SURFACE_H

#include <vector>

#include <clers/error.h>
#include <clers/mesh.h>
#include <clers/mesh_view.h>
#include <clers/topology/export.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// The surface of a mesh of triangles: Vertex(i), Face(i) and HalfEdge(i) are vertex, face and
/// corner i of the mesh, so that its arrays of values can be indexed by them. A vertex that no face
/// uses has no part in a surface: its id is free, and the next vertex that is made takes it. A mesh
/// that is no oriented manifold is refused, and so is a polygon, which can be triangulated in more
/// than one way.
///
/// Errors: unsupported (the first face that is no triangle), degenerate_face (the first that uses a
/// vertex twice), nonmanifold_edge and nonorientable (the first face that keeps its edges from
/// being those of an oriented manifold), nonmanifold_vertex (the first vertex whose faces form more
/// than one fan), inconsistent_mesh, too_large, out_of_memory. Attributes are not looked at. Thread
/// safe. Cost: linear; some 100 bytes a face, and 64 a vertex on the way.
Expected<Surface> to_surface(const MeshView& mesh);

/// The surface of any mesh of triangles, and what made it one.
struct SurfaceByCuts {
  Surface surface;
  /// Vertex(vertex_count + i) is a copy of vertex copied[i] of the mesh: where what meets at a
  /// vertex or an edge is no disk.
  std::vector<std::uint32_t> copied;
  /// Faces that the rest of their component made turn around, ascending: corner 0 of such a face
  /// stays, corners 1 and 2 are those that were 2 and 1.
  std::vector<std::uint32_t> reversed;
  /// Faces that no surface has, ascending: those that use a vertex twice, and those that repeat an
  /// earlier one and go on no further. Their ids are free.
  std::vector<std::uint32_t> degenerate, repeated;

  bool whole() const {
    return copied.empty() && reversed.empty() && degenerate.empty() && repeated.empty();
  }
};

/// As to_surface, but a mesh that is no oriented manifold is cut where encode cuts it: little is
/// cut, faces of one component run the same way as far as that can be, and no handle is made. A
/// mesh that to_surface takes becomes the same surface. Which faces are turned or left out depends
/// on their order.
///
/// Errors: unsupported (the first face that is no triangle), inconsistent_mesh, too_large,
/// out_of_memory. Attributes are not looked at. Thread safe. Cost: linear, and sorts of the faces
/// at edges that are not manifold.
Expected<SurfaceByCuts> to_surface_by_cuts(const MeshView& mesh);

/// A mesh made of a surface, and which elements of the surface its own are.
struct MeshOfSurface {
  Mesh mesh;
  std::vector<Vertex> vertices;  ///< one for each vertex of the mesh
  std::vector<Face> faces;       ///< one for each face
};

/// The live vertices and faces of a surface, in the order of their ids. Corner 0 of a face is its
/// corner 0. Vertices that share a point, as where a surface was cut, stay apart.
///
/// `attributes` have values for all ids: surface.vertex_limit() of vertices, face_limit() of faces,
/// 3 * face_limit() of corners. Those of live elements are copied. They must have followed the
/// edits: VertexData and FaceData (<clers/topology/element_data.h>) do, and are attributes by
/// attribute_view(name, data.values()). Arrays that did not follow fit only while no operator has
/// made, moved or deleted an element of theirs. Values of corners never follow by themselves: a
/// flip leaves ids and moves corners, and an observer (<clers/topology/follow.h>) says which.
///
/// Errors: inconsistent_mesh (as of encode), out_of_memory. Thread safe. Cost: linear.
Expected<MeshOfSurface> to_mesh(const Surface& surface, const AttributeViews& attributes = {});

}  // namespace clers

#endif

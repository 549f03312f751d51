// The figures of a triangle mesh, counted from its corners by sorting edges: shares no code with
// the generators or the codec.
#ifndef CLERS_CORPUS_TEST_RECOUNT_H
#define CLERS_CORPUS_TEST_RECOUNT_H

#include <cstdint>

#include "codec/mesh.h"

namespace clers::corpus {

struct Figures {
  std::int64_t vertices = 0, edges = 0, faces = 0;
  std::int64_t components = 0, boundary_curves = 0;
  std::int64_t genus = 0;  ///< of orientable manifolds; sum over the components
  std::int64_t isolated_vertices = 0;
  std::int64_t pinched_vertices = 0;   ///< whose faces form more than one fan
  std::int64_t crowded_edges = 0;      ///< of more than two faces
  std::int64_t misoriented_edges = 0;  ///< of two faces that run along them the same way
  std::int64_t degenerate_faces = 0;   ///< that use a vertex twice
  std::int64_t equal_faces = 0;        ///< pairs of the same three vertices, neighbours when sorted

  bool manifold() const {
    return pinched_vertices == 0 && crowded_edges == 0 && degenerate_faces == 0;
  }
  bool surface() const { return manifold() && misoriented_edges == 0 && isolated_vertices == 0; }
  bool closed_surface() const { return surface() && boundary_curves == 0; }
};

/// Precondition: triangles_only(). Edges are told apart by their two ends.
Figures recount(const Mesh& mesh);

}  // namespace clers::corpus

#endif

// Meshes as tuples that the Python side packs and unpacks:
//
//     (vertex_count, corners, face_sizes or None, attributes, name, metadata)
//
// of an attribute (name, domain, values, indices or None), of metadata (key, bytes).
#ifndef CLERS_BINDINGS_PYTHON_MESHES_H
#define CLERS_BINDINGS_PYTHON_MESHES_H

#include <deque>
#include <string>
#include <vector>

#include "arrays.h"
#include <clers/mesh.h>
#include <clers/mesh_view.h>
#include <clers/order.h>

namespace clers::python {

/// Views of meshes whose arrays stay those of Python.
class Views {
 public:
  /// Raises TypeError and ValueError for what is no such tuple.
  explicit Views(const py::sequence& meshes);

  const std::vector<MeshView>& get() const { return views_; }

 private:
  MeshView view_of(const py::tuple& mesh);
  AttributeView attribute_of(const py::tuple& attribute);

  // What views point to, and nothing moves.
  std::deque<std::vector<AttributeView>> attributes_;
  std::deque<std::vector<MetadataEntry>> metadata_;
  std::deque<std::string> names_;
  std::vector<py::object> kept_;
  std::vector<MeshView> views_;
};

/// A copy that owns its arrays.
Mesh mesh_of(const MeshView& view);

/// The tuple of a mesh, whose arrays are moved to it.
py::tuple tuple_of(Mesh mesh);

/// (vertices, faces, first_corners)
py::tuple tuple_of(Permutation order);

Domain domain_of(const std::string& word);

}  // namespace clers::python

#endif

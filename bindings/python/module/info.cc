// What a file says of itself, as classes whose fields can be read.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>

#include "module.h"
#include <clers/info.h>
#include <clers/inspect.h>

namespace clers::python {

namespace py = pybind11;

namespace {

template <class Class>
void define_shape(Class shape) {
  using S = MeshShape;
  shape.def_readonly("vertices", &S::vertices)
      .def_readonly("faces", &S::faces)
      .def_readonly("triangles", &S::triangles)
      .def_readonly("isolated_vertices", &S::isolated_vertices)
      .def_readonly("nonmanifold_edges", &S::nonmanifold_edges)
      .def_readonly("nonmanifold_vertices", &S::nonmanifold_vertices)
      .def_readonly("misoriented_edges", &S::misoriented_edges)
      .def_readonly("degenerate_faces", &S::degenerate_faces)
      .def_readonly("duplicate_faces", &S::duplicate_faces)
      .def_property_readonly("components", [](const S& s) { return s.surface.components; })
      .def_property_readonly("nonorientable_components",
                             [](const S& s) { return s.surface.nonorientable_components; })
      .def_property_readonly("boundary_curves",
                             [](const S& s) { return s.surface.boundary_curves; })
      .def_property_readonly("genus", [](const S& s) { return s.surface.genus; });
}

template <class Class>
void define_mesh(Class mesh) {
  using M = MeshInfo;
  mesh.def_readonly("name", &M::name)
      .def_readonly("vertices", &M::vertices)
      .def_readonly("faces", &M::faces)
      .def_readonly("corners", &M::corners)
      .def_readonly("triangles_only", &M::triangles_only)
      .def_readonly("pieces", &M::pieces)
      .def_readonly("copied_vertices", &M::copied_vertices)
      .def_readonly("welded_vertices", &M::welded_vertices)
      .def_readonly("repeated_faces", &M::repeated_faces)
      .def_readonly("degenerate_faces", &M::degenerate_faces)
      .def_readonly("connectivity_bytes", &M::connectivity_bytes)
      .def_readonly("polygon_bytes", &M::polygon_bytes)
      .def_readonly("stitching_bytes", &M::stitching_bytes)
      .def_readonly("order_bytes", &M::order_bytes)
      .def_readonly("position_bytes", &M::position_bytes)
      .def_readonly("attribute_bytes", &M::attribute_bytes)
      .def_readonly("metadata_bytes", &M::metadata_bytes)
      .def_readonly("attributes", &M::attributes)
      .def_property_readonly("metadata", [](const M& m) {
        py::dict entries;
        for (const MetadataEntry& e : m.metadata) entries[py::str(e.key)] = py::bytes(e.value);
        return entries;
      });
}

}  // namespace

void define_info(py::module_& m) {
  define_shape(py::class_<MeshShape>(m, "MeshShape"));
  using A = AttributeInfo;
  py::class_<A>(m, "AttributeInfo")
      .def_readonly("name", &A::name)
      .def_property_readonly("domain", [](const A& a) { return name(a.domain); })
      .def_property_readonly("dtype", [](const A& a) { return name(a.scalar); })
      .def_readonly("components", &A::components)
      .def_readonly("count", &A::count)
      .def_readonly("bytes", &A::bytes)
      .def_readonly("numbers", &A::numbers)
      .def_readonly("coder", &A::coder)
      .def_readonly("structure", &A::structure)
      .def_readonly("error", &A::error)
      .def_property_readonly("measure", [](const A& a) { return name(a.measure); });
  define_mesh(py::class_<MeshInfo>(m, "MeshInfo"));
  py::class_<CodingCounts>(m, "CodingCounts")
      .def_readonly("reversed_faces", &CodingCounts::reversed_faces)
      .def_property_readonly("symbols", [](const CodingCounts& c) {
        py::dict counts;
        for (std::size_t i = 0; i < c.symbols.size(); ++i)
          counts[py::str(std::string(1, "CLERS"[i]))] = c.symbols[i];
        return counts;
      });
  using F = FileInfo;
  py::class_<F>(m, "FileInfo")
      .def_property_readonly(
          "format", [](const F& f) { return py::make_tuple(f.format_major, f.format_minor); })
      .def_readonly("level", &F::level)
      .def_readonly("total_bytes", &F::total_bytes)
      .def_readonly("overhead_bytes", &F::overhead_bytes)
      .def_readonly("meshes", &F::meshes);
  py::class_<InspectedMesh>(m, "InspectedMesh")
      .def_readonly("shape", &InspectedMesh::shape)
      .def_readonly("counts", &InspectedMesh::counts);
  py::class_<Inspection>(m, "Inspection")
      .def_readonly("file", &Inspection::file)
      .def_readonly("meshes", &Inspection::meshes);
}

}  // namespace clers::python

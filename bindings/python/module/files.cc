// Files of other formats, and whether two meshes are the same.
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "errors.h"
#include "meshes.h"
#include "module.h"
#include <clers/compare.h>
#include <clers/io.h>

namespace clers::python {
namespace {

io::Format format_of(const std::string& word) {
  if (const auto format = io::format_of(word)) return *format;
  throw py::value_error("format '" + word + "', expected ply, obj, off or stl");
}

py::list tuples_of(const io::Notes& notes) {
  py::list result;
  for (const io::Note& n : notes)
    result.append(py::make_tuple(n.kind == io::Note::Kind::loss, n.count, n.what, n.text));
  return result;
}

std::vector<Mesh> meshes_of(const py::sequence& meshes) {
  const Views views(meshes);
  std::vector<Mesh> result;
  for (const MeshView& view : views.get()) result.push_back(mesh_of(view));
  return result;
}

/// (meshes, notes)
py::tuple read(const py::object& bytes, const std::string& format) {
  const BytesOf held(bytes);
  const io::Format f = format_of(format);
  Expected<io::ReadResult> read = fail(ErrorCode::internal, "nothing was read");
  {
    const py::gil_scoped_release free;
    read = io::read(held.get(), f);
  }
  io::ReadResult result = value_of(std::move(read));
  py::list meshes;
  for (Mesh& mesh : result.meshes) meshes.append(tuple_of(std::move(mesh)));
  return py::make_tuple(meshes, tuples_of(result.notes));
}

/// (bytes, notes)
py::tuple write(const py::sequence& given, const std::string& format, std::optional<bool> text) {
  const std::vector<Mesh> meshes = meshes_of(given);
  const io::Format f = format_of(format);
  std::optional<io::Encoding> encoding;
  if (text) encoding = *text ? io::Encoding::text : io::Encoding::binary;
  Expected<io::WriteResult> written = fail(ErrorCode::internal, "nothing was written");
  {
    const py::gil_scoped_release free;
    written = io::write(meshes, f, encoding);
  }
  io::WriteResult result = value_of(std::move(written));
  return py::make_tuple(bytes_of(result.bytes), tuples_of(result.notes));
}

/// (verdict, what)
py::tuple compare_meshes(const py::tuple& a, const py::tuple& b, const py::sequence& allowed) {
  const std::vector<Mesh> meshes = meshes_of(py::make_tuple(a, b));
  std::vector<Tolerance> tolerances;
  for (const py::handle entry : allowed) {
    const auto row = py::cast<py::tuple>(entry);
    tolerances.push_back({py::cast<std::string>(row[0]), py::cast<double>(row[1])});
  }
  Expected<Comparison> compared = fail(ErrorCode::internal, "nothing was compared");
  {
    const py::gil_scoped_release free;
    compared = compare(meshes[0], meshes[1], tolerances);
  }
  const Comparison result = value_of(std::move(compared));
  constexpr const char* words[] = {"same", "different", "undecided"};
  return py::make_tuple(words[static_cast<unsigned>(result.verdict)], result.what);
}

}  // namespace

void define_files(py::module_& m) {
  m.def("read", &read, py::arg("data"), py::arg("format"));
  m.def("write", &write, py::arg("meshes"), py::arg("format"), py::arg("text"));
  m.def("compare", &compare_meshes, py::arg("a"), py::arg("b"), py::arg("tolerances"));
}

}  // namespace clers::python

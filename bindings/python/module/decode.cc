// Decoding and measuring, without the GIL.
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "errors.h"
#include "meshes.h"
#include "module.h"
#include <clers/decoder.h>
#include <clers/inspect.h>

namespace clers::python {
namespace {

Limits limits_of(const py::dict& given) {
  Limits limits;
  if (given.contains("meshes")) limits.meshes = py::cast<std::uint64_t>(given["meshes"]);
  if (given.contains("vertices")) limits.vertices = py::cast<std::uint64_t>(given["vertices"]);
  if (given.contains("faces")) limits.faces = py::cast<std::uint64_t>(given["faces"]);
  if (given.contains("memory")) limits.memory = py::cast<std::uint64_t>(given["memory"]);
  return limits;
}

/// What `work` gives, done without the GIL.
template <class Work>
auto without_gil(const Work& work) {
  std::optional<decltype(work())> result;
  {
    const py::gil_scoped_release free;
    result.emplace(work());
  }
  return value_of(std::move(*result));
}

/// A file that is open, and its bytes, which stay Python's.
class OpenFile {
 public:
  OpenFile(const py::object& bytes, const py::dict& limits, unsigned threads, py::object progress)
      : bytes_(std::make_unique<BytesOf>(bytes)) {
    DecodeOptions options{limits_of(limits), progress_of(std::move(progress)), threads};
    const auto span = bytes_->get();
    decoder_ = std::make_unique<Decoder>(
        without_gil([&] { return Decoder::open(span, std::move(options)); }));
  }

  const Decoder& get() const { return *decoder_; }

 private:
  std::unique_ptr<BytesOf> bytes_;
  std::unique_ptr<Decoder> decoder_;
};

py::list decode_all(const OpenFile& file) {
  std::vector<Mesh> meshes = without_gil([&] { return file.get().decode(); });
  py::list result;
  for (Mesh& mesh : meshes) result.append(tuple_of(std::move(mesh)));
  return result;
}

/// (mesh tuple, mesh index, index, count, seam vertices, their numbers, first vertex, first face)
py::tuple decode_piece(const OpenFile& file, std::size_t index) {
  Piece piece = without_gil([&] { return file.get().decode_piece(index); });
  std::vector<std::uint32_t> vertices, numbers;
  for (const SharedVertex& v : piece.seam) {
    vertices.push_back(v.vertex);
    numbers.push_back(v.number);
  }
  return py::make_tuple(tuple_of(std::move(piece.mesh)), piece.mesh_index, piece.index, piece.count,
                        array_of(std::move(vertices)), array_of(std::move(numbers)),
                        piece.first_vertex, piece.first_face);
}

/// Decodes what was asked for into arrays of the caller: corners or None, sizes or None, attributes
/// as (name, domain, array of one row a value).
void decode_into(const OpenFile& file, std::size_t mesh, const py::object& corners,
                 const py::object& sizes, const py::sequence& attributes) {
  MeshTarget target;
  std::vector<py::object> kept;
  const auto words = [&](const py::object& object) -> std::span<std::uint32_t> {
    if (object.is_none()) return {};
    auto array = py::cast<py::array_t<std::uint32_t>>(object);
    return {array.mutable_data(), static_cast<std::size_t>(array.size())};
  };
  target.corners = words(corners);
  target.face_sizes = words(sizes);
  std::vector<std::string> names(attributes.size());
  std::vector<AttributeTarget> targets;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto row = py::cast<py::tuple>(attributes[i]);
    names[i] = py::cast<std::string>(row[0]);
    auto array = py::cast<py::array>(row[2]);
    AttributeTarget& t = targets.emplace_back();
    t.name = names[i];
    t.domain = domain_of(py::cast<std::string>(row[1]));
    t.scalar = scalar_of(array);
    t.components = static_cast<std::uint8_t>(array.ndim() == 1 ? 1 : array.shape(1));
    t.data = {static_cast<std::byte*>(array.mutable_data()),
              static_cast<std::size_t>(array.nbytes())};
  }
  target.attributes = targets;
  without_gil([&] { return file.get().decode_into(mesh, target); });
}

Inspection inspect_file(const py::object& bytes, const py::dict& limits) {
  const BytesOf held(bytes);
  return without_gil([&] { return inspect(held.get(), limits_of(limits)); });
}

MeshShape measure_mesh(const py::tuple& mesh) {
  const Views views(py::make_tuple(mesh));
  return without_gil([&] { return measure(views.get()[0]); });
}

}  // namespace

void define_decode(py::module_& m) {
  py::class_<OpenFile>(m, "OpenFile")
      .def(py::init<const py::object&, const py::dict&, unsigned, py::object>(), py::arg("data"),
           py::arg("limits"), py::arg("threads"), py::arg("progress"))
      .def_property_readonly("mesh_count", [](const OpenFile& f) { return f.get().mesh_count(); })
      .def_property_readonly("piece_count", [](const OpenFile& f) { return f.get().piece_count(); })
      .def("info", [](const OpenFile& f) { return without_gil([&] { return f.get().info(); }); })
      .def("decode_all", &decode_all)
      .def("decode",
           [](const OpenFile& f, std::size_t mesh) {
             return tuple_of(without_gil([&] { return f.get().decode(mesh); }));
           })
      .def("decode_into", &decode_into)
      .def("decode_piece", &decode_piece);
  m.def("inspect", &inspect_file, py::arg("data"), py::arg("limits"));
  m.def("measure", &measure_mesh, py::arg("mesh"));
}

}  // namespace clers::python

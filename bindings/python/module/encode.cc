// Encoding, without the GIL.
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "errors.h"
#include "meshes.h"
#include "module.h"
#include <clers/apart.h>
#include <clers/encode.h>

namespace clers::python {
namespace {

Precision precision_of(const py::dict& words) {
  Precision p;
  const auto kind = py::cast<std::string>(words["kind"]);
  const std::pair<const char*, Precision::Kind> kinds[] = {
      {"lossless", Precision::Kind::lossless},
      {"bits", Precision::Kind::bits},
      {"step", Precision::Kind::step},
      {"error", Precision::Kind::error},
      {"grid", Precision::Kind::grid},
      {"directions", Precision::Kind::directions},
      {"recomputed", Precision::Kind::recomputed}};
  bool known = false;
  for (const auto& [word, value] : kinds)
    if (kind == word) p.kind = value, known = true;
  if (!known) throw py::value_error("no kind of precision is called '" + kind + "'");
  p.bits = py::cast<int>(words["bits"]);
  p.size = py::cast<double>(words["size"]);
  for (const py::handle x : py::cast<py::sequence>(words["origin"]))
    p.origin.push_back(py::cast<double>(x));
  p.or_directions = py::cast<bool>(words["or_directions"]);
  return p;
}

DefectPolicy policy_of(const py::handle& word) {
  return py::cast<bool>(word) ? DefectPolicy::reject : DefectPolicy::keep;
}

EncodeOptions options_of(const py::dict& given) {
  EncodeOptions options;
  options.level = py::cast<int>(given["level"]);
  if (!given["piece_faces"].is_none())
    options.piece_faces = py::cast<std::uint32_t>(given["piece_faces"]);
  options.threads = py::cast<unsigned>(given["threads"]);
  options.order = py::cast<bool>(given["keep_order"]) ? Order::keep : Order::free;
  options.on_nonmanifold = policy_of(given["reject_nonmanifold"]);
  options.on_degenerate = policy_of(given["reject_degenerate"]);
  options.on_duplicate = policy_of(given["reject_duplicate"]);
  for (const py::handle entry : py::cast<py::sequence>(given["precisions"])) {
    const auto row = py::cast<py::tuple>(entry);
    AttributePrecision& asked = options.precisions.emplace_back();
    asked.name = py::cast<std::string>(row[0]);
    if (!row[1].is_none()) asked.domain = domain_of(py::cast<std::string>(row[1]));
    asked.precision = precision_of(py::cast<py::dict>(row[2]));
  }
  options.progress = progress_of(given["progress"]);
  return options;
}

/// (bytes, permutations, report, counts, warnings)
py::tuple encode_meshes(const py::sequence& meshes, const py::dict& given) {
  const Views views(meshes);
  const EncodeOptions options = options_of(given);
  Encoded encoded = [&] {
    Expected<Encoded> result = fail(ErrorCode::internal, "nothing was encoded");
    {
      const py::gil_scoped_release free;
      result = encode(views.get(), options);
    }
    return value_of(std::move(result));
  }();
  py::list permutations, warnings;
  for (Permutation& order : encoded.permutations) permutations.append(tuple_of(std::move(order)));
  for (const Warning& w : encoded.warnings)
    warnings.append(py::make_tuple(w.mesh, w.attribute, name(w.domain), w.at, w.what));
  return py::make_tuple(bytes_of(encoded.bytes), permutations, py::cast(encoded.report),
                        py::cast(encoded.counts), warnings);
}

/// A mesh that is cut, and its arrays, which stay Python's.
class Apart {
 public:
  Apart(const py::tuple& mesh, const py::dict& given)
      : views_(std::make_unique<Views>(py::make_tuple(mesh))), options_(options_of(given)) {
    Expected<PiecesApart> cut = fail(ErrorCode::internal, "nothing was cut");
    {
      const py::gil_scoped_release free;
      cut = PiecesApart::cut(views_->get()[0], options_);
    }
    apart_ = std::make_unique<PiecesApart>(value_of(std::move(cut)));
  }

  std::size_t count() const { return apart_->count(); }
  py::bytes plan() const { return bytes_of(apart_->plan()); }

  py::tuple piece(std::size_t index) const {
    Expected<Mesh> piece = fail(ErrorCode::internal, "nothing was cut");
    {
      const py::gil_scoped_release free;
      piece = apart_->piece(index);
    }
    return tuple_of(value_of(std::move(piece)));
  }

  /// Of (bytes, vertices, faces, first corners) each: (bytes, permutation).
  py::tuple join(const py::sequence& given) const {
    std::vector<CodedPiece> pieces;
    for (const py::handle entry : given) {
      const auto row = py::cast<py::tuple>(entry);
      const BytesOf bytes(row[0]);
      const auto words = [&](std::size_t i) {
        const auto span = elements_of<std::uint32_t>(py::cast<py::array>(row[i]));
        return std::vector<std::uint32_t>(span.begin(), span.end());
      };
      pieces.push_back({{bytes.get().begin(), bytes.get().end()}, {words(1), words(2), words(3)}});
    }
    Expected<PiecesApart::Joined> joined = fail(ErrorCode::internal, "nothing was joined");
    {
      const py::gil_scoped_release free;
      joined = apart_->join(pieces);
    }
    PiecesApart::Joined whole = value_of(std::move(joined));
    return py::make_tuple(bytes_of(whole.bytes), tuple_of(std::move(whole.order)));
  }

 private:
  std::unique_ptr<Views> views_;
  EncodeOptions options_;
  std::unique_ptr<PiecesApart> apart_;
};

/// (bytes, vertices, faces, first corners)
py::tuple encode_piece_of(const py::tuple& piece, const py::object& plan, int level) {
  const Views views(py::make_tuple(piece));
  const BytesOf held(plan);
  EncodeOptions options;
  options.level = level;
  Expected<CodedPiece> coded = fail(ErrorCode::internal, "nothing was encoded");
  {
    const py::gil_scoped_release free;
    coded = encode_piece(views.get()[0], held.get(), options);
  }
  CodedPiece result = value_of(std::move(coded));
  return py::make_tuple(bytes_of(result.bytes), array_of(std::move(result.order.vertices)),
                        array_of(std::move(result.order.faces)),
                        array_of(std::move(result.order.first_corners)));
}

}  // namespace

void define_encode(py::module_& m) {
  py::class_<Apart>(m, "Apart")
      .def(py::init<const py::tuple&, const py::dict&>(), py::arg("mesh"), py::arg("options"))
      .def_property_readonly("count", &Apart::count)
      .def_property_readonly("plan", &Apart::plan)
      .def("piece", &Apart::piece)
      .def("join", &Apart::join);
  m.def("encode_piece", &encode_piece_of, py::arg("piece"), py::arg("plan"), py::arg("level"));
  m.def("encode", &encode_meshes, py::arg("meshes"), py::arg("options"));
}

}  // namespace clers::python

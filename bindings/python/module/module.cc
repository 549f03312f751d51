// The module _clers: the C++ library as the Python side of this package calls it.
#include "module.h"

#include <string>

#include "errors.h"
#include <clers/version.h>

namespace clers::python {
namespace {

const char* word(Place place) {
  constexpr const char* words[] = {"nowhere", "byte", "line",   "face",  "vertex",
                                   "edge",    "mesh", "symbol", "corner"};
  return words[static_cast<unsigned>(place)];
}
const char* word(Limited limited) {
  constexpr const char* words[] = {"nothing", "meshes", "vertices", "faces", "memory"};
  return words[static_cast<unsigned>(limited)];
}

}  // namespace

void raise(const Error& error) {
  const pybind11::object type = pybind11::module_::import("clers._errors").attr("Error");
  const pybind11::object exception = type(name(error.code), word(error.place), error.at, error.what,
                                          word(error.limited), error.needed, describe(error));
  PyErr_SetObject(type.ptr(), exception.ptr());
  throw pybind11::error_already_set();
}

}  // namespace clers::python

PYBIND11_MODULE(_clers, m) {
  m.doc() = "The C++ library, as clers calls it. Use the package clers instead.";
  m.attr("version") = clers::version;
  clers::python::define_info(m);
  clers::python::define_encode(m);
  clers::python::define_decode(m);
  clers::python::define_files(m);
}

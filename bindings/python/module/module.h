// The parts of the module _clers.
#ifndef CLERS_BINDINGS_PYTHON_MODULE_H
#define CLERS_BINDINGS_PYTHON_MODULE_H

#include <pybind11/pybind11.h>

#include <functional>
#include <string_view>

namespace clers::python {

void define_info(pybind11::module_& m);
void define_encode(pybind11::module_& m);
void define_decode(pybind11::module_& m);
void define_files(pybind11::module_& m);

/// Calls `callback`, unless it is None, with the GIL, and lets signals such as Ctrl-C through: what
/// that raises ends the work.
inline std::function<void(std::string_view, double)> progress_of(pybind11::object callback) {
  return [callback = std::move(callback)](std::string_view stage, double done) {
    const pybind11::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
    if (!callback.is_none()) callback(stage, done);
  };
}

}  // namespace clers::python

#endif

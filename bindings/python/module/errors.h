// Errors of the library as the exception clers.Error.
#ifndef CLERS_BINDINGS_PYTHON_ERRORS_H
#define CLERS_BINDINGS_PYTHON_ERRORS_H

#include <pybind11/pybind11.h>

#include <utility>

#include <clers/error.h>

namespace clers::python {

/// Raises clers.Error. Holds the GIL.
[[noreturn]] void raise(const Error& error);

/// What a call of the library returned, or its error raised.
template <class T>
T value_of(Expected<T> result) {
  if (!result) raise(result.error());
  return std::move(*result);
}

}  // namespace clers::python

#endif

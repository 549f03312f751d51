// The ten scalars by what numpy calls them.
#include "arrays.h"

#include <string>

namespace clers::python {

py::dtype dtype_of(Scalar scalar) {
  return py::dtype(name(scalar));
}

Scalar scalar_of(const py::array& array) {
  for (unsigned s = 0; s < scalar_count; ++s)
    if (array.dtype().equal(dtype_of(static_cast<Scalar>(s)))) return static_cast<Scalar>(s);
  throw py::type_error("values of type " + std::string(py::str(array.dtype())) +
                       ", expected int8 .. int64, uint8 .. uint64, float32 or float64");
}

}  // namespace clers::python

// Arrays of numpy <-> memory of C++, without copies.
#ifndef CLERS_BINDINGS_PYTHON_ARRAYS_H
#define CLERS_BINDINGS_PYTHON_ARRAYS_H

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <clers/scalar.h>

namespace clers::python {

namespace py = pybind11;

/// The type that numpy calls a scalar.
py::dtype dtype_of(Scalar scalar);
/// The scalar of an array. Raises TypeError for any other type than those ten, in native order.
Scalar scalar_of(const py::array& array);

/// The elements of a packed array of one dimension. Precondition: it is of this type, else
/// TypeError.
template <class T>
std::span<const T> elements_of(const py::array& array) {
  if (!py::isinstance<py::array_t<T, py::array::c_style>>(array) || array.ndim() != 1)
    throw py::type_error("expected a packed array of one dimension");
  return {static_cast<const T*>(array.data()), static_cast<std::size_t>(array.size())};
}

/// An array that owns what the vector had: a vector whose elements are of this type, in rows of so
/// many; `columns` 1: one dimension.
template <class T>
py::array array_of(std::vector<T> values, const py::dtype& type, std::size_t columns = 1) {
  auto owned = std::make_unique<std::vector<T>>(std::move(values));
  const T* const data = owned->data();
  const auto size = static_cast<std::size_t>(type.itemsize());
  const std::size_t rows = owned->size() * sizeof(T) / (size * columns);
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows)};
  if (columns > 1) shape.push_back(static_cast<py::ssize_t>(columns));
  py::capsule owner(owned.get(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  owned.release();
  return py::array(type, std::move(shape), data, owner);
}
inline py::array array_of(std::vector<std::uint32_t> values) {
  return array_of(std::move(values), py::dtype::of<std::uint32_t>());
}

/// What an object with the buffer protocol (bytes, memoryview, mmap, array) holds. Lives as long as
/// this does.
class BytesOf {
 public:
  explicit BytesOf(const py::object& object) {
    if (PyObject_GetBuffer(object.ptr(), &view_, PyBUF_C_CONTIGUOUS) != 0)
      throw py::error_already_set();
  }
  BytesOf(const BytesOf&) = delete;
  BytesOf& operator=(const BytesOf&) = delete;
  ~BytesOf() { PyBuffer_Release(&view_); }

  std::span<const std::byte> get() const {
    return {static_cast<const std::byte*>(view_.buf), static_cast<std::size_t>(view_.len)};
  }

 private:
  Py_buffer view_{};
};

inline py::bytes bytes_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace clers::python

#endif

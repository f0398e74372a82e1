#pragma once

#include <pybind11/numpy.h>

#include <utility>
#include <vector>

namespace stoss::python {

/// A read-only numpy array on the memory of a vector, which it takes over: nothing is copied.
template <typename T>
pybind11::array_t<T> take(std::vector<T>&& values, const std::vector<pybind11::ssize_t>& shape) {
  auto* owned = new std::vector<T>(std::move(values));
  const pybind11::capsule owner(owned, [](void* memory) { delete static_cast<std::vector<T>*>(memory); });
  pybind11::array_t<T> array(shape, owned->data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

template <typename T>
pybind11::array_t<T> take(std::vector<T>&& values) {
  const auto size = static_cast<pybind11::ssize_t>(values.size());
  return take(std::move(values), {size});
}

/// A read-only numpy array on the memory of a vector that belongs to a Python object, which it keeps alive.
template <typename T>
pybind11::array_t<T> view(const std::vector<T>& values, const pybind11::object& owner) {
  pybind11::array_t<T> array({static_cast<pybind11::ssize_t>(values.size())}, values.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// The numbers of an array of doubles, which the core takes as a vector.
inline std::vector<double> to_vector(const pybind11::array_t<double, pybind11::array::c_style>& array) {
  return {array.data(), array.data() + array.size()};
}

}  // namespace stoss::python

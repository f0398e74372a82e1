#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stoss/impact/resolution.hpp"
#include "stoss/impact/vibration.hpp"
#include "stoss/poll.hpp"
#include "stoss/quantity.hpp"
#include "stoss/table/c_source.hpp"
#include "stoss/table/restitution_function.hpp"

/// What the module stoss._core is made of. The package in python/stoss checks types, broadcasts and documents; here
/// nothing is computed.
namespace stoss::python {

namespace py = pybind11;

void bind_encounters(py::module_& module);
void bind_lists(py::module_& module);
void bind_impacts(py::module_& module);
void bind_restitution(py::module_& module);
void bind_oblique_impacts(py::module_& module);
void bind_prediction(py::module_& module);
void bind_tables(py::module_& module);
void bind_pulse(py::module_& module);
void bind_row(py::module_& module);
void bind_rules(py::module_& module);
void bind_quasistatic(py::module_& module);

using Doubles = py::array_t<double, py::array::c_style>;

/// Lets other Python threads run while the core computes. A daemon thread that comes back when the interpreter has
/// ended is ended by Python with a forced unwinding, which must be able to leave the destructor; pybind11's own guard
/// would abort the process.
class Released {
 public:
  Released() : state_(PyEval_SaveThread()) {}
  ~Released() noexcept(false) { PyEval_RestoreThread(state_); }
  Released(const Released&) = delete;
  Released& operator=(const Released&) = delete;

 private:
  PyThreadState* state_;
};

/// For the core's `poll`: throws KeyboardInterrupt if Ctrl-C was pressed. It asks for the interpreter every 50 ms, and
/// on the main thread only, which alone receives signals; elsewhere it is empty. To be made with the interpreter.
[[nodiscard]] Poll signal_poll();

/// For classes whose objects only the core makes: from Python no empty one can be made, by __new__ or by pickle.
template <typename Class>
void seal(Class& handle) {
  auto* type = reinterpret_cast<PyTypeObject*>(handle.ptr());
  type->tp_new = nullptr;
  PyType_Modified(type);
  handle.def("__reduce_ex__", [](const py::object& self, int) -> py::object {
    throw py::type_error("cannot pickle '" + std::string(py::str(py::type::of(self))) + "'");
  });
}

/// A read-only numpy array on the memory of a vector, which it takes over: nothing is copied.
template <typename T>
py::array_t<T> take(std::vector<T>&& values, const std::vector<py::ssize_t>& shape) {
  auto* owned = new std::vector<T>(std::move(values));
  const py::capsule owner(owned, [](void* memory) { delete static_cast<std::vector<T>*>(memory); });
  py::array_t<T> array(shape, owned->data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

template <typename T>
py::array_t<T> take(std::vector<T>&& values) {
  const auto size = static_cast<py::ssize_t>(values.size());
  return take(std::move(values), {size});
}

/// A read-only numpy array on the memory of a vector that belongs to a Python object, which it keeps alive.
template <typename T>
py::array_t<T> view(const std::vector<T>& values, const py::object& owner) {
  py::array_t<T> array({static_cast<py::ssize_t>(values.size())}, values.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// The numbers of an array of doubles, which the core takes as a vector.
inline std::vector<double> to_vector(const Doubles& array) { return {array.data(), array.data() + array.size()}; }

/// A structured array of the type stoss._core.oscillation.
using Oscillations = py::array_t<Oscillation, py::array::c_style>;

/// How bodies vibrate before an impact, as the core takes it.
inline Vibration to_vibration(const Oscillations& array) { return {array.data(), array.data() + array.size()}; }

/// How the modes above the cutoff answer, by its name.
inline Tail to_tail(const std::string& name) {
  if (name == "radiating") return Tail::radiating;
  if (name == "static") return Tail::quasistatic;
  if (name == "none") return Tail::none;
  throw std::invalid_argument("tail: radiating, static or none");
}

/// What the core makes of arguments, with the interpreter free for others meanwhile and Ctrl-C heeded.
template <typename Make>
auto computed(const Make& make) {
  const Poll poll = signal_poll();
  const Released released;
  return make(poll);
}

/// The quantities of one result as a dict, errors as name_error.
template <typename Result>
py::dict to_dict(const Quantities<Result>& quantities, const Result& result) {
  py::dict dict;
  for (const auto& [name, dimension, help, value, error] : quantities) {
    dict[py::str(name)] = value(result);
    if (error) dict[py::str(name + "_error")] = error(result);
  }
  return dict;
}

/// Adds a function to a module or a class. @param names of its arguments
template <typename Target, std::size_t count, typename Function>
void def(Target& target, const char* name, const char* const (&names)[count], const Function& function) {
  [&]<std::size_t... k>(std::index_sequence<k...>) { target.def(name, function, py::arg(names[k])...); }
  (std::make_index_sequence<count>());
}

template <typename Target, typename Function>
void def(Target& target, const char* name, const Function& function) {
  target.def(name, function);
}

/// Values and their errors, which the core has together.
inline std::vector<Estimate> to_estimates(const Doubles& values, const Doubles& errors) {
  std::vector<Estimate> all;
  for (py::ssize_t i = 0; i < values.size(); ++i) all.push_back({values.data()[i], errors.data()[i]});
  return all;
}

/// The same as two arrays.
inline std::pair<Doubles, Doubles> to_arrays(const std::vector<Estimate>& all, const std::vector<py::ssize_t>& shape) {
  std::vector<double> values, errors;
  for (const auto& [value, error] : all) {
    values.push_back(value);
    errors.push_back(error);
  }
  return {take(std::move(values), shape), take(std::move(errors), shape)};
}

/// An array of what a function has for each of the numbers of arrays of one size, computed without the interpreter.
template <typename Function, typename... Arrays>
auto over(const Function& function, const Doubles& first, const Arrays&... others) {
  const auto size = static_cast<std::size_t>(first.size());
  if ((... || (others.size() != first.size()))) throw std::invalid_argument("arrays: all of one size");
  return take(computed([&](const Poll& poll) {
    std::vector<decltype(function(first.data()[0], others.data()[0]...))> values(size);
    for (std::size_t i = 0; i < size; ++i) {
      if (poll) poll();
      values[i] = function(first.data()[i], others.data()[i]...);
    }
    return values;
  }));
}

/// The same for each of the names of arguments.
template <typename>
using ArrayFor = Doubles;

/// Binds a function of numbers, over an array of each. @param names of its arguments
template <typename Function, typename... Names>
void bind_over(py::module_& module, const char* name, const Function& function, const Names&... names) {
  def(module, name, {names...}, [function](const ArrayFor<Names>&... arrays) { return over(function, arrays...); });
}

/// The values of a table and their errors, over arrays of its places, and its maximum error. @param names of the places
template <typename Table, typename... Names>
void bind_values(py::class_<Table>& table, const Names&... names) {
  const auto value = [](const Table& self, const ArrayFor<Names>&... arrays) {
    return over([&](auto... at) { return self.value(at...); }, arrays...);
  };
  const auto error = [](const Table& self, const ArrayFor<Names>&... arrays) {
    return over([&](auto... at) { return self(at...).error; }, arrays...);
  };
  def(table, "values", {names...}, value);
  def(table, "errors", {names...}, error);
  def(table, "greatest_error", &Table::greatest_error);
}

/// A table as source code in each language.
template <typename Table>
void bind_code(py::class_<Table>& table) {
  const auto bind = [&](const char* name, std::string (*write)(const Table&, const TableLabel&)) {
    const auto text = [write](const Table& self, const std::string& prefix, const std::string& unit, double scale,
                              const std::vector<std::string>& provenance) {
      return write(self, {.name = prefix, .unit = unit, .scale = scale, .provenance = provenance});
    };
    def(table, name, {"name", "unit", "scale", "provenance"}, text);
  };
  bind("c_header", c_header);
  bind("rust_module", rust_module);
  bind("js_module", js_module);
}

inline Beyond to_beyond(const std::string& name) {
  return name == "law" ? Beyond::law : name == "clamp" ? Beyond::clamp : Beyond::error;
}

}  // namespace stoss::python

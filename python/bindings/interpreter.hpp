#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "stoss/poll.hpp"

namespace stoss::python {

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
  handle.def("__reduce_ex__", [](const pybind11::object& self, int) -> pybind11::object {
    throw pybind11::type_error("cannot pickle '" + std::string(pybind11::str(pybind11::type::of(self))) + "'");
  });
}

}  // namespace stoss::python

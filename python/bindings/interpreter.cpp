#include "interpreter.hpp"

#include <chrono>

namespace stoss::python {

namespace py = pybind11;

Poll signal_poll() {
  const py::module_ threading = py::module_::import("threading");
  const py::object here = threading.attr("get_ident")(), main = threading.attr("main_thread")().attr("ident");
  if (!here.equal(main)) return {};
  return [last = std::chrono::steady_clock::now()]() mutable {
    constexpr auto patience = std::chrono::milliseconds(50);
    const auto now = std::chrono::steady_clock::now();
    if (now - last < patience) return;
    last = now;
    const py::gil_scoped_acquire interpreter;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  };
}

}  // namespace stoss::python

// The core's exceptions become those of stoss._errors.
#include "stoss/errors.hpp"

#include "bindings.hpp"

namespace stoss::python {
namespace {

void raise(const char* name, const char* what) {
  const py::object type = py::module_::import("stoss._errors").attr(name);
  PyErr_SetString(type.ptr(), what);
}

}  // namespace

void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const InvalidInput& refusal) {
      raise("InvalidInput", refusal.what());
    } catch (const NotConverged& failure) {
      raise("NotConverged", failure.what());
    }
  });
}

}  // namespace stoss::python

#include "stoss/restitution/restitution.hpp"

#include <pybind11/stl.h>

#include <optional>
#include <string>

#include "arrays.hpp"
#include "bindings.hpp"
#include "interpreter.hpp"
#include "quantities.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/restitution/quantities.hpp"
#include "vibration.hpp"

namespace stoss::python {
namespace {

/// Fills rows as the values come, and `reasons` at the end, so that what is done is there if Ctrl-C ends the curve.
/// Only where there is a `tick` is the interpreter asked for after each value.
void curve(const RefinableContact& contact, const py::array_t<double, py::array::c_style>& speeds, double tolerance,
           double absolute, int threads, const Oscillations& state, py::array& rows, py::list reasons,
           const std::optional<py::function>& tick) {
  const std::vector<double> at = to_vector(speeds);
  const Rows<Restitution> layout(restitution_quantities());
  const bool fits = rows.ndim() == 1 && (rows.flags() & py::array::c_style) != 0 && rows.dtype().equal(layout.type());
  if (!fits || rows.size() != speeds.size()) throw std::invalid_argument("rows: one restitution_row for each speed");
  auto* const row = static_cast<std::byte*>(rows.mutable_data());
  const CurveOptions options{
      .each = {.tolerance = tolerance, .absolute = absolute, .poll = signal_poll(), .vibration = to_vibration(state)},
      .threads = threads};
  std::vector<std::string> why;
  const auto hand_over = [&] {
    for (const std::string& reason : why) reasons.append(reason);
  };
  try {
    const Released released;
    restitution_curve(contact, at, options, [&](std::size_t i, const Restitution& result) {
      layout.write(result, row + i * layout.width());
      why.push_back(result.reason);
      if (!tick) return;
      const py::gil_scoped_acquire interpreter;
      (*tick)();
    });
  } catch (const py::error_already_set&) {
    hand_over();
    throw;
  }
  hand_over();
}

}  // namespace

void bind_restitution(py::module_& module) {
  module.attr("restitution_row") = Rows<Restitution>(restitution_quantities()).type();
  module.def(
      "check_curve",
      [](const py::array_t<double, py::array::c_style>& speeds, double tolerance, double absolute, int threads) {
        validate(to_vector(speeds), {tolerance, absolute, threads});
      },
      py::arg("speeds"), py::arg("tolerance"), py::arg("absolute"), py::arg("threads"));
  module.def("restitution_curve", &curve, py::arg("contact"), py::arg("speeds"), py::arg("tolerance"),
             py::arg("absolute"), py::arg("threads"), py::arg("state"), py::arg("rows").noconvert(), py::arg("reasons"),
             py::arg("tick"), "fills rows and reasons; calls tick, unless it is None, after each");
}

}  // namespace stoss::python

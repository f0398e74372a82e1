#include "stoss/impact/replay.hpp"

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "interpreter.hpp"
#include "quantities.hpp"
#include "stoss/impact/quantities.hpp"
#include "vibration.hpp"

namespace stoss::python {
namespace {

/// The quantities of an impact with what it was made with, for the fields of stoss.Impact.
py::dict numbers(const Impact& impact) {
  py::dict numbers = to_dict(impact_quantities(), impact);
  numbers["speed"] = impact.speed;
  return numbers;
}

/// The instants of a repetition of an impact, every so many steps.
Rows<Snapshot> trajectory(const Contact& contact, const Impact& impact, int every, const Poll& poll) {
  Rows<Snapshot> instants(snapshot_quantities());
  const ImpactObserver observer = [&](const Snapshot& now) { instants.add(now); };
  const ImpactOptions options{.resolution = Resolution(impact.resolution), .start = impact.start, .poll = poll};
  (void)stoss::impact(contact, impact.speed, options, {.observer = observer, .every = every});
  return instants;
}

}  // namespace

void bind_impact(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(Oscillation, body, order, index, energy, phase);
  module.attr("oscillation") = py::dtype::of<Oscillation>();
  PYBIND11_NUMPY_DTYPE(ModeEnergy, body, order, index, omega, before, after, average);
  py::class_<Impact> handle(module, "Impact", "One impact, from which its trajectory can be repeated.");
  seal(handle);
  handle.def("numbers", &numbers)
      .def("modes", [](const py::object& self) { return view(self.cast<const Impact&>().energy.modes, self); })
      .def(
          "trajectory",
          [](const Impact& impact, const Contact& contact, int every) {
            const auto poll = signal_poll();
            Rows<Snapshot> instants(snapshot_quantities());
            {
              const Released released;
              instants = trajectory(contact, impact, every, poll);
            }
            return instants.take();
          },
          py::arg("contact"), py::arg("every"))
      .def(
          "vibration_after",
          [](const Impact& impact, const Contact& contact, double flight) {
            return take(vibration_after(contact, impact.final_state, flight));
          },
          py::arg("contact"), py::arg("flight"));
  module.def(
      "impact",
      [](const Contact& contact, bool radiating, double speed, std::optional<double> step, std::optional<int> nodes,
         std::optional<double> half_width, const Oscillations& state) {
        const Tail tail = radiating ? Tail::radiating : Tail::quasistatic;
        ImpactOptions options{.resolution = {step, nodes, half_width, tail}, .poll = signal_poll()};
        if (state.size() > 0) options.start = approach(contact, speed, to_vibration(state));
        const Released released;
        return impact(contact, speed, options);
      },
      py::arg("contact"), py::arg("radiating"), py::arg("speed"), py::arg("step"), py::arg("nodes"),
      py::arg("half_width"), py::arg("state"));
}

}  // namespace stoss::python

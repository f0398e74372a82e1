#include "stoss/impact/replay.hpp"

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "interpreter.hpp"

namespace stoss::python {
namespace {

/// A Snapshot without its views.
struct Instant {
  double time, center, velocity, force, translation, vibration, stored, unresolved, contact_half_width;
};

/// The numbers of an impact and its modes' energies, for the fields of stoss.Impact.
py::dict numbers(const Impact& impact) {
  using namespace py::literals;
  return py::dict("speed"_a = impact.speed, "restitution"_a = impact.restitution,
                  "lost_fraction"_a = impact.lost_fraction, "translation"_a = impact.energy.translation,
                  "vibration"_a = impact.energy.vibration, "unresolved"_a = impact.energy.unresolved,
                  "lost_to_first"_a = impact.energy.lost_to_first, "lost_to_second"_a = impact.energy.lost_to_second,
                  "contact_time"_a = impact.contact_time, "contacts"_a = impact.contacts,
                  "max_force"_a = impact.max_force, "max_compression"_a = impact.max_compression,
                  "max_half_width"_a = impact.max_half_width, "cutoff"_a = impact.cutoff, "step"_a = impact.step,
                  "nodes"_a = impact.nodes, "half_width"_a = impact.half_width, "steps"_a = impact.steps,
                  "energy_error"_a = impact.energy_error, "momentum_error"_a = impact.momentum_error,
                  "beyond_small_strain"_a = impact.beyond_small_strain);
}

/// The instants of a repetition of an impact, every so many steps.
std::vector<Instant> trajectory(const Contact& contact, const Impact& impact, int every, const Poll& poll) {
  std::vector<Instant> instants;
  const ImpactObserver observer = [&](const Snapshot& now) {
    instants.push_back({now.time, now.center, now.velocity, now.force, now.translation, now.vibration, now.stored,
                        now.unresolved, now.contact_half_width});
  };
  const ImpactOptions options{.resolution = repetition(contact, impact), .poll = poll};
  (void)stoss::impact(contact, impact.speed, options, {.observer = observer, .every = every});
  return instants;
}

}  // namespace

void bind_impact(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(ModeEnergy, body, order, index, omega, after, average);
  PYBIND11_NUMPY_DTYPE(Instant, time, center, velocity, force, translation, vibration, stored, unresolved,
                       contact_half_width);
  py::class_<Impact> handle(module, "Impact", "One impact, from which its trajectory can be repeated.");
  seal(handle);
  handle.def("numbers", &numbers)
      .def("modes", [](const py::object& self) { return view(self.cast<const Impact&>().energy.modes, self); })
      .def(
          "trajectory",
          [](const Impact& impact, const Contact& contact, int every) {
            const auto poll = signal_poll();
            std::vector<Instant> instants;
            {
              const Released released;
              instants = trajectory(contact, impact, every, poll);
            }
            return take(std::move(instants));
          },
          py::arg("contact"), py::arg("every"));
  module.def(
      "impact",
      [](const Contact& contact, bool radiating, double speed, std::optional<double> step, std::optional<int> nodes,
         std::optional<double> half_width) {
        const Tail tail = radiating ? Tail::radiating : Tail::quasistatic;
        const ImpactOptions options{.resolution = {step, nodes, half_width, tail}, .poll = signal_poll()};
        const Released released;
        return impact(contact, speed, options);
      },
      py::arg("contact"), py::arg("radiating"), py::arg("speed"), py::arg("step"), py::arg("nodes"),
      py::arg("half_width"));
}

}  // namespace stoss::python

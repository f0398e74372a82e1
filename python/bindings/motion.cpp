#include "stoss/contact/grid.hpp"
#include "stoss/impact/replay.hpp"

#include <cmath>

#include "arrays.hpp"
#include "frames.hpp"
#include "interpreter.hpp"

namespace stoss::python {
namespace {

/// A Frame without what belongs to modes and nodes.
struct FrameSummary {
  double time, center, velocity, force, contact_half_width;
};

std::vector<FrameSummary> summaries(const Frames& frames) {
  std::vector<FrameSummary> list;
  list.reserve(frames.all.size());
  for (const Frame& frame : frames.all) {
    list.push_back({frame.time, frame.state.center, frame.state.velocity, frame.force, frame.contact_half_width});
  }
  return list;
}

/// Energy of one mode at some time, as a share of the initial energy.
struct EnergyAt {
  int body, order, index;
  double omega, energy;
};

/// Times × modes.
std::vector<EnergyAt> energies_at(const Contact& contact, const Impact& impact, const std::vector<double>& times,
                                  const Poll& poll) {
  double initial = 0.5 * contact.mass * impact.speed * impact.speed;
  if (impact.start) {
    for (const double energy : mode_energies(contact, *impact.start)) initial += energy;
  }
  std::vector<EnergyAt> list;
  list.reserve(times.size() * impact.energy.modes.size());
  for (const Frame& frame : motion(contact, impact, times, poll)) {
    if (poll) poll();
    const std::vector<double> energies = mode_energies(contact, frame.state);
    for (std::size_t k = 0; k < energies.size(); ++k) {
      const ModeEnergy& mode = impact.energy.modes[k];
      list.push_back({mode.body, mode.order, mode.index, mode.omega, energies[k] / initial});
    }
  }
  return list;
}

/// Lateral distances and, for each instant, places of the surface of the second body, a half-space, in R.
struct Surfaces {
  std::vector<double> lateral, place;
};

Surfaces surfaces(const Contact& contact, const Impact& impact, const Frames& frames, double reach, std::size_t count,
                  const Poll& poll) {
  const ContactGrid grid = contact_grid(contact, impact.resolution.half_width, impact.resolution.nodes);
  Surfaces all;
  // On a circle so large that they are evenly spaced.
  constexpr double flat = 1e4;
  const ContactPoints even{flat * reach, 1.0 / (flat * static_cast<double>(count)), count};
  for (std::size_t i = 0; i < count; ++i) all.lateral.push_back(even.radius * std::sin(even.angle(i)));
  for (const Frame& frame : frames.all) {
    if (poll) poll();
    const BodyFrame seen = seen_by(contact, grid, frame, 1);
    ContactPoints own = even;
    own.radius /= seen.length;
    for (const double each : surface_displacement(seen, own)) all.place.push_back(seen.center - each * seen.length);
  }
  return all;
}

}  // namespace

void bind_motion(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(FrameSummary, time, center, velocity, force, contact_half_width);
  PYBIND11_NUMPY_DTYPE(EnergyAt, body, order, index, omega, energy);
  py::class_<Frames> handle(module, "Frames", "An impact at some times, with the motion of all modes.");
  seal(handle);
  handle.def("summaries", [](const Frames& frames) { return take(summaries(frames)); });
  module.def(
      "motion",
      [](const Contact& contact, const Impact& impact, const py::array_t<double, py::array::c_style>& times) {
        const std::vector<double> at = to_vector(times);
        const auto poll = signal_poll();
        const Released released;
        return Frames{motion(contact, impact, at, poll)};
      },
      py::arg("contact"), py::arg("impact"), py::arg("times"));
  module.def(
      "surfaces",
      [](const Contact& contact, const Impact& impact, const Frames& frames, double reach, std::size_t count) {
        const auto poll = signal_poll();
        Surfaces all;
        {
          const Released released;
          all = surfaces(contact, impact, frames, reach, count, poll);
        }
        const auto instants = static_cast<py::ssize_t>(frames.all.size());
        return py::make_tuple(take(std::move(all.lateral)),
                              take(std::move(all.place), {instants, static_cast<py::ssize_t>(count)}));
      },
      py::arg("contact"), py::arg("impact"), py::arg("frames"), py::arg("reach"), py::arg("count"),
      "lateral distances, and times x places of the surface of a half-space");
  module.def(
      "energies_at",
      [](const Contact& contact, const Impact& impact, const py::array_t<double, py::array::c_style>& times) {
        const std::vector<double> at = to_vector(times);
        const auto poll = signal_poll();
        std::vector<EnergyAt> energies;
        {
          const Released released;
          energies = energies_at(contact, impact, at, poll);
        }
        const auto modes = static_cast<py::ssize_t>(impact.energy.modes.size());
        return take(std::move(energies), {times.size(), modes});
      },
      py::arg("contact"), py::arg("impact"), py::arg("times"), "structured array, times x modes");
}

}  // namespace stoss::python

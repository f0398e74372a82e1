#include "stoss/quasistatic.hpp"

#include <pybind11/stl.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include "bindings.hpp"
#include "elementwise.hpp"
#include "interpreter.hpp"
#include "quantities.hpp"
#include "stoss/quasistatic/quantities.hpp"
#include "wall.hpp"

namespace stoss::python {

using namespace quasistatic;

template <>
CompressionLaw to_law(const std::string& name) {
  if (name == "center") return CompressionLaw::center;
  if (name == "diameter") return CompressionLaw::diameter;
  if (name == "printed") return CompressionLaw::printed;
  throw std::invalid_argument("law: center, diameter or printed");
}

namespace {

py::array slow_impacts(const std::string& law, const Doubles& poisson, const Doubles& speeds) {
  const CompressionLaw chosen = to_law<CompressionLaw>(law);
  if (poisson.size() != speeds.size()) throw std::invalid_argument("arrays: all of one size");
  const std::vector<double> nu = to_vector(poisson), at = to_vector(speeds);
  Rows<SlowImpact> rows(slow_impact_quantities());
  const Poll poll = signal_poll();
  {
    const Released released;
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (poll) poll();
      rows.add(slow_impact(chosen, nu[i], at[i]));
    }
  }
  return rows.take();
}

/// Estimates for several speeds, and, if there is only one, its modes.
py::tuple rayleigh_rows(const std::string& law, double poisson, const Doubles& speeds, double cutoff) {
  const CompressionLaw chosen = to_law<CompressionLaw>(law);
  const std::vector<double> at = to_vector(speeds);
  Rows<RayleighEstimate> rows(rayleigh_quantities());
  std::vector<DrivenMode> driven;
  const Poll poll = signal_poll();
  {
    const Released released;
    const std::vector<bodies::disk::Mode> modes = bodies::disk::modes(poisson, cutoff, poll);
    for (const double speed : at) {
      RayleighEstimate estimate = rayleigh(chosen, poisson, speed, modes, poll);
      rows.add(estimate);
      if (at.size() == 1) driven = std::move(estimate.modes);
    }
  }
  return py::make_tuple(rows.take(), take(std::move(driven)));
}

/// Of a disk, or of a sphere.
template <typename Pressed>
py::dict static_contact_numbers(const Pressed& body, double compression, int nodes) {
  using namespace py::literals;
  StaticContact contact;
  const Poll poll = signal_poll();
  {
    const Released released;
    contact = static_contact(body, compression, {nodes, poll});
  }
  return py::dict("force"_a = contact.force, "force_error"_a = contact.force_error, "half_width"_a = contact.half_width,
                  "energy"_a = contact.energy, "contact_nodes"_a = contact.contact_nodes, "spacing"_a = contact.spacing,
                  "position"_a = take(std::move(contact.position)), "pressure"_a = take(std::move(contact.pressure)));
}

py::dict soft_static_contact_numbers(const Body& body, const AnyWall& wall, double compression,
                                     std::optional<int> nodes) {
  const auto* soft = std::get_if<ExponentialWall>(&wall.wall);
  if (soft == nullptr) throw std::invalid_argument("wall: an exponential one");
  SoftStaticContact contact;
  const Poll poll = signal_poll();
  {
    const Released released;
    contact = soft_static_contact(body, *soft, compression, {nodes, poll});
  }
  return to_dict(soft_static_contact_quantities(), contact);
}

void bind_stresses(py::module_& module) {
  module.def(
      "hertz_pressure",
      [](const Doubles& force, const Doubles& y) {
        const double *f = force.data(), *along = y.data();
        return over([&](std::size_t i) { return hertz_pressure(f[i], along[i]); }, force, y);
      },
      py::arg("force"), py::arg("y"));
  module.def(
      "hertz_stress",
      [](const Doubles& force, const Doubles& depth, const Doubles& y) {
        const double *f = force.data(), *down = depth.data(), *along = y.data();
        return over([&](std::size_t i) { return hertz_stress(f[i], down[i], along[i]); }, force, depth, y);
      },
      py::arg("force"), py::arg("depth"), py::arg("y"), "structured array of xx, yy, xy");
  module.def(
      "heavy_disk_stress",
      [](bool hertz, const Doubles& force, const Doubles& x, const Doubles& y) {
        const HeavyDiskContact contact = hertz ? HeavyDiskContact::hertz : HeavyDiskContact::point;
        const double *f = force.data(), *up = x.data(), *along = y.data();
        return over([&](std::size_t i) { return heavy_disk_stress(contact, f[i], up[i], along[i]); }, force, x, y);
      },
      py::arg("hertz"), py::arg("force"), py::arg("x"), py::arg("y"), "structured array of xx, yy, xy");
}

}  // namespace

void bind_quasistatic(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(DrivenMode, order, index, omega, amplitude, after);
  PYBIND11_NUMPY_DTYPE(PlaneStress, xx, yy, xy);
  module.attr("rayleigh_row") = Rows<RayleighEstimate>(rayleigh_quantities()).type();
  module.def("limit_force", over_law<CompressionLaw>(&limit_force), py::arg("law"), py::arg("poisson"));
  module.def("limit_speed", over_law<CompressionLaw>(&limit_speed), py::arg("law"), py::arg("poisson"));
  module.def("compression", over_law<CompressionLaw>(&compression), py::arg("law"), py::arg("poisson"),
             py::arg("force"));
  module.def("compression_force", over_law<CompressionLaw>(&compression_force), py::arg("law"), py::arg("poisson"),
             py::arg("compression"));
  module.def("compression_energy", over_law<CompressionLaw>(&compression_energy), py::arg("law"), py::arg("poisson"),
             py::arg("force"));
  module.def("slow_impact", &slow_impacts, py::arg("law"), py::arg("poisson"), py::arg("speed"),
             "structured array of its quantities");
  module.def("rayleigh", &rayleigh_rows, py::arg("law"), py::arg("poisson"), py::arg("speeds"), py::arg("cutoff"),
             "rows for the speeds, and the modes if there is only one speed");
  module.def("static_contact", &static_contact_numbers<double>, py::arg("poisson"), py::arg("compression"),
             py::arg("nodes"));
  module.def(
      "point_static_contact",
      [](double poisson, double compression, int nodes) {
        return static_contact_numbers(Sphere{.poisson = poisson}, compression, nodes);
      },
      py::arg("poisson"), py::arg("compression"), py::arg("nodes"));
  module.def("soft_static_contact", &soft_static_contact_numbers, py::arg("body"), py::arg("wall"),
             py::arg("compression"), py::arg("nodes"));
  bind_stresses(module);
}

}  // namespace stoss::python

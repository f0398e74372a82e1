// Slow contacts at a point: of spheres.
#include <pybind11/stl.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "elementwise.hpp"
#include "interpreter.hpp"
#include "quantities.hpp"
#include "stoss/quasistatic.hpp"
#include "stoss/quasistatic/quantities.hpp"

namespace stoss::python {

using namespace quasistatic;

template <>
PointLaw to_law(const std::string& name) {
  if (name == "center") return PointLaw::center;
  if (name == "hertz") return PointLaw::hertz;
  throw std::invalid_argument("law: center or hertz");
}

namespace {

/// Quantities of what `make` gives for each of several speeds.
template <typename Result, typename Make>
py::array rows_of(const Quantities<Result>& quantities, const Doubles& speeds, Make make) {
  Rows<Result> rows(quantities);
  const std::vector<double> at = to_vector(speeds);
  const Poll poll = signal_poll();
  {
    const Released released;
    for (const double speed : at) {
      if (poll) poll();
      rows.add(make(speed, poll));
    }
  }
  return rows.take();
}

py::array point_slow_impacts(const std::string& law, double poisson, const Doubles& speeds) {
  const PointLaw chosen = to_law<PointLaw>(law);
  return rows_of(point_slow_impact_quantities(), speeds,
                 [&](double speed, const Poll&) { return slow_impact(chosen, poisson, speed); });
}

/// Estimates for several speeds, and, if there is only one, its modes.
py::tuple point_rayleigh_rows(const std::string& law, double poisson, const Doubles& speeds, double cutoff) {
  const PointLaw chosen = to_law<PointLaw>(law);
  std::vector<bodies::sphere::Mode> modes;
  const Poll poll = signal_poll();
  {
    const Released released;
    modes = bodies::sphere::modes(poisson, cutoff, poll);
  }
  std::vector<DrivenMode> driven;
  const py::array rows = rows_of(point_rayleigh_quantities(), speeds, [&](double speed, const Poll& interrupted) {
    PointRayleighEstimate estimate = rayleigh(chosen, poisson, speed, modes, interrupted);
    if (speeds.size() == 1) driven = estimate.modes;
    return estimate;
  });
  return py::make_tuple(rows, take(std::move(driven)));
}

/// Hertz' contact of a sphere at a hard wall, of a force in mc²/R.
PointHertz at_wall(double poisson, double force) {
  const double radius = contact_radius(PointLaw::hertz, poisson, force);
  return point_hertz_of_approach({1.0, 1.0 - poisson * poisson}, radius * radius);
}

void bind_hertz(py::module_& module) {
  module.def(
      "point_hertz_pressure",
      [](double poisson, const Doubles& force, const Doubles& distance) {
        const double *f = force.data(), *r = distance.data();
        return over([&](std::size_t i) { return point_hertz_pressure(at_wall(poisson, f[i]), r[i]); }, force, distance);
      },
      py::arg("poisson"), py::arg("force"), py::arg("distance"));
  module.def(
      "point_hertz_stress",
      [](double poisson, const Doubles& force, const Doubles& depth, const Doubles& distance) {
        const double *f = force.data(), *z = depth.data(), *r = distance.data();
        return over([&](std::size_t i) { return point_hertz_stress(at_wall(poisson, f[i]), poisson, z[i], r[i]); },
                    force, depth, distance);
      },
      py::arg("poisson"), py::arg("force"), py::arg("depth"), py::arg("distance"),
      "structured array of radial, hoop, axial, shear");
  module.def(
      "greatest_shear",
      [](double poisson, const Doubles& force) {
        const double* f = force.data();
        return over([&](std::size_t i) { return greatest_shear(at_wall(poisson, f[i]), poisson); }, force);
      },
      py::arg("poisson"), py::arg("force"), "structured array of depth, shear");
}

/// A sphere in SI, for yield_speed: young, poisson, density, yield strength, radius.
using InSi = std::tuple<double, double, double, std::optional<double>, double>;

Material material(const InSi& sphere) {
  return {std::get<0>(sphere), std::get<1>(sphere), std::get<2>(sphere), std::get<3>(sphere)};
}

}  // namespace

void bind_point_quasistatic(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(AxisymmetricStress, radial, hoop, axial, shear);
  PYBIND11_NUMPY_DTYPE(GreatestShear, depth, shear);
  const auto law = py::arg("law"), poisson = py::arg("poisson"), force = py::arg("force");
  module.def("point_limit_force", over_law<PointLaw>(&limit_force), law, poisson);
  module.def("point_limit_speed", over_law<PointLaw>(&limit_speed), law, poisson);
  module.def("point_compression", over_law<PointLaw>(&compression), law, poisson, force);
  module.def("point_compression_force", over_law<PointLaw>(&compression_force), law, poisson, py::arg("compression"));
  module.def("point_compression_energy", over_law<PointLaw>(&compression_energy), law, poisson, force);
  module.def("contact_radius", over_law<PointLaw>(&contact_radius), law, poisson, force);
  module.def("point_slow_impact", &point_slow_impacts, law, poisson, py::arg("speeds"),
             "structured array of its quantities");
  module.def("point_rayleigh", &point_rayleigh_rows, law, poisson, py::arg("speeds"), py::arg("cutoff"),
             "rows for the speeds, and the modes if there is only one speed");
  module.def(
      "yield_speed",
      [](const InSi& first, const std::optional<InSi>& second) {
        if (!second) return yield_speed(material(first), std::get<4>(first));
        return yield_speed(material(first), std::get<4>(first), material(*second), std::get<4>(*second));
      },
      py::arg("first"), py::arg("second"), "of spheres (young, poisson, density, yield strength, radius) in SI");
  bind_hertz(module);
}

}  // namespace stoss::python

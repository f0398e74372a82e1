// Slow contacts along a line, of disks, and at a point, of spheres.
#include "stoss/quasistatic.hpp"

#include "rows.hpp"
#include "stoss/quasistatic/quantities.hpp"
#include "support.hpp"

namespace stoss::python {

using namespace quasistatic;

template <>
CompressionLaw to_law(const std::string& name) {
  if (name == "center") return CompressionLaw::center;
  if (name == "diameter") return CompressionLaw::diameter;
  throw std::invalid_argument("law: center or diameter");
}

template <>
PointLaw to_law(const std::string& name) {
  if (name == "center") return PointLaw::center;
  if (name == "hertz") return PointLaw::hertz;
  throw std::invalid_argument("law: center or hertz");
}

namespace {

/// The functions of a law of compression.
template <typename Law>
void bind_law(py::module_& module, const std::string& prefix) {
  const auto law = py::arg("law"), poisson = py::arg("poisson"), force = py::arg("force");
  const auto def = [&](const char* name, const auto& function, const auto&... arguments) {
    module.def((prefix + name).c_str(), function, arguments...);
  };
  def("limit_force", over_law<Law>(&limit_force), law, poisson);
  def("limit_speed", over_law<Law>(&limit_speed), law, poisson);
  def("compression", over_law<Law>(&compression), law, poisson, force);
  def("compression_force", over_law<Law>(&compression_force), law, poisson, py::arg("compression"));
  def("compression_energy", over_law<Law>(&compression_energy), law, poisson, force);
}

/// Slow impacts of several Poisson's ratios and speeds.
template <typename Law, typename Result>
auto slow_impacts(const Quantities<Result>& quantities) {
  return [&quantities](const std::string& law, const Doubles& poisson, const Doubles& speeds) {
    const Law chosen = to_law<Law>(law);
    if (poisson.size() != speeds.size()) throw std::invalid_argument("arrays: all of one size");
    const std::vector<double> nu = to_vector(poisson), at = to_vector(speeds);
    auto made = computed([&](const Poll& poll) {
      Rows<Result> rows(quantities);
      for (std::size_t i = 0; i < at.size(); ++i) {
        if (poll) poll();
        rows.add(slow_impact(chosen, nu[i], at[i]));
      }
      return rows;
    });
    return made.take();
  };
}

/// Estimates for several speeds, and, if there is only one, its modes.
template <typename Law, typename Mode, typename Result>
auto estimates(const Quantities<Result>& quantities, std::vector<Mode> (*modes)(double, double, const Poll&)) {
  return [&quantities, modes](const std::string& law, double poisson, const Doubles& speeds, double cutoff) {
    const Law chosen = to_law<Law>(law);
    const std::vector<double> at = to_vector(speeds);
    std::vector<DrivenMode> driven;
    auto made = computed([&](const Poll& poll) {
      Rows<Result> rows(quantities);
      const std::vector<Mode> all = modes(poisson, cutoff, poll);
      for (const double speed : at) {
        if (poll) poll();
        Result estimate = rayleigh(chosen, poisson, speed, all, poll);
        rows.add(estimate);
        if (at.size() == 1) driven = std::move(estimate.modes);
      }
      return rows;
    });
    return py::make_tuple(made.take(), take(std::move(driven)));
  };
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

/// Stress and pressure below contacts, and what is pushed along a wall.
void bind_statics(py::module_& module) {
  const auto poisson = py::arg("poisson"), force = py::arg("force"), depth = py::arg("depth");
  module.def(
      "point_hertz_pressure",
      [](double nu, const Doubles& forces, const Doubles& distances) {
        return over([&](double f, double r) { return point_hertz_pressure(point_hertz_at_wall(nu, f), r); }, forces,
                    distances);
      },
      poisson, force, py::arg("distance"));
  module.def(
      "point_hertz_stress",
      [](double nu, const Doubles& forces, const Doubles& depths, const Doubles& distances) {
        return over(
            [&](double f, double z, double r) { return point_hertz_stress(point_hertz_at_wall(nu, f), nu, z, r); },
            forces, depths, distances);
      },
      poisson, force, depth, py::arg("distance"), "structured array of radial, hoop, axial, shear");
  module.def(
      "greatest_shear",
      [](double nu, const Doubles& forces) {
        return over([&](double f) { return greatest_shear(point_hertz_at_wall(nu, f), nu); }, forces);
      },
      poisson, force, "structured array of depth, shear");
  module.def(
      "maw",
      [](const Doubles& psi1, const Doubles& chi, double tolerance) {
        return over([&](double psi, double at) { return maw(psi, at, tolerance); }, psi1, chi);
      },
      py::arg("psi1"), py::arg("chi"), py::arg("tolerance"), "structured array of what Maw's impact leaves");
  bind_over(
      module, "hertz_pressure", [](double f, double y) { return hertz_pressure(f, y); }, "force", "y");
  bind_over(
      module, "hertz_stress", [](double f, double x, double y) { return hertz_stress(f, x, y); }, "force", "depth",
      "y");
  bind_over(module, "mindlin_ratio", &mindlin_ratio, "poisson");
  bind_over(module, "mindlin_force", &mindlin_force, "displacement");
  bind_over(module, "mindlin_displacement", &mindlin_displacement, "tangential");
  bind_over(module, "mindlin_stick_radius", &mindlin_stick_radius, "tangential");
  bind_over(module, "mindlin_traction", &mindlin_traction, "tangential", "distance");
}

}  // namespace

void bind_quasistatic(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(DrivenMode, order, index, omega, amplitude, after);
  PYBIND11_NUMPY_DTYPE(PlaneStress, xx, yy, xy);
  PYBIND11_NUMPY_DTYPE(AxisymmetricStress, radial, hoop, axial, shear);
  PYBIND11_NUMPY_DTYPE(GreatestShear, depth, shear);
  PYBIND11_NUMPY_DTYPE(MawImpact, psi2, psi2_error, impulse, impulse_error, friction_loss, sliding, sticking, slipping,
                       reversed);
  module.attr("rayleigh_row") = Rows<RayleighEstimate>(rayleigh_quantities()).type();
  module.attr("point_rayleigh_row") = Rows<PointRayleighEstimate>(point_rayleigh_quantities()).type();
  const auto law = py::arg("law"), poisson = py::arg("poisson"), speeds = py::arg("speeds");
  bind_law<CompressionLaw>(module, "");
  bind_law<PointLaw>(module, "point_");
  module.def("contact_radius", over_law<PointLaw>(&contact_radius), law, poisson, py::arg("force"));
  constexpr const char* rows = "structured array of its quantities";
  module.def("slow_impact", slow_impacts<CompressionLaw>(slow_impact_quantities()), law, poisson, speeds, rows);
  module.def("point_slow_impact", slow_impacts<PointLaw>(point_slow_impact_quantities()), law, poisson, speeds, rows);
  constexpr const char* both = "rows for the speeds, and the modes if there is only one speed";
  module.def("rayleigh", estimates<CompressionLaw>(rayleigh_quantities(), &bodies::disk::modes), law, poisson, speeds,
             py::arg("cutoff"), both);
  module.def("point_rayleigh", estimates<PointLaw>(point_rayleigh_quantities(), &bodies::sphere::modes), law, poisson,
             speeds, py::arg("cutoff"), both);
  module.def("static_contact", &static_contact_numbers<double>, poisson, py::arg("compression"), py::arg("nodes"));
  module.def(
      "point_static_contact",
      [](double nu, double compression, int nodes) {
        return static_contact_numbers(Sphere{.poisson = nu}, compression, nodes);
      },
      poisson, py::arg("compression"), py::arg("nodes"));
  bind_statics(module);
}

}  // namespace stoss::python

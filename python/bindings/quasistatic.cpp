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
  const auto name = [&](const char* own) { return prefix + own; };
  def(module, name("limit_force").c_str(), {"law", "poisson"}, over_law<Law>(&limit_force));
  def(module, name("limit_speed").c_str(), {"law", "poisson"}, over_law<Law>(&limit_speed));
  def(module, name("compression").c_str(), {"law", "poisson", "force"}, over_law<Law>(&compression));
  def(module, name("compression_force").c_str(), {"law", "poisson", "compression"}, over_law<Law>(&compression_force));
  def(module, name("compression_energy").c_str(), {"law", "poisson", "force"}, over_law<Law>(&compression_energy));
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
  def(module, "point_hertz_pressure", {"poisson", "force", "distance"},
      [](double nu, const Doubles& forces, const Doubles& distances) {
        return over([&](double f, double r) { return point_hertz_pressure(point_hertz_at_wall(nu, f), r); }, forces,
                    distances);
      });
  def(module, "point_hertz_stress", {"poisson", "force", "depth", "distance"},
      [](double nu, const Doubles& forces, const Doubles& depths, const Doubles& distances) {
        return over(
            [&](double f, double z, double r) { return point_hertz_stress(point_hertz_at_wall(nu, f), nu, z, r); },
            forces, depths, distances);
      });
  def(module, "greatest_shear", {"poisson", "force"}, [](double nu, const Doubles& forces) {
    return over([&](double f) { return greatest_shear(point_hertz_at_wall(nu, f), nu); }, forces);
  });
  def(module, "maw", {"psi1", "chi", "tolerance"}, [](const Doubles& psi1, const Doubles& chi, double tolerance) {
    return over([&](double psi, double at) { return maw(psi, at, tolerance); }, psi1, chi);
  });
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
  bind_law<CompressionLaw>(module, "");
  bind_law<PointLaw>(module, "point_");
  def(module, "contact_radius", {"law", "poisson", "force"}, over_law<PointLaw>(&contact_radius));
  def(module, "slow_impact", {"law", "poisson", "speeds"}, slow_impacts<CompressionLaw>(slow_impact_quantities()));
  def(module, "point_slow_impact", {"law", "poisson", "speeds"},
      slow_impacts<PointLaw>(point_slow_impact_quantities()));
  def(module, "rayleigh", {"law", "poisson", "speeds", "cutoff"},
      estimates<CompressionLaw>(rayleigh_quantities(), &bodies::disk::modes));
  def(module, "point_rayleigh", {"law", "poisson", "speeds", "cutoff"},
      estimates<PointLaw>(point_rayleigh_quantities(), &bodies::sphere::modes));
  def(module, "static_contact", {"poisson", "compression", "nodes"}, &static_contact_numbers<double>);
  def(module, "point_static_contact", {"poisson", "compression", "nodes"},
      [](double nu, double compression, int nodes) {
        return static_contact_numbers(Sphere{.poisson = nu}, compression, nodes);
      });
  bind_statics(module);
}

}  // namespace stoss::python

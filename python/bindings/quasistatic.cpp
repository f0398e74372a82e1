// Slow contacts along a line, of disks, and at a point, of spheres.
#include "stoss/quasistatic.hpp"

#include "rows.hpp"
#include "stoss/quasistatic/quantities.hpp"
#include "support.hpp"

namespace stoss::python {

using namespace quasistatic;

namespace {

/// The static law of a name, of disks or of spheres. @throws std::invalid_argument for another name
StaticLaw law_of(bool sphere, const std::string& name) {
  if (sphere && name == "center") return PointLaw::center;
  if (sphere && name == "hertz") return PointLaw::hertz;
  if (sphere) throw std::invalid_argument("law: center or hertz");
  if (name == "center") return CompressionLaw::center;
  if (name == "diameter") return CompressionLaw::diameter;
  throw std::invalid_argument("law: center or diameter");
}

/// A function of law, Poisson's ratio and another number, over arrays of both.
auto over_law(bool sphere, double (*function)(StaticLaw, double, double)) {
  return [=](const std::string& law, const Doubles& poisson, const Doubles& argument) {
    return over([=, chosen = law_of(sphere, law)](double nu, double x) { return function(chosen, nu, x); }, poisson,
                argument);
  };
}

/// The same of law and Poisson's ratio alone.
auto over_law(bool sphere, double (*function)(StaticLaw, double)) {
  return [=](const std::string& law, const Doubles& poisson) {
    return over([=, chosen = law_of(sphere, law)](double nu) { return function(chosen, nu); }, poisson);
  };
}

/// Slow impacts of several Poisson's ratios and speeds.
auto slow_impacts(bool sphere, const Quantities<SlowImpact>& quantities) {
  return [sphere, &quantities](const std::string& law, const Doubles& poisson, const Doubles& speeds) {
    const StaticLaw chosen = law_of(sphere, law);
    if (poisson.size() != speeds.size()) throw std::invalid_argument("arrays: all of one size");
    const std::vector<double> nu = to_vector(poisson), at = to_vector(speeds);
    auto made = computed([&](const Poll& poll) {
      Rows<SlowImpact> rows(quantities);
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
auto estimates(bool sphere, const Quantities<RayleighEstimate>& quantities) {
  return [sphere, &quantities](const std::string& law, double poisson, const Doubles& speeds, double cutoff) {
    const StaticLaw chosen = law_of(sphere, law);
    const std::vector<double> at = to_vector(speeds);
    std::vector<DrivenMode> driven;
    auto made = computed([&](const Poll& poll) {
      Rows<RayleighEstimate> rows(quantities);
      const std::vector<bodies::Mode> all =
          sphere ? bodies::sphere::modes(poisson, cutoff, poll) : bodies::disk::modes(poisson, cutoff, poll);
      for (const double speed : at) {
        if (poll) poll();
        RayleighEstimate estimate = rayleigh(chosen, poisson, speed, all, poll);
        rows.add(estimate);
        if (at.size() == 1) driven = std::move(estimate.modes);
      }
      return rows;
    });
    return py::make_tuple(made.take(), take(std::move(driven)));
  };
}

/// What a disk or a sphere has: the functions of its laws, its slow impacts and their estimates.
void bind_laws(py::module_& module, bool sphere, const Quantities<SlowImpact>& of_impacts,
               const Quantities<RayleighEstimate>& of_estimates) {
  const auto name = [sphere](const std::string& own) { return sphere ? "point_" + own : own; };
  def(module, name("limit_force").c_str(), {"law", "poisson"}, over_law(sphere, &limit_force));
  def(module, name("limit_speed").c_str(), {"law", "poisson"}, over_law(sphere, &limit_speed));
  def(module, name("compression").c_str(), {"law", "poisson", "force"}, over_law(sphere, &compression));
  def(module, name("compression_force").c_str(), {"law", "poisson", "compression"},
      over_law(sphere, &compression_force));
  def(module, name("compression_energy").c_str(), {"law", "poisson", "force"}, over_law(sphere, &compression_energy));
  def(module, name("slow_impact").c_str(), {"law", "poisson", "speeds"}, slow_impacts(sphere, of_impacts));
  def(module, name("rayleigh").c_str(), {"law", "poisson", "speeds", "cutoff"}, estimates(sphere, of_estimates));
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
  module.attr("point_rayleigh_row") = Rows<RayleighEstimate>(point_rayleigh_quantities()).type();
  bind_laws(module, false, slow_impact_quantities(), rayleigh_quantities());
  bind_laws(module, true, point_slow_impact_quantities(), point_rayleigh_quantities());
  def(module, "contact_radius", {"poisson", "force"}, [](const Doubles& poisson, const Doubles& forces) {
    return over([](double nu, double f) { return contact_radius(PointLaw::hertz, nu, f); }, poisson, forces);
  });
  def(module, "static_contact", {"poisson", "compression", "nodes"}, &static_contact_numbers<double>);
  def(module, "point_static_contact", {"poisson", "compression", "nodes"},
      [](double nu, double compression, int nodes) {
        return static_contact_numbers(Sphere{.poisson = nu}, compression, nodes);
      });
  bind_statics(module);
}

}  // namespace stoss::python

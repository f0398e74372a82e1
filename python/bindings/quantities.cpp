#include "quantities.hpp"

#include <stdexcept>
#include <string>

#include "bindings.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/quasistatic/quantities.hpp"
#include "stoss/restitution/quantities.hpp"
#include "stoss/vibration/bounce.hpp"
#include "stoss/vibration/quantities.hpp"

namespace stoss::python {
namespace {

/// Name, dimension and whether there is an error, of each.
template <typename Result>
py::tuple listed(const Quantities<Result>& quantities) {
  py::list list;
  for (const auto& [name, dimension, value, error] : quantities) {
    list.append(py::make_tuple(name, dimension_name(dimension), static_cast<bool>(error)));
  }
  return py::tuple(list);
}

UnitSystem system(const std::string& body, bool si) {
  if (body == "rod") return si ? UnitSystem::rod_si : UnitSystem::rod;
  if (body == "sphere") return si ? UnitSystem::sphere_si : UnitSystem::sphere;
  if (body == "disk") return si ? UnitSystem::disk_si : UnitSystem::disk;
  throw std::invalid_argument("body: disk, rod or sphere");
}

/// Names of the units by dimension.
py::dict units(const std::string& body, bool si) {
  py::dict names;
  using enum Dimension;
  for (const Dimension each : {none, length, inverse_length, time, speed, frequency, force, energy}) {
    names[py::str(std::string(dimension_name(each)))] = unit_name(each, system(body, si));
  }
  return names;
}

}  // namespace

void bind_quantities(py::module_& module) {
  py::dict all;
  all["impact"] = listed(impact_quantities());
  all["mode energy"] = listed(mode_energy_quantities());
  all["snapshot"] = listed(snapshot_quantities());
  all["restitution"] = listed(restitution_quantities());
  all["bounce"] = listed(bounce_quantities());
  all["sample"] = listed(sample_quantities());
  all["extrapolation"] = listed(extrapolation_quantities());
  all["soft impact"] = listed(soft_impact_quantities());
  all["mode"] = listed(bodies::disk::mode_quantities());
  all["sphere mode"] = listed(bodies::sphere::mode_quantities());
  all["slow impact"] = listed(quasistatic::slow_impact_quantities());
  all["rayleigh"] = listed(quasistatic::rayleigh_quantities());
  all["point slow impact"] = listed(quasistatic::point_slow_impact_quantities());
  all["point rayleigh"] = listed(quasistatic::point_rayleigh_quantities());
  all["driven mode"] = listed(quasistatic::driven_mode_quantities());
  all["soft static contact"] = listed(quasistatic::soft_static_contact_quantities());
  module.attr("quantities") = all;
  module.def("units", &units, py::arg("body"), py::arg("si"), "names by dimension");
}

}  // namespace stoss::python

#include "bindings.hpp"
#include "stoss/version.hpp"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The C++ core of stoss. Use the package stoss, which checks, broadcasts and documents.";
  module.attr("version") = std::string(stoss::version());
  stoss::python::bind_errors(module);
  stoss::python::bind_quantities(module);
  stoss::python::bind_material(module);
  stoss::python::bind_modes(module);
  stoss::python::bind_body(module);
  stoss::python::bind_wall(module);
  stoss::python::bind_contact(module);
  stoss::python::bind_impact(module);
  stoss::python::bind_motion(module);
  stoss::python::bind_field(module);
  stoss::python::bind_wave(module);
  stoss::python::bind_restitution(module);
  stoss::python::bind_restitution_function(module);
  stoss::python::bind_bounce(module);
  stoss::python::bind_rod_chain(module);
  stoss::python::bind_distribution(module);
  stoss::python::bind_extrapolation(module);
  stoss::python::bind_pair_table(module);
  stoss::python::bind_quasistatic(module);
  stoss::python::bind_point_quasistatic(module);
}

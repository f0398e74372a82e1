#pragma once

#include <pybind11/pybind11.h>

/// What each room of the core adds to the module stoss._core. The package in python/stoss checks types, broadcasts and
/// documents; here nothing is computed.
namespace stoss::python {

namespace py = pybind11;

void bind_errors(py::module_& module);
void bind_quantities(py::module_& module);
void bind_material(py::module_& module);
void bind_modes(py::module_& module);
void bind_body(py::module_& module);
void bind_contact(py::module_& module);
void bind_wall(py::module_& module);
void bind_impact(py::module_& module);
void bind_motion(py::module_& module);
void bind_field(py::module_& module);
void bind_wave(py::module_& module);
void bind_restitution(py::module_& module);
void bind_restitution_function(py::module_& module);
void bind_bounce(py::module_& module);
void bind_rod_chain(py::module_& module);
void bind_distribution(py::module_& module);
void bind_extrapolation(py::module_& module);
void bind_pair_table(py::module_& module);
void bind_quasistatic(py::module_& module);
void bind_point_quasistatic(py::module_& module);

}  // namespace stoss::python

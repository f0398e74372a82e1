#include "stoss/material.hpp"

#include "bindings.hpp"

namespace stoss::python {
namespace {

Plane to_plane(bool strain) { return strain ? Plane::strain : Plane::stress; }

}  // namespace

void bind_material(py::module_& module) {
  module.def(
      "plane_poisson",
      [](double young, double poisson, double density, bool strain) {
        return plane_poisson({young, poisson, density}, to_plane(strain));
      },
      py::arg("young"), py::arg("poisson"), py::arg("density"), py::arg("strain"));
  module.def(
      "scales",
      [](double young, double poisson, double density, bool strain, double radius) {
        const Scales si = scales({young, poisson, density}, to_plane(strain), radius);
        return py::make_tuple(si.length, si.speed, si.time, si.frequency, si.force);
      },
      py::arg("young"), py::arg("poisson"), py::arg("density"), py::arg("strain"), py::arg("radius"),
      "(length, speed, time, frequency, force)");
}

}  // namespace stoss::python

#include "stoss/material.hpp"

#include <pybind11/stl.h>

#include <optional>
#include <tuple>

#include "bindings.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/quasistatic/yield.hpp"

namespace stoss::python {
namespace {

Plane to_plane(bool strain) { return strain ? Plane::strain : Plane::stress; }

py::tuple to_tuple(const Scales& si) { return py::make_tuple(si.length, si.speed, si.time, si.frequency, si.force); }

/// Young's modulus, Poisson number, density and yield strength of a sphere, and its radius; infinite of a half-space.
using Solid = std::tuple<double, double, double, std::optional<double>, double>;

Material material_of(const Solid& solid) {
  return {std::get<0>(solid), std::get<1>(solid), std::get<2>(solid), std::get<3>(solid)};
}

std::optional<double> yield_speed(const Solid& first, const std::optional<Solid>& second) {
  if (!second) return quasistatic::yield_speed(material_of(first), std::get<4>(first));
  return quasistatic::yield_speed(material_of(first), std::get<4>(first), material_of(*second), std::get<4>(*second));
}

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
        return to_tuple(scales({young, poisson, density}, to_plane(strain), radius));
      },
      py::arg("young"), py::arg("poisson"), py::arg("density"), py::arg("strain"), py::arg("radius"),
      "(length, speed, time, frequency, force)");
  module.def("yield_speed", &yield_speed, py::arg("first"), py::arg("second"),
             "of (young, poisson, density, yield strength, radius); m/s, or None");
  module.def(
      "rod_scales",
      [](double length, double young, double density, double area) {
        return to_tuple(scales(Rod{length, young, density, area}));
      },
      py::arg("length"), py::arg("young"), py::arg("density"), py::arg("area"),
      "(length, speed, time, frequency, force)");
  module.def(
      "sphere_scales",
      [](double poisson, double radius, double young, double density) {
        return to_tuple(scales(Sphere{poisson, radius, young, density}));
      },
      py::arg("poisson"), py::arg("radius"), py::arg("young"), py::arg("density"),
      "(length, speed, time, frequency, force)");
}

}  // namespace stoss::python

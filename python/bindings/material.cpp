#include "stoss/material.hpp"

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/encounter/materials.hpp"

namespace stoss::python {
namespace {

Plane to_plane(bool strain) { return strain ? Plane::strain : Plane::stress; }

py::tuple to_tuple(const Scales& si) { return py::make_tuple(si.length, si.speed, si.time, si.frequency, si.force); }

}  // namespace

void bind_material(py::module_& module) {
  module.def(
      "plane_poisson",
      [](double young, double poisson, double density, bool strain) {
        return plane_poisson({young, poisson, density}, to_plane(strain));
      },
      py::arg("young"), py::arg("poisson"), py::arg("density"), py::arg("strain"));
  module.def("loss_time_of_quality", &loss_time_of_quality, py::arg("quality"), py::arg("frequency"));
  module.def(
      "scales",
      [](double young, double poisson, double density, bool strain, double radius) {
        return to_tuple(scales({young, poisson, density}, to_plane(strain), radius));
      },
      py::arg("young"), py::arg("poisson"), py::arg("density"), py::arg("strain"), py::arg("radius"),
      "(length, speed, time, frequency, force)");
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
  module.def(
      "named_materials",
      [] {
        py::list all;
        for (const auto& [name, its, quality, frequency, source] : named_materials()) {
          all.append(py::make_tuple(name, its.young, its.poisson, its.density, its.yield_strength, its.loss_time));
        }
        return all;
      },
      "(name, young, poisson, density, yield strength or None, loss time or None) of each");
}

}  // namespace stoss::python

#include "stoss/body/body.hpp"

#include <pybind11/numpy.h>

#include "bindings.hpp"
#include "interpreter.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"

namespace stoss::python {

void bind_body(py::module_& module) {
  py::class_<Body> body(module, "Body", "A body with its kept modes.");
  body.def_readonly("name", &Body::name)
      .def_readonly("mass", &Body::mass)
      .def_readonly("extent", &Body::extent)
      .def_readonly("cutoff", &Body::cutoff);
  py::class_<BodyMaker> maker(module, "BodyMaker", "Makes a body with its modes up to any cutoff.");
  maker.def(
      "at",
      [](const BodyMaker& make, double cutoff) {
        const Poll poll = signal_poll();
        const Released released;
        return make(cutoff, poll);
      },
      py::arg("cutoff"));
  seal(body);
  seal(maker);
  module.def(
      "disk",
      [](double poisson, double radius, double young, double density, double loss_time) {
        return disk(Disk{poisson, radius, young, density, loss_time});
      },
      py::arg("poisson"), py::arg("radius"), py::arg("young"), py::arg("density"), py::arg("loss_time"));
  module.def(
      "rod",
      [](double length, double young, double density, double area, double loss_time) {
        return rod(Rod{length, young, density, area, loss_time});
      },
      py::arg("length"), py::arg("young"), py::arg("density"), py::arg("area"), py::arg("loss_time"));
  module.def(
      "sphere",
      [](double poisson, double radius, double young, double density, double loss_time) {
        return sphere(Sphere{poisson, radius, young, density, loss_time});
      },
      py::arg("poisson"), py::arg("radius"), py::arg("young"), py::arg("density"), py::arg("loss_time"));
  module.def(
      "half_space",
      [](double poisson, double young, double density, double loss_time) {
        return half_space(HalfSpace{poisson, young, density, loss_time});
      },
      py::arg("poisson"), py::arg("young"), py::arg("density"), py::arg("loss_time"));
  module.def(
      "half_plane",
      [](double poisson, double young, double density, double loss_time) {
        return half_plane(HalfPlane{poisson, young, density, loss_time});
      },
      py::arg("poisson"), py::arg("young"), py::arg("density"), py::arg("loss_time"));
  module.def(
      "rigid", [](const BodyMaker& elastic) { return rigid(elastic); }, py::arg("elastic"));
  module.def(
      "with_modes",
      [](const Body& all, const py::array_t<bool, py::array::c_style>& keep) {
        return with_modes(all, std::vector<bool>(keep.data(), keep.data() + keep.size()));
      },
      py::arg("body"), py::arg("keep"));
}

}  // namespace stoss::python

#include "stoss/body/body.hpp"

#include <pybind11/numpy.h>

#include "bindings.hpp"
#include "interpreter.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/restitution/ladder.hpp"
#include "wall.hpp"

namespace stoss::python {

void bind_body(py::module_& module) {
  py::class_<Body> body(module, "Body", "A body with its kept modes.");
  body.def_readonly("name", &Body::name)
      .def_readonly("mass", &Body::mass)
      .def_readonly("extent", &Body::extent)
      .def_readonly("cutoff", &Body::cutoff);
  py::class_<RefinableContact> refinable(module, "RefinableContact", "What meets what, at any of a ladder of cutoffs.");
  py::class_<Contact> contact(module, "Contact", "What meets what, with its kept modes.");
  contact.def_readonly("mass", &Contact::mass);
  seal(body);
  seal(contact);
  seal(refinable);
  module.def(
      "disk",
      [](double poisson, double cutoff) {
        const Poll poll = signal_poll();
        const Released released;
        return disk(poisson, cutoff, poll);
      },
      py::arg("poisson"), py::arg("cutoff"));
  module.def(
      "with_modes",
      [](const Body& all, const py::array_t<bool, py::array::c_style>& keep) {
        return with_modes(all, std::vector<bool>(keep.data(), keep.data() + keep.size()));
      },
      py::arg("body"), py::arg("keep"));
  module.def("rod", py::overload_cast<double>(&rod), py::arg("cutoff"));
  module.def(
      "at_wall", [](const Body& at, const AnyWall& wall) { return stoss::contact(at, wall.wall); }, py::arg("body"),
      py::arg("wall"));
  module.def(
      "refinable_disk", [](double poisson) { return RefinableContact(disk(poisson)); }, py::arg("poisson"));
  module.def("refinable_rod", [] { return RefinableContact(rod()); });
}

}  // namespace stoss::python

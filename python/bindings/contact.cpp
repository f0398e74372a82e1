#include "stoss/contact/contact.hpp"

#include "bindings.hpp"
#include "interpreter.hpp"
#include "stoss/restitution/ladder.hpp"
#include "wall.hpp"

namespace stoss::python {

void bind_contact(py::module_& module) {
  py::class_<Contact> contact(module, "Contact", "What meets what, with its kept modes.");
  contact.def_readonly("mass", &Contact::mass);
  py::class_<RefinableContact> refinable(module, "RefinableContact", "What meets what, at any of a ladder of cutoffs.");
  seal(contact);
  seal(refinable);
  module.def(
      "at_wall", [](const Body& body, const AnyWall& wall) { return stoss::contact(body, wall.wall); }, py::arg("body"),
      py::arg("wall"));
  module.def(
      "pair",
      [](const BodyMaker& first, const BodyMaker& second, double cutoff, double slowest) {
        const Poll poll = signal_poll();
        const Released released;
        return stoss::contact(first, second, cutoff, slowest, poll);
      },
      py::arg("first"), py::arg("second"), py::arg("cutoff"), py::arg("slowest"));
  module.def(
      "refinable", [](const BodyMaker& body) { return RefinableContact(body); }, py::arg("body"));
  module.def(
      "refinable_pair", [](const BodyMaker& first, const BodyMaker& second) { return RefinableContact(first, second); },
      py::arg("first"), py::arg("second"));
}

}  // namespace stoss::python

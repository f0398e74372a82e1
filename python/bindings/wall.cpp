#include "wall.hpp"

#include "bindings.hpp"

namespace stoss::python {

void bind_wall(py::module_& module) {
  py::class_<AnyWall>(module, "AnyWall", "A hard or an exponential wall.");
  module.def(
      "hard_wall", [](bool radiating) { return AnyWall{HardWall{radiating ? Tail::radiating : Tail::quasistatic}}; },
      py::arg("radiating"));
  module.def(
      "exponential_wall",
      [](double hardness, double strength) {
        const Wall wall = ExponentialWall{hardness, strength};
        validate(wall);
        return AnyWall{wall};
      },
      py::arg("hardness"), py::arg("strength"));
}

}  // namespace stoss::python

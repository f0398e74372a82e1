#include "wall.hpp"

#include "bindings.hpp"
#include "interpreter.hpp"

namespace stoss::python {

void bind_wall(py::module_& module) {
  py::class_<AnyWall> any(module, "AnyWall", "A hard or an exponential wall.");
  seal(any);
  module.def(
      "hard_wall",
      [](bool radiating) {
        return AnyWall{HardWall{}, radiating ? Tail::radiating : Tail::quasistatic};
      },
      py::arg("radiating"));
  module.def(
      "exponential_wall",
      [](double hardness, double strength) {
        const Wall wall = ExponentialWall{hardness, strength};
        validate(wall);
        return AnyWall{wall, Tail::radiating};
      },
      py::arg("hardness"), py::arg("strength"));
}

}  // namespace stoss::python

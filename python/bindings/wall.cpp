#include "wall.hpp"

#include "bindings.hpp"
#include "interpreter.hpp"

namespace stoss::python {

void bind_wall(py::module_& module) {
  py::class_<AnyWall> any(module, "AnyWall", "A hard or an exponential wall.");
  seal(any);
  module.def("hard_wall", [] { return AnyWall{HardWall{}}; });
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

#pragma once

#include "stoss/contact/wall.hpp"

namespace stoss::python {

/// A wall as a Python object: pybind11 would take the variant itself apart.
struct AnyWall {
  Wall wall;
};

}  // namespace stoss::python

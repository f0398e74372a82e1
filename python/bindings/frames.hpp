#pragma once

#include <vector>

#include "bindings.hpp"
#include "stoss/impact/replay.hpp"

namespace stoss::python {

/// Instants of one impact, for stoss._core only.
struct Frames {
  std::vector<Frame> all;
};

}  // namespace stoss::python

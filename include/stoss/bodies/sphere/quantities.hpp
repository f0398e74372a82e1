#pragma once

#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/quantity.hpp"

namespace stoss::bodies::sphere {

/// Quantities of one vibration of a free sphere.
[[nodiscard]] const Quantities<Mode>& mode_quantities();

}  // namespace stoss::bodies::sphere

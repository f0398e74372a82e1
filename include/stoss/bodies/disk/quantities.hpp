#pragma once

#include "stoss/bodies/disk/modes.hpp"
#include "stoss/quantity.hpp"

namespace stoss::bodies::disk {

/// Quantities of one vibration of a free disk.
[[nodiscard]] const Quantities<Mode>& mode_quantities();

}  // namespace stoss::bodies::disk

#pragma once

#include "stoss/impact/resolution.hpp"

namespace stoss {

/// Resolution of an impact at a hard wall for `restitution`: finer in time and in space with the
/// cutoff.
/// @param half_width maximum of the contact in a coarser run, or 0 if there was none
[[nodiscard]] Resolution refined_resolution(const Contact& contact, double speed, double half_width);

}  // namespace stoss

#pragma once

#include "stoss/body/body.hpp"

namespace stoss {

/// A thin rod that meets a wall, a rod or another hammer with one end and carries a point mass at the other, in units
/// of the rod's length, bar speed and mass.
/// @param ratio  point mass over the mass of the rod, above 0 to 1e6
/// @param cutoff highest frequency, above 0 to 100 000
/// @throws InvalidInput outside these ranges
[[nodiscard]] Body hammer(double ratio, double cutoff);

}  // namespace stoss

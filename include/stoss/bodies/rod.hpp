#pragma once

#include "stoss/body/body.hpp"

namespace stoss {

/// A thin elastic rod that meets the wall with one end, in units of its length L, bar speed c and mass: ω_l = lπ,
/// end amplitude √2. Exact against a hard wall: ε = 1, contact time 2L/c, force mvc/L throughout.
/// @param cutoff c/L, from π to 10 000
/// @throws InvalidInput outside that range
[[nodiscard]] Body rod(double cutoff);

/// Makes rods at any cutoff, for `restitution`, which chooses the cutoffs.
[[nodiscard]] BodyMaker rod();

}  // namespace stoss

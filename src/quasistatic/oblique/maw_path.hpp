#pragma once

#include "stoss/quasistatic/oblique/maw.hpp"

namespace stoss::quasistatic {

/// Maw's impact in a given number of steps, from where the contact begins to stick to its end. The error falls as the
/// square of the steps, with a smooth part that extrapolation removes and one of where phases begin within steps.
/// @param psi1 0 to sliding_limit(chi)
/// @return the impulse, and the shares of time; the rest is left out
[[nodiscard]] MawImpact maw_path(double psi1, double chi, int steps);

}  // namespace stoss::quasistatic

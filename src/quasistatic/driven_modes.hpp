#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "check.hpp"
#include "stoss/poll.hpp"
#include "stoss/quasistatic/rayleigh.hpp"

namespace stoss::quasistatic {

/// Throws InvalidInput for modes that no body has. @param amplitude what `radial` is, as "edge amplitude C"
inline void require_modes(const std::vector<bodies::Mode>& modes, const std::string& amplitude) {
  for (const bodies::Mode& mode : modes) {
    require("omega", mode.omega, {0.0, 1000.0, false, true, "above 0 to 1000"}, "frequency of a mode, in c/R");
    require("radial", mode.radial, {0.0, 1e6, true, true, "0 to 1e6"}, amplitude + " of a mode");
  }
}

/// Adds up what a pulse of force leaves in modes, for a RayleighEstimate or a PointRayleighEstimate.
/// @param integral     ∫F cos ωt dt / v of a mode
/// @param force_rate   maximum |dF/dt| / v
/// @param second_order change of the amplitudes over kinetic_share
template <typename Estimate, typename Integral>
void drive(const std::vector<bodies::Mode>& modes, Integral integral, double force_rate, double second_order,
           const Poll& poll, Estimate& result) {
  double inertia = 0.0;  // Σ radial²/ω⁴
  result.modes.reserve(modes.size());
  for (const bodies::Mode& mode : modes) {
    if (poll) poll();
    const double amplitude = integral(mode);
    const double edge = mode.radial * amplitude;
    const double lag = mode.radial / (mode.omega * mode.omega);
    result.modes.push_back(
        {.order = mode.order, .index = mode.index, .omega = mode.omega, .amplitude = amplitude, .after = edge * edge});
    result.lost_fraction += edge * edge;
    inertia += lag * lag;
  }
  result.kinetic_share = force_rate * force_rate * inertia;
  const double change = second_order * result.kinetic_share;
  result.lost_fraction_error = change * (2.0 * std::sqrt(result.lost_fraction) + change);
  result.beyond_perturbation = result.kinetic_share > max_kinetic_share;
}

}  // namespace stoss::quasistatic

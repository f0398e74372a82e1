// With the overlap of a mode's motion and the force, q̈ + ω²q = (U/mω²) d²/dt² [F + U q dF/dδ]: while the sphere touches
// a mode turns at ω² + U² dF/dδ/m, which to first order adds the phase φ.
#include "stoss/quasistatic/point_rayleigh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "quasistatic/driven_modes.hpp"
#include "quasistatic/point_pulse.hpp"

namespace stoss::quasistatic {
namespace {

/// ∫F cos(ωt + φ) dt / v
double amplitude(const PointPulse::Nodes& nodes, double omega, double shift) {
  double sum = 0.0;
  for (std::size_t i = 0; i < nodes.time.size(); ++i) {
    sum += nodes.weight[i] * std::cos(omega * nodes.time[i] + shift * nodes.stiffness[i]);
  }
  return sum;
}

/// φ per ∫dF/dδ dt
double shift_of(const bodies::Mode& mode) { return 0.5 * mode.radial * mode.radial / mode.omega; }

}  // namespace

double mean_loss_factor(double poisson, const std::vector<bodies::Mode>& modes) {
  const double stiffness = limit_force(PointLaw::hertz, poisson);  // (4/3)E*/m
  require_modes(modes, "surface amplitude U");
  double sum = 0.0;
  for (const bodies::Mode& mode : modes) sum += mode.radial * mode.radial / std::pow(mode.omega, 5);
  return 1.125 * std::numbers::pi * stiffness * stiffness * sum;
}

PointRayleighEstimate rayleigh(PointLaw law, double poisson, double speed, const std::vector<bodies::Mode>& modes,
                               const Poll& poll) {
  PointRayleighEstimate result;
  result.impact = slow_impact(law, poisson, speed);
  result.mean_lost_fraction = speed * mean_loss_factor(poisson, modes);
  const PointPulse pulse(law, poisson, speed);
  const double stiffest = pulse.law().stiffness(pulse.greatest_radius());
  double fastest = 0.0;
  for (const bodies::Mode& mode : modes) {
    result.cutoff = std::max(result.cutoff, mode.omega);
    const double shifted = mode.omega + shift_of(mode) * stiffest;
    if (std::isfinite(shifted)) fastest = std::max(fastest, shifted);
  }
  const PointPulse::Nodes nodes = pulse.nodes(fastest);
  const auto integral = [&](const bodies::Mode& mode) { return amplitude(nodes, mode.omega, shift_of(mode)); };
  drive(modes, integral, pulse.max_force_rate(), point_second_order_factor, poll, result);
  return result;
}

}  // namespace stoss::quasistatic

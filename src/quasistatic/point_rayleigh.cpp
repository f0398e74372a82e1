// With the overlap of a mode's motion and the force, q̈ + ω²q = (U/mω²) d²/dt² [F + U q dF/dδ]: while the sphere touches
// a mode turns at ω² + U² dF/dδ/m, which to first order adds the phase φ.
#include "stoss/quasistatic/point_rayleigh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "check.hpp"
#include "quasistatic/point_pulse.hpp"

namespace stoss::quasistatic {
namespace {

void require_modes(const std::vector<bodies::sphere::Mode>& modes) {
  for (const bodies::sphere::Mode& mode : modes) {
    require("omega", mode.omega, {0.0, bodies::sphere::max_cutoff, false, true, "above 0 to 1000"},
            "frequency of a mode, in c/R");
    require("radial", mode.radial, {0.0, 1e6, true, true, "0 to 1e6"}, "surface amplitude U of a mode");
  }
}

/// ∫F cos(ωt + φ) dt / v
double amplitude(const PointPulse::Nodes& nodes, double omega, double shift) {
  double sum = 0.0;
  for (std::size_t i = 0; i < nodes.time.size(); ++i) {
    sum += nodes.weight[i] * std::cos(omega * nodes.time[i] + shift * nodes.stiffness[i]);
  }
  return sum;
}

/// φ per ∫dF/dδ dt
double shift_of(const bodies::sphere::Mode& mode) { return 0.5 * mode.radial * mode.radial / mode.omega; }

}  // namespace

double mean_loss_factor(double poisson, const std::vector<bodies::sphere::Mode>& modes) {
  const double stiffness = limit_force(PointLaw::hertz, poisson);  // (4/3)E*/m
  require_modes(modes);
  double sum = 0.0;
  for (const bodies::sphere::Mode& mode : modes) sum += mode.radial * mode.radial / std::pow(mode.omega, 5);
  return 1.125 * std::numbers::pi * stiffness * stiffness * sum;
}

PointRayleighEstimate rayleigh(PointLaw law, double poisson, double speed,
                               const std::vector<bodies::sphere::Mode>& modes, const Poll& poll) {
  PointRayleighEstimate result;
  result.impact = slow_impact(law, poisson, speed);
  result.mean_lost_fraction = speed * mean_loss_factor(poisson, modes);
  const PointPulse pulse(law, poisson, speed);
  const double stiffest = pulse.law().stiffness(pulse.greatest_radius());
  double fastest = 0.0;
  for (const bodies::sphere::Mode& mode : modes) {
    result.cutoff = std::max(result.cutoff, mode.omega);
    const double shifted = mode.omega + shift_of(mode) * stiffest;
    if (std::isfinite(shifted)) fastest = std::max(fastest, shifted);
  }
  const PointPulse::Nodes nodes = pulse.nodes(fastest);
  double inertia = 0.0;  // Σ U²/ω⁴
  result.modes.reserve(modes.size());
  for (const bodies::sphere::Mode& mode : modes) {
    if (poll) poll();
    const double integral = amplitude(nodes, mode.omega, shift_of(mode));
    const double edge = mode.radial * integral;
    const double lag = mode.radial / (mode.omega * mode.omega);
    result.modes.push_back(
        {.order = mode.order, .index = mode.index, .omega = mode.omega, .amplitude = integral, .after = edge * edge});
    result.lost_fraction += edge * edge;
    inertia += lag * lag;
  }
  const double rate = pulse.max_force_rate();
  result.kinetic_share = rate * rate * inertia;
  const double change = point_second_order_factor * result.kinetic_share;
  result.lost_fraction_error = change * (2.0 * std::sqrt(result.lost_fraction) + change);
  result.beyond_perturbation = result.kinetic_share > max_kinetic_share;
  return result;
}

}  // namespace stoss::quasistatic

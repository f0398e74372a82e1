// With the overlap of a mode's motion and the force, q̈ + ω²q = (U/mω²) d²/dt² [F + U q dF/dδ]: while a sphere touches,
// a mode turns at ω² + U² dF/dδ/m, which to first order adds the phase φ.
#include "stoss/quasistatic/rayleigh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "check.hpp"
#include "quasistatic/pulse.hpp"

namespace stoss::quasistatic {
namespace {

constexpr std::size_t lanes = 4;  // sums side by side: their order is fixed, and they need not wait for one another

template <std::size_t size>
constexpr std::array<double, size> inverse(std::array<double, size> values) {
  for (double& value : values) value = 1.0 / value;
  return values;
}

/// cos x for 0 ≤ x < 1e6, to 1e-15 plus the rounding of x; without branches, in a loop several times faster than the
/// library's: 2 cos²(x/2) − 1, with the series of the cosine after whole turns are taken off.
double cosine(double x) {
  constexpr double to_integer = 0x1.8p52;           // what is added to it loses its fraction
  constexpr double per_turn = 0.15915494309189535;  // 1/2π
  constexpr double turn_high = 0x1.921fb5p+2;       // 2π in two parts, the first with few bits
  constexpr double turn_low = 0x1.110b4611a6263p-24;
  constexpr std::array factorials{1.1240007277776077e21,
                                  2.43290200817664e18,
                                  6.402373705728e15,
                                  2.0922789888e13,
                                  8.71782912e10,
                                  4.790016e8,
                                  3.6288e6,
                                  40320.0,
                                  720.0,
                                  24.0,
                                  2.0};  // 22!, 20! … 2!
  constexpr auto series = inverse(factorials);
  const double turns = (x * per_turn + to_integer) - to_integer;
  const double half = 0.5 * ((x - turns * turn_high) - turns * turn_low);
  const double square = half * half;
  double sum = 0.0;
  for (const double coefficient : series) sum = coefficient - square * sum;
  const double result = 1.0 - square * sum;
  return 2.0 * result * result - 1.0;
}

/// ∫F cos(ωt + φ) dt / v, with φ per ∫dF/dδ dt
double amplitude(const Pulse::Nodes& nodes, double omega, double shift) {
  std::array<double, lanes> sum{};
  if (shift == 0.0) {
    for (std::size_t i = 0; i < nodes.time.size(); i += lanes) {
      for (std::size_t k = 0; k < lanes; ++k) sum[k] += nodes.weight[i + k] * cosine(omega * nodes.time[i + k]);
    }
  } else {  // a slow sphere touches for so long that each rounding of the cosine counts
    for (std::size_t i = 0; i < nodes.time.size(); ++i) {
      sum[0] += nodes.weight[i] * std::cos(omega * nodes.time[i] + shift * nodes.stiffness[i]);
    }
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/// Nodes of no weight behind the last one fill up the lanes.
Pulse::Nodes padded(Pulse::Nodes nodes) {
  const std::size_t size = (nodes.time.size() + lanes - 1) / lanes * lanes;
  for (auto* values : {&nodes.time, &nodes.weight, &nodes.stiffness}) values->resize(size, 0.0);
  return nodes;
}

/// φ per ∫dF/dδ dt of a mode of a sphere.
double shift_of(const bodies::Mode& mode) { return 0.5 * mode.radial * mode.radial / mode.omega; }

void require_modes(const std::vector<bodies::Mode>& modes, const std::string& amplitude) {
  for (const bodies::Mode& mode : modes) {
    require("omega", mode.omega, {0.0, 1000.0, false, true, "above 0 to 1000"}, "frequency of a mode, in c/R");
    require("radial", mode.radial, {0.0, 1e6, true, true, "0 to 1e6"}, amplitude + " of a mode");
  }
}

}  // namespace

double mean_loss_factor(double poisson, const std::vector<bodies::Mode>& modes) {
  const double stiffness = limit_force(PointLaw::hertz, poisson);  // (4/3)E*/m
  require_modes(modes, "surface amplitude U");
  double sum = 0.0;
  for (const bodies::Mode& mode : modes) sum += mode.radial * mode.radial / std::pow(mode.omega, 5);
  return 1.125 * std::numbers::pi * stiffness * stiffness * sum;
}

RayleighEstimate rayleigh(StaticLaw law, double poisson, double speed, const std::vector<bodies::Mode>& modes,
                          const Poll& poll) {
  const bool point = std::holds_alternative<PointLaw>(law);
  RayleighEstimate result;
  result.impact = slow_impact(law, poisson, speed);
  require_modes(modes, point ? "surface amplitude U" : "edge amplitude C");
  if (point) result.mean_lost_fraction = speed * mean_loss_factor(poisson, modes);
  const auto pulse = slow_pulse(law, poisson, speed);
  const double stiffest = pulse->at(0.0).stiffness;
  const auto shift = [point](const bodies::Mode& mode) { return point ? shift_of(mode) : 0.0; };
  double fastest = 0.0;
  for (const bodies::Mode& mode : modes) {
    result.cutoff = std::max(result.cutoff, mode.omega);
    const double shifted = mode.omega + shift(mode) * stiffest;
    if (std::isfinite(shifted)) fastest = std::max(fastest, shifted);
  }
  const Pulse::Nodes nodes = padded(pulse->nodes(fastest));
  double inertia = 0.0;  // Σ radial²/ω⁴
  result.modes.reserve(modes.size());
  for (const bodies::Mode& mode : modes) {
    if (poll) poll();
    const double integral = amplitude(nodes, mode.omega, shift(mode));
    const double edge = mode.radial * integral;
    const double lag = mode.radial / (mode.omega * mode.omega);
    result.modes.push_back(
        {.order = mode.order, .index = mode.index, .omega = mode.omega, .amplitude = integral, .after = edge * edge});
    result.lost_fraction += edge * edge;
    inertia += lag * lag;
  }
  const double force_rate = pulse->max_force_rate();
  result.kinetic_share = force_rate * force_rate * inertia;
  const double change = (point ? point_second_order_factor : second_order_factor) * result.kinetic_share;
  result.lost_fraction_error = change * (2.0 * std::sqrt(result.lost_fraction) + change);
  result.beyond_perturbation = result.kinetic_share > max_kinetic_share;
  return result;
}

}  // namespace stoss::quasistatic

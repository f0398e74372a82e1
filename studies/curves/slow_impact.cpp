// With the velocity δ̇ = v sin θ, from the turning point at θ = 0 to the end of contact at π/2, F follows from
// U(F) = ∫F dδ = ½v² cos²θ, and time from dt = −dδ̇/F = v cos θ dθ/F, which is regular at both ends.
#include "slow_impact.hpp"

#include <cmath>
#include <numbers>

namespace curves {
namespace {

constexpr int points = 4000;

/// ∫F dδ over dδ = [ln(1/F) − 1 − (1+ν)/4] dF, over F².
double energy_over_square(double force, double shift) { return 0.5 * std::log(1.0 / force) + 0.25 - 0.5 * shift; }

/// F at which the elastic energy has a given value.
double force_at(double energy, double guess, double shift) {
  double force = guess;
  for (int i = 0; i < 100; ++i) {
    const double next = std::sqrt(energy / energy_over_square(force, shift));
    if (std::abs(next - force) <= 1e-15 * force) return next;
    force = next;
  }
  return force;
}

}  // namespace

SlowImpact slow_impact(double poisson, double speed, const std::vector<stoss::Mode>& modes) {
  const double shift = 1.0 + 0.25 * (1.0 + poisson);
  const double width = 0.5 * std::numbers::pi / points;
  std::vector<double> time, weight;  // of the instants, from the turning point, and F dt there over v
  double now = 0.0;
  double force = speed;
  for (int i = 0; i < points; ++i) {
    const double theta = (i + 0.5) * width;
    const double velocity = speed * std::cos(theta);
    force = force_at(0.5 * velocity * velocity, force, shift);
    const double half_step = 0.5 * velocity / force * width;
    time.push_back(now + half_step);
    now += 2.0 * half_step;
    weight.push_back(2.0 * std::cos(theta) * width);  // both halves of the impact
  }
  SlowImpact result;
  result.contact_time = 2.0 * now;
  for (const stoss::Mode& mode : modes) {
    double amplitude = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i) amplitude += weight[i] * std::cos(mode.omega * time[i]);
    result.lost_fraction += mode.radial * mode.radial * amplitude * amplitude;
  }
  return result;
}

}  // namespace curves

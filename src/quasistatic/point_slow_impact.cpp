#include "stoss/quasistatic/point_slow_impact.hpp"

#include <cmath>
#include <numbers>

#include "check.hpp"
#include "quasistatic/point_pulse.hpp"

namespace stoss::quasistatic {

double limit_speed(PointLaw law, double poisson) {
  const RadiusLaw radius_law(law, poisson);
  return std::sqrt(2.0 * radius_law.energy(radius_law.limit()));
}

PointSlowImpact slow_impact(PointLaw law, double poisson, double speed) {
  const PointPulse pulse(law, poisson, speed);
  const double a = pulse.greatest_radius();
  return {.law = law,
          .poisson = poisson,
          .speed = speed,
          .contact_time = pulse.contact_time(),
          .max_compression = pulse.law().compression(a),
          .max_force = pulse.law().force(a),
          .max_radius = a};
}

std::vector<ContactInstant> contact_history(const PointSlowImpact& impact, const std::vector<double>& phases) {
  constexpr double pi = std::numbers::pi;
  const PointPulse pulse(impact.law, impact.poisson, impact.speed);
  const double half = 0.5 * pulse.contact_time();
  std::vector<ContactInstant> result;
  result.reserve(phases.size());
  for (const double phase : phases) {
    require("phase", phase, {0.0, pi, true, true, "0 to pi"}, "the velocity is speed * cos(phase)");
    const bool before = phase < 0.5 * pi;
    const double nearest = before ? phase : pi - phase;
    const double from_turn = nearest > 0.0 ? pulse.time(PointPulse::place_of(nearest)) : half;
    const double a = pulse.radius(nearest);
    result.push_back({.time = before ? half - from_turn : half + from_turn,
                      .velocity = impact.speed * std::cos(phase),
                      .compression = pulse.law().compression(a),
                      .force = pulse.law().force(a)});
  }
  return result;
}

}  // namespace stoss::quasistatic

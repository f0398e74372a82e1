#include "stoss/quasistatic/slow_impact.hpp"

#include <cmath>
#include <numbers>

#include "check.hpp"
#include "quasistatic/pulse.hpp"

namespace stoss::quasistatic {

using std::numbers::pi;

double limit_speed(StaticLaw law, double poisson) {
  const double force = limit_force(law, poisson);
  if (std::holds_alternative<CompressionLaw>(law)) return force / std::numbers::sqrt2;
  return std::sqrt(2.0 * compression_energy(law, poisson, force));
}

SlowImpact slow_impact(StaticLaw law, double poisson, double speed) {
  const auto pulse = slow_pulse(law, poisson, speed);
  const Pulse::Contact turn = pulse->at_phase(0.5 * pi);
  return {.law = law,
          .poisson = poisson,
          .speed = speed,
          .contact_time = pulse->contact_time(),
          .max_compression = turn.compression,
          .max_force = turn.force,
          .max_radius = turn.radius};
}

std::vector<ContactInstant> contact_history(const SlowImpact& impact, const std::vector<double>& phases) {
  const auto pulse = slow_pulse(impact.law, impact.poisson, impact.speed);
  const double half = 0.5 * pulse->contact_time();
  std::vector<ContactInstant> result;
  result.reserve(phases.size());
  for (const double phase : phases) {
    require("phase", phase, {0.0, pi, true, true, "0 to pi"}, "the velocity is speed * cos(phase)");
    const Pulse::Contact contact = pulse->at_phase(phase);
    const double from_turn = pulse->time(contact.place);
    result.push_back({.time = phase < 0.5 * pi ? half - from_turn : half + from_turn,
                      .velocity = impact.speed * std::cos(phase),
                      .compression = contact.compression,
                      .force = contact.force});
  }
  return result;
}

// In units R, c and m: the power η δ̇² dF/dδ = η Ḟδ̇ is, integrated by parts, η∫F² dt, which is ½v²(1 − ε²).
double viscous_loss(StaticLaw law, double poisson, double loss_time, double speed) {
  require("loss_time", loss_time, {0.0, 1e3, true, true, "0 to 1000"}, "in units of R/c");
  return loss_time * slow_pulse(law, poisson, speed)->squared_force();
}

}  // namespace stoss::quasistatic

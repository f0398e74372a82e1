#include "stoss/quasistatic/slow_impact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "check.hpp"
#include "quasistatic/pulse.hpp"

namespace stoss::quasistatic {
namespace {

ContactInstant instant(const SlowImpact& impact, const ForcePulse& pulse, double phase) {
  const double fall = pulse.fall(phase);
  const double from_turn = std::isinf(fall) ? 0.5 * impact.contact_time : pulse.time(fall);
  const double force = impact.max_force * std::exp(-fall);
  const double half = 0.5 * impact.contact_time;
  return {.time = phase < 0.5 * std::numbers::pi ? half - from_turn : half + from_turn,
          .velocity = impact.speed * std::cos(phase),
          .compression = force > 0.0 ? force * (1.0 + pulse.depth() + fall) : 0.0,
          .force = force};
}

}  // namespace

double limit_speed(CompressionLaw law, double poisson) { return limit_force(law, poisson) / std::numbers::sqrt2; }

SlowImpact slow_impact(CompressionLaw law, double poisson, double speed) {
  const ForcePulse pulse = slow_pulse(law, poisson, speed);
  const double force = std::min(speed / std::sqrt(pulse.energy_factor()), limit_force(law, poisson));
  return {.law = law,
          .poisson = poisson,
          .speed = speed,
          .contact_time = pulse.contact_time(),
          .max_compression = force * (1.0 + pulse.depth()),
          .max_force = force};
}

std::vector<ContactInstant> contact_history(const SlowImpact& impact, const std::vector<double>& phases) {
  const ForcePulse pulse = slow_pulse(impact.law, impact.poisson, impact.speed);
  const SlowImpact whole = slow_impact(impact.law, impact.poisson, impact.speed);
  std::vector<ContactInstant> result;
  result.reserve(phases.size());
  for (const double phase : phases) {
    require("phase", phase, {0.0, std::numbers::pi, true, true, "0 to pi"}, "the velocity is speed * cos(phase)");
    result.push_back(instant(whole, pulse, phase));
  }
  return result;
}

// In units R, c and m: the power η δ̇² dF/dδ = η Ḟδ̇ is, integrated by parts, η∫F² dt, which is ½v²(1 − ε²).
double viscous_loss(CompressionLaw law, double poisson, double loss_time, double speed) {
  require("loss_time", loss_time, {0.0, 1e3, true, true, "0 to 1000"}, "in units of R/c");
  return loss_time * slow_pulse(law, poisson, speed).squared_force();
}

}  // namespace stoss::quasistatic

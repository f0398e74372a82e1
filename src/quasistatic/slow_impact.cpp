#include "stoss/quasistatic/slow_impact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "check.hpp"
#include "quasistatic/pulse.hpp"
#include "quasistatic/slow_pulse.hpp"

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

ForcePulse slow_pulse(CompressionLaw law, double poisson, double speed) {
  const double limit = limit_speed(law, poisson);
  std::ostringstream allowed;
  allowed.precision(std::numeric_limits<double>::digits10);
  allowed << min_slow_speed << " to " << limit << " = limit_speed(law, poisson)";
  require("speed", speed, {min_slow_speed, limit, true, true, allowed.str()},
          "in units of c; the static law has no force for the energy of a faster disk");
  // ln(limit/speed), for speeds near the limit without cancellation
  const double excess = speed > 0.5 * limit ? std::log1p((limit - speed) / speed) : std::log(limit) - std::log(speed);
  return ForcePulse(solve_fall(0.5, excess));
}

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

}  // namespace stoss::quasistatic

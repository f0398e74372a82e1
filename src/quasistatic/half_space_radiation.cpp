// Up to the order of Ḟ the ball presses on F = F_static(δ + DḞ): the energy F δ̇ given to the half-space is the change
// of the elastic energy and D Ḟ² (docs/theory/half_space.md).
#include "stoss/quasistatic/half_space_radiation.hpp"

#include <boost/math/special_functions/beta.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "bodies/half_space/lamb_kernel.hpp"
#include "bodies/sphere/mode_search.hpp"
#include "check.hpp"
#include "quasistatic/pulse.hpp"
#include "stoss/quasistatic/slow_impact.hpp"

namespace stoss::quasistatic {
namespace {

using std::numbers::pi;
constexpr double mass = 4.0 * pi / 3.0;
constexpr double max_share = 0.1;  // of the loss that its error may be

void check(const BallOnHalfSpace& bodies) {
  if (!bodies.rigid) bodies::sphere::require_poisson(bodies.poisson);
  require("half_space_poisson", bodies.half_space_poisson, {-0.95, 0.4999, true, true, "-0.95 to 0.4999"},
          "Poisson's ratio of the half-space");
  require("young", bodies.young, {1e-3, 1e6, true, true, "0.001 to 1e6"}, "of the half-space over that of the ball");
  require("density", bodies.density, {1e-3, 1e3, true, true, "0.001 to 1000"},
          "of the half-space over that of the ball");
}

double softness(const BallOnHalfSpace& bodies) {
  const double nu = bodies.half_space_poisson;
  return (bodies.rigid ? 0.0 : 1.0 - bodies.poisson * bodies.poisson) + (1.0 - nu * nu) / bodies.young;
}

double shear_speed(const BallOnHalfSpace& bodies) {
  return std::sqrt(0.5 * bodies.young / (bodies.density * (1.0 + bodies.half_space_poisson)));
}

/// D, in units of the ball.
double radiation_resistance(const BallOnHalfSpace& bodies) {
  const auto kernel = bodies::half_space::lamb_kernel(bodies.half_space_poisson);
  return bodies::half_space::radiation_coefficient(kernel) / (bodies.density * std::pow(shear_speed(bodies), 3.0));
}

RadiusLaw radius_law(PointLaw law, const BallOnHalfSpace& bodies) {
  return bodies.rigid ? RadiusLaw(PointLaw::hertz, 0.0, softness(bodies))
                      : RadiusLaw(law, bodies.poisson, softness(bodies));
}

double limit_speed(const RadiusLaw& law) { return std::sqrt(2.0 * law.energy(law.limit())); }

}  // namespace

double limit_speed(PointLaw law, const BallOnHalfSpace& bodies) {
  check(bodies);
  return limit_speed(radius_law(law, bodies));
}

double radiation_constant(const BallOnHalfSpace& bodies) {
  check(bodies);
  return 7.5 * pi * boost::math::beta(0.8, 1.5) * radiation_resistance(bodies) *
         std::pow(1.25 * pi * softness(bodies), -1.2);
}

HalfSpaceRadiation half_space_radiation(PointLaw law, const BallOnHalfSpace& bodies, double speed) {
  check(bodies);
  const RadiusLaw of = radius_law(law, bodies);
  const double limit = limit_speed(of);
  std::ostringstream allowed;
  allowed.precision(std::numeric_limits<double>::digits10);
  allowed << min_point_speed << " to " << limit;
  require("speed", speed, {min_point_speed, limit, true, true, allowed.str()},
          "in units of c of the ball; there the law of compression ends");

  // λ/(1 − ½λ) = w(v√(1 − ½λ)) grows and falls: one root, and w(v) bounds it.
  const double factor = 2.0 * mass * radiation_resistance(bodies);
  const auto share = [&](double at) { return factor * PointPulse(of, at).squared_force_rate(); };
  const double first_order = share(speed);
  const auto excess = [&](double lambda) {
    return lambda - (1.0 - 0.5 * lambda) * share(speed * std::sqrt(1.0 - 0.5 * lambda));
  };
  double lost = first_order;
  if (first_order > 0.0) {
    const double highest = first_order / (1.0 + 0.5 * first_order);
    constexpr int bits = 50;
    std::uintmax_t steps = 100;
    const auto ends = boost::math::tools::toms748_solve(excess, 0.0, highest, -first_order, excess(highest),
                                                        boost::math::tools::eps_tolerance<double>(bits), steps);
    lost = 0.5 * (ends.first + ends.second);
  }

  const PointPulse pulse(of, speed * std::sqrt(1.0 - 0.5 * lost));
  const Pulse::Contact turn = pulse.at_phase(0.5 * pi);
  const double a = turn.radius, slowness = speed / (a * shear_speed(bodies));
  const double left_out = a * a + lost * lost + slowness * slowness;
  return {.law = law,
          .bodies = bodies,
          .speed = speed,
          .lost_fraction = lost,
          .lost_fraction_error = lost * left_out,
          .first_order = first_order,
          .contact_time = pulse.contact_time(),
          .max_compression = turn.compression,
          .max_force = turn.force,
          .max_radius = a,
          .beyond_perturbation = left_out > max_share};
}

}  // namespace stoss::quasistatic

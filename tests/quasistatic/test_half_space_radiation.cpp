// Loss of a slow ball to a half-space: the law of lowest speeds, the second order in the radiation, and the full
// solution.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "quasistatic/pulse.hpp"
#include "stoss/quasistatic/half_space_radiation.hpp"
#include "stoss/quasistatic/slow_impact.hpp"
#include "support/refusal.hpp"
#include "support/runge_kutta.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

BallOnHalfSpace of_one_material(double poisson, bool rigid) {
  return {.poisson = poisson, .rigid = rigid, .half_space_poisson = poisson};
}

TEST(HalfSpaceRadiation, HasItsConstant) {
  // Quadrature of Hertz' pulse and of the kernel in 20 digits.
  constexpr double table[][3] = {
      {0.0, 1.06319, 2.44256}, {0.25, 1.11153, 2.55363}, {0.3, 1.13181, 2.60022}, {0.45, 1.25749, 2.88896}};
  for (const auto& [poisson, elastic, rigid] : table) {
    EXPECT_NEAR(radiation_constant(of_one_material(poisson, false)), elastic, 1e-5);
    EXPECT_NEAR(radiation_constant(of_one_material(poisson, true)), rigid, 1e-5);
  }
  for (const bool rigid : {false, true}) {
    const BallOnHalfSpace bodies{
        .poisson = -0.3, .rigid = rigid, .half_space_poisson = 0.23, .young = 1.0 / 3.0, .density = 0.32};
    for (const PointLaw law : {PointLaw::hertz, PointLaw::center}) {
      const double ratio = half_space_radiation(law, bodies, 1e-12).lost_fraction / std::pow(1e-12, 0.6);
      // The law of the centre differs by about a ln a.
      EXPECT_NEAR(ratio / radiation_constant(bodies), 1.0, law == PointLaw::hertz ? 2e-7 : 1e-4);
    }
  }
}

TEST(HalfSpaceRadiation, PulseHasHertzsIntegrals) {
  // F = (5/4)(v²/δ)(h/δ)^{3/2} with the velocity v√(1 − (h/δ)^{5/2}).
  const double speed = 1e-3;
  const PointPulse pulse(RadiusLaw(PointLaw::hertz, 0.3), speed);
  const double a = slow_impact(PointLaw::hertz, 0.3, speed).max_radius, scale = speed * speed / (a * a);
  const double force = 1.25 * 1.25 * scale * scale * (a * a / speed) * 0.8 * boost::math::beta(1.6, 0.5);
  const double rate = 1.875 * 1.875 * scale * scale * (speed / (a * a)) * 0.8 * boost::math::beta(0.8, 1.5);
  EXPECT_NEAR(pulse.squared_force() * speed * speed / force, 1.0, 1e-13);
  EXPECT_NEAR(pulse.squared_force_rate() * speed * speed / rate, 1.0, 1e-13);
}

/// Loss of a unit mass with F = h^{3/2}, h = δ + DḞ, from the speed 1: h to the second order in D, in q = √δ and s with
/// dt = 2q ds.
double loss_with_reaction(double resistance) {
  const double d = 1.5 * resistance;
  const auto force = [&](double q, double u) {
    return std::pow(q * q + d * q * u + d * d * (u * u - std::pow(q, 5)), 1.5);
  };
  const auto slope = [&](const std::array<double, 2>& its) {  // of q and of the velocity
    return std::array{its[1], -2.0 * its[0] * force(its[0], its[1])};
  };
  constexpr double h = 1e-4;
  std::array its{0.0, 1.0};
  while (its[1] > 0.0 || its[0] > -2.0 * its[1] * h) its = test::runge_kutta_step(its, h, slope);
  its = test::runge_kutta_step(its, -its[0] / its[1], slope);
  return 1.0 - its[1] * its[1];
}

TEST(HalfSpaceRadiation, SecondOrderFollowsFromTimeReversal) {
  // (w − λ)/w² → 13/20, half the exponent of the energy in w·energy.
  const double height = std::pow(1.25, 0.4);
  const double rate = 2.0 * 1.875 * 1.875 * 0.8 * boost::math::beta(0.8, 1.5) / std::pow(height, 3.0);
  const auto coefficient = [&](double resistance) {
    const double w = rate * resistance;
    return (w - loss_with_reaction(resistance)) / (w * w);
  };
  const double coarse = coefficient(0.002), fine = coefficient(0.001);
  EXPECT_NEAR(2.0 * fine - coarse, 0.65, 2e-3);
  // The loss is that of the mean energy.
  for (const double speed : {1e-5, 1e-3, 0.05}) {
    const BallOnHalfSpace bodies = of_one_material(0.3, false);
    const double lambda = half_space_radiation(PointLaw::center, bodies, speed).lost_fraction;
    const double mean = 1.0 - 0.5 * lambda;
    const double w = half_space_radiation(PointLaw::center, bodies, speed * std::sqrt(mean)).first_order;
    EXPECT_NEAR(mean * w / lambda, 1.0, 1e-13);
  }
}

TEST(HalfSpaceRadiation, MeetsTheFullSolution) {
  // 1 − ε² of the modes of ball and half-space, ν = 0.3, with its error.
  constexpr struct {
    double speed;
    bool rigid;
    double lost, error, time;
  } table[] = {{1e-4, false, 0.0045942, 2.1e-6, 40.553}, {1e-3, false, 0.018768, 6e-6, 25.361},
               {0.01, false, 0.078692, 3.0e-5, 15.707},  {0.1, false, 0.30312, 1.2e-4, 9.541},
               {1e-4, true, 0.0102836, 5.8e-6, 0.0},     {1e-3, true, 0.040105, 1.9e-5, 0.0},
               {0.01, true, 0.147324, 5.7e-5, 0.0},      {0.1, true, 0.44204, 1.1e-4, 0.0}};
  for (const auto& at : table) {
    const HalfSpaceRadiation slow = half_space_radiation(PointLaw::center, of_one_material(0.3, at.rigid), at.speed);
    EXPECT_NEAR(slow.lost_fraction, at.lost, slow.lost_fraction_error + at.error) << at.speed;
    EXPECT_EQ(slow.beyond_perturbation, at.speed == 0.1);
    if (at.rigid) continue;
    EXPECT_NEAR(slow.contact_time / at.time, 1.0, 0.2 * slow.max_radius * slow.max_radius) << at.speed;
  }
  const double c = std::sqrt(2.1e11 / 7850.0);  // steel on glass at 1 m/s
  const BallOnHalfSpace bodies{
      .poisson = 0.3, .half_space_poisson = 0.23, .young = 70.0 / 210.0, .density = 2500.0 / 7850.0};
  EXPECT_NEAR(half_space_radiation(PointLaw::center, bodies, 1.0 / c).lost_fraction, 0.0085314, 7.5e-6);
}

TEST(HalfSpaceRadiation, GoesUpToItsLimit) {
  for (const bool rigid : {false, true}) {
    const BallOnHalfSpace bodies = of_one_material(0.3, rigid);
    const double limit = limit_speed(PointLaw::center, bodies);
    EXPECT_NO_THROW((void)half_space_radiation(PointLaw::center, bodies, limit));
    test::expect_refusal([&] { (void)half_space_radiation(PointLaw::center, bodies, std::nextafter(limit, 1.0)); },
                         {"speed", "1e-12"});
  }
  // Hertz' law ends where the contact is as wide as the ball: (8/15) a⁵/(π S) = ½v² at a = 1, mass 4π/3.
  EXPECT_NEAR(limit_speed(PointLaw::hertz, of_one_material(0.3, true)), std::sqrt(0.8 / (std::numbers::pi * 0.91)),
              1e-12);
  test::expect_refusal([] { (void)limit_speed(PointLaw::center, {.young = 2e6}); }, {"young"});
}

TEST(HalfSpaceRadiation, RefusesWhatIsOutOfRange) {
  const auto of = [](BallOnHalfSpace bodies, double speed = 1e-3) {
    return [bodies, speed] { (void)half_space_radiation(PointLaw::center, bodies, speed); };
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  test::expect_refusal(of({.poisson = 0.5}), {"poisson", "0.5"});
  test::expect_refusal(of({.half_space_poisson = nan}), {"half_space_poisson", "nan"});
  test::expect_refusal(of({.young = 9e-4}), {"young", "0.001 to 1e6"});
  test::expect_refusal(of({.density = 0.0}), {"density", "0.001 to 1000"});
  test::expect_refusal(of({}, 0.5), {"speed", "1e-12"});
  test::expect_refusal(of({}, -1e-3), {"speed", "1e-12"});
  test::expect_refusal([] { (void)radiation_constant({.young = 2e6}); }, {"young"});
  EXPECT_NO_THROW(of({.poisson = nan, .rigid = true})());
}

}  // namespace
}  // namespace stoss

// Impacts of lossy round bodies: Ting's law and the point law against published series and fits, and other
// integrations.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "quasistatic/lossy_motion.hpp"
#include "stoss/quasistatic/point_lossy_impact.hpp"
#include "stoss/quasistatic/slow_impact.hpp"
#include "support/refusal.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

constexpr double mass = 4.0 * std::numbers::pi / 3.0;

LossyContact ball(double poisson, double loss_time) { return {{1.0, 1.0 - poisson * poisson}, mass, loss_time}; }

TEST(PointLossyImpact, HasTheNumbersOfAnotherIntegration) {
  // An embedded Runge-Kutta method of order 8 in time, and the values of ν = 0.3.
  constexpr double table[][3] = {{0.001, 0.9988476389076, 0.9988473573054},
                                 {0.02475225400429401, 0.9721023384186, 0.9719554477771},
                                 {0.07425676201288203, 0.9199828479319, 0.9188992319100},
                                 {0.621748509826648, 0.5534954581296, 0.5337549300736},
                                 {3.0, 0.1580973224611, 0.1337166224076},
                                 {10.0, 0.0334395721611, 0.0250957044315}};
  for (const auto& [x, ting, point] : table) {
    EXPECT_NEAR(lossy_motion(LossyLaw::ting, x).restitution, ting, 5e-11) << x;
    EXPECT_NEAR(lossy_motion(LossyLaw::point, x).restitution, point, 5e-11) << x;
  }
  EXPECT_NEAR(lossy_impact(LossyLaw::ting, ball(0.3, 1.0), 1e-8).restitution, 0.9721023, 5e-8);
  EXPECT_NEAR(lossy_impact(LossyLaw::ting, ball(0.3, 3.0), 1e-8).restitution, 0.9199828, 5e-8);
  EXPECT_NEAR(lossy_impact(LossyLaw::ting, ball(0.3, 10.0), 1e-6).restitution, 0.5534955, 5e-8);
}

TEST(PointLossyImpact, HasItsSeries) {
  const double first = 0.8 * std::pow(1.25, 0.6) * boost::math::beta(0.6, 1.5);
  const double second = 0.6 * first * first + 5.0 / 18.0 * std::pow(1.25, 0.2);
  for (const double x : {1e-3, 1e-2}) {
    const double ting = lossy_motion(LossyLaw::ting, x).restitution;
    EXPECT_NEAR(ting, 1.0 - first * x + second * x * x, 1.0 * x * x * x);
    // γ₁ and γ₂ of T. Schwager and T. Pöschel, Phys. Rev. E 57, 650 (1998).
    const double point = lossy_motion(LossyLaw::point, x).restitution;
    EXPECT_NEAR(point, 1.0 - first * x + 0.6 * first * first * x * x, 0.3 * std::pow(x, 2.5));
  }
}

TEST(PointLossyImpact, IsElasticWithoutLoss) {
  for (const LossyLaw law : {LossyLaw::ting, LossyLaw::point}) {
    const LossyImpact impact = lossy_impact(law, ball(0.3, 0.0), 1e-3);
    const SlowImpact hertz = slow_impact(PointLaw::hertz, 0.3, 1e-3);
    EXPECT_NEAR(impact.restitution, 1.0, 1e-14);
    EXPECT_NEAR(impact.contact_time / hertz.contact_time, 1.0, 1e-13);
    EXPECT_NEAR(impact.max_compression / hertz.max_compression, 1.0, 1e-13);
  }
}

TEST(PointLossyImpact, PointLawIsThatOfThePublishedFit) {
  // The [3/6] Padé approximant of P. Müller and T. Pöschel, Phys. Rev. E 84, 021302 (2011), in √x.
  constexpr std::array above{1.0, 1.07232, 0.574198, 0.141552};
  constexpr std::array below{1.0, 1.07232, 1.72765, 1.37842, 1.19449, 0.467273, 0.235585};
  const auto sum = [](const auto& terms, double root) {
    double value = 0.0;
    for (std::size_t i = terms.size(); i-- > 0;) value = value * root + terms[i];
    return value;
  };
  for (const double x : {0.01, 0.1, 0.5, 1.0, 3.0}) {
    const double fit = sum(above, std::sqrt(x)) / sum(below, std::sqrt(x));
    EXPECT_NEAR(lossy_motion(LossyLaw::point, x).restitution, fit, 6e-4) << x;
    EXPECT_GT(lossy_motion(LossyLaw::ting, x).restitution, lossy_motion(LossyLaw::point, x).restitution);
  }
}

TEST(PointLossyImpact, ConvergesToNothingForGreatLoss) {
  double before = 1.0;
  for (double x = 1e-12; x <= 1e6; x *= 10.0) {
    for (const LossyLaw law : {LossyLaw::ting, LossyLaw::point}) {
      const double restitution = lossy_motion(law, x).restitution;
      EXPECT_GT(restitution, 0.0);
      EXPECT_LE(restitution, 1.0);
    }
    EXPECT_LT(lossy_motion(LossyLaw::ting, x).restitution, before + 1e-14);
    before = lossy_motion(LossyLaw::ting, x).restitution;
  }
  // Without inertia the ball stops where (2/3) x δ^{3/2} = 1.
  EXPECT_NEAR(std::pow(lossy_motion(LossyLaw::ting, 1e6).max_compression, 1.5) * 2e6 / 3.0, 1.0, 1e-3);
}

TEST(PointLossyImpact, HasItsFirstOrderOfAnyLaw) {
  boost::math::quadrature::tanh_sinh<double> integrate;
  for (const double nu : {-0.5, 0.3, 0.49}) {
    for (const double speed : {1e-8, 1e-3, 0.03}) {
      const LossyImpact hertz = lossy_impact(LossyLaw::ting, ball(nu, 1e-6), speed);
      const double first = 0.8 * std::pow(1.25, 0.6) * boost::math::beta(0.6, 1.5) * hertz.loss_number;
      EXPECT_NEAR(viscous_loss(PointLaw::hertz, nu, 1e-6, speed) / first, 1.0, 1e-12);
      // (1 − ε²)/2 = (2η/v²)∫√(v² − 2U) dF
      const double greatest = slow_impact(PointLaw::center, nu, speed).max_force;
      const auto velocity = [&](double share) {
        const double energy = compression_energy(PointLaw::center, nu, greatest * share);
        return std::sqrt(std::max(0.0, 1.0 - 2.0 * energy / (speed * speed)));
      };
      const double expected = 2.0 * greatest / speed * integrate.integrate(velocity, 0.0, 1.0);
      EXPECT_NEAR(viscous_loss(PointLaw::center, nu, 1.0, speed) / expected, 1.0, 1e-10) << nu << " " << speed;
    }
  }
}

TEST(PointLossyImpact, OfTwoEqualBodiesIsThatAtAWall) {
  // Two equal bodies that meet at 2v are one at a wall at v.
  const LossyImpact wall = lossy_impact(LossyLaw::ting, ball(0.3, 0.5), 1e-4);
  const LossyImpact pair = lossy_impact(LossyLaw::ting, {{2.0, 2.0 * 0.91}, 0.5 * mass, 0.5}, 2e-4);
  EXPECT_NEAR(pair.restitution, wall.restitution, 1e-14);
  EXPECT_NEAR(pair.contact_time / wall.contact_time, 1.0, 1e-14);
  EXPECT_NEAR(pair.max_compression / wall.max_compression, 2.0, 1e-14);
}

TEST(PointLossyImpact, RefusesWhatIsOutOfRange) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto of = [](LossyContact contact, double speed) {
    return [contact, speed] { (void)lossy_impact(LossyLaw::ting, contact, speed); };
  };
  test::expect_refusal(of(ball(0.3, -1.0), 1e-3), {"loss_time", "-1"});
  test::expect_refusal(of(ball(0.3, nan), 1e-3), {"loss_time", "nan"});
  test::expect_refusal(of(ball(0.3, 1e9), 1e-3), {"loss_number", "0 to 1e6"});
  test::expect_refusal(of({{0.0, 1.0}, 1.0, 0.1}, 1e-3), {"curvature"});
  test::expect_refusal(of({{1.0, 0.0}, 1.0, 0.1}, 1e-3), {"softness"});
  test::expect_refusal(of({{1.0, 1.0}, infinity, 0.1}, 1e-3), {"mass"});
  test::expect_refusal(of(ball(0.3, 0.1), 0.0), {"speed"});
  test::expect_refusal([] { (void)viscous_loss(PointLaw::hertz, 0.3, nan, 1e-3); }, {"loss_time"});
}

}  // namespace
}  // namespace stoss

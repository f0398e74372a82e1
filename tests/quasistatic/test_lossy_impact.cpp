// What a lossy material takes of a slow impact of a disk, to first order: power, asymptotics and range.
#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "stoss/quasistatic/slow_impact.hpp"
#include "support/refusal.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

using std::numbers::pi;

TEST(LossyImpact, DiskLosesThePowerOfItsStiffness) {
  // (1 − ε²)/2 = (1/v²)∫η δ̇² (dF/dδ) dt = (2η/v²)∫√(v² − 2U) dF.
  boost::math::quadrature::tanh_sinh<double> integrate;
  for (const CompressionLaw law : {CompressionLaw::center, CompressionLaw::diameter}) {
    for (const double nu : {-0.5, 0.33, 0.9}) {
      for (const double speed : {1e-50, 1e-8, 1e-3, 0.05}) {
        const double greatest = slow_impact(law, nu, speed).max_force;
        const double a = speed * speed / (greatest * greatest);
        const auto velocity = [&](double f) { return std::sqrt(std::max(0.0, 1.0 - f * f * (1.0 - std::log(f) / a))); };
        const double expected = 2.0 * greatest / speed * integrate.integrate(velocity, 0.0, 1.0);
        EXPECT_NEAR(viscous_loss(law, nu, 1.0, speed) / expected, 1.0, 1e-11) << nu << " " << speed;
      }
    }
  }
}

TEST(LossyImpact, DiskHasItsAsymptotics) {
  for (const double speed : {1e-8, 1e-100}) {
    const SlowImpact impact = slow_impact(CompressionLaw::center, 0.33, speed);
    const double a = speed * speed / (impact.max_force * impact.max_force);
    const double leading = 0.5 * pi / std::sqrt(a);
    const double ratio = viscous_loss(CompressionLaw::center, 0.33, 1.0, speed) / leading;
    EXPECT_NEAR(ratio, 1.0 - (2.0 * std::numbers::ln2 - 1.0) / (4.0 * a), 0.05 / (a * a));
  }
}

TEST(LossyImpact, DiskIsLinearInItsLossTimeAndRefusesOthers) {
  const auto loss = [](double loss_time, double speed = 1e-3) {
    return viscous_loss(CompressionLaw::center, 0.33, loss_time, speed);
  };
  EXPECT_EQ(loss(0.0), 0.0);
  EXPECT_DOUBLE_EQ(loss(1e-3), 0.1 * loss(1e-2));
  for (const double loss_time : {-1e-3, 1001.0, std::numeric_limits<double>::quiet_NaN()}) {
    test::expect_refusal([&] { (void)loss(loss_time); }, {"loss_time", "0 to 1000"});
  }
  test::expect_refusal([&] { (void)loss(0.01, 0.5); }, {"speed", "limit_speed"});
}

}  // namespace
}  // namespace stoss

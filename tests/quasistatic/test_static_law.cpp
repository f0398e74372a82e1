// All static laws, of lines and of points, by the same functions: energy, momentum and the end of the law.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "quasistatic/pulse.hpp"
#include "stoss/quasistatic/slow_impact.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

constexpr std::array<StaticLaw, 4> static_laws{CompressionLaw::center, CompressionLaw::diameter, PointLaw::hertz,
                                               PointLaw::center};

TEST(StaticLaw, HasEnergyMomentumAndAnEnd) {
  for (const StaticLaw& law : static_laws) {
    const double nu = 0.3, last = limit_speed(law, nu);
    EXPECT_NEAR(0.5 * last * last / compression_energy(law, nu, limit_force(law, nu)), 1.0, 1e-14);
    for (const double speed : {1e-9, 1e-3, 0.5 * last}) {
      const SlowImpact impact = slow_impact(law, nu, speed);
      EXPECT_TRUE(impact.law == law);
      EXPECT_NEAR(compression_energy(law, nu, impact.max_force) / (0.5 * speed * speed), 1.0, 1e-12);
      EXPECT_NEAR(compression_force(law, nu, impact.max_compression) / impact.max_force, 1.0, 1e-12);
      EXPECT_EQ(impact.max_radius > 0.0, law.index() == 1);
      const auto pulse = slow_pulse(law, nu, speed);
      double impulse = 0.0, square = 0.0;
      const Pulse::Nodes nodes = pulse->nodes(0.0);
      for (const double weight : nodes.weight) impulse += weight;
      EXPECT_NEAR(impulse, 2.0, 1e-12);
      // By the history: ∫F² dt with the trapezium rule.
      constexpr int count = 4000;
      std::vector<double> phases;
      for (int i = 0; i <= count; ++i) phases.push_back(std::acos(-1.0) * i / count);
      const auto history = contact_history(impact, phases);
      for (std::size_t i = 1; i < history.size(); ++i) {
        const double mean = 0.5 * (history[i].force * history[i].force + history[i - 1].force * history[i - 1].force);
        square += mean * (history[i].time - history[i - 1].time);
      }
      EXPECT_NEAR(viscous_loss(law, nu, 1.0, speed) / (square / (speed * speed)), 1.0, 1e-5);
    }
  }
}

}  // namespace
}  // namespace stoss

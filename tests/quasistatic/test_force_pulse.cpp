// The pulse of force of a slow impact, apart from scales.
#include "quasistatic/pulse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>

namespace stoss {
using namespace quasistatic;

namespace {

double sum_of(const Pulse::Nodes& nodes, double omega) {
  double result = 0.0;
  for (std::size_t i = 0; i < nodes.time.size(); ++i) result += nodes.weight[i] * std::cos(omega * nodes.time[i]);
  return result;
}

TEST(SlowImpactPulse, NodesResolveTheFrequencyThatTheyAreMadeFor) {
  for (const double depth : {1e-14, 1e-6, 1e-2, 0.5, 3.0, 10.0, 27.0, 230.0}) {
    const LinePulse pulse(depth);
    const Pulse::Nodes finer = pulse.nodes(4e3);
    for (const double omega : {0.01, 1.0, 10.0, 63.0, 250.0, 1000.0}) {
      const double allowed = depth < 1e-2 ? 2e-11 : 4e-13;
      EXPECT_NEAR(sum_of(pulse.nodes(omega), omega), sum_of(finer, omega), allowed) << depth << " " << omega;
    }
    EXPECT_NEAR(sum_of(pulse.nodes(0.0), 0.0), 2.0, 1e-13);  // the impulse is 2mv
    EXPECT_NEAR(2.0 * finer.time.back() / pulse.contact_time(), 1.0, 1e-7);
  }
}

TEST(SlowImpactPulse, SolvesForTheForceAtAnEnergy) {
  for (const double factor : {0.5, 0.5 + 1e-9, 1.0, 30.0}) {
    EXPECT_EQ(solve_fall(factor, 0.0), 0.0);
    for (const double fall : {1e-7, 1e-3, 0.1, 2.0, 40.0}) {
      const double excess = fall - 0.5 * std::log1p(fall / factor);
      // For A = ½ the excess is y² at small y, and its rounding that of a difference of terms y.
      EXPECT_NEAR(solve_fall(factor, excess) / fall, 1.0, 1e-15 * (4.0 + (1.0 + fall) / fall)) << factor << " " << fall;
    }
  }
}

TEST(SlowImpactPulse, HasTheLinearSpringAsALimit) {
  // D → ∞: δ = A F, whose contact time is π√A; the next term is the one of the asymptotics.
  for (const double depth : {1e6, 1e9, 1e12}) {
    const LinePulse pulse(depth);
    const double expected = std::numbers::pi * std::sqrt(pulse.energy_factor());
    EXPECT_NEAR(pulse.contact_time() / expected - 1.0, 0.5 * std::numbers::ln2 / depth, 1e-14 + 1.0 / (depth * depth));
  }
}

TEST(SlowImpactPulse, AmplitudesOfTheLinearSpringAreThoseOfHalfASine) {
  const LinePulse pulse(1e12);
  const double time = pulse.contact_time();
  for (const double cycles : {0.01, 0.5, 1.3, 2.4, 7.6, 40.2}) {  // ωτ/π
    const double omega = std::numbers::pi * cycles / time;
    const double expected = 2.0 * std::cos(0.5 * std::numbers::pi * cycles) / (1.0 - cycles * cycles);
    EXPECT_NEAR(sum_of(pulse.nodes(omega), omega), expected, 1e-11) << cycles;
  }
}

}  // namespace
}  // namespace stoss

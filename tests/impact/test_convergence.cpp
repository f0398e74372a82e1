// Observed orders of convergence, and the rod, whose impact at a hard wall is known exactly: ε = 1, contact time 2 L/c,
// force mvc/L throughout.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss {
namespace {

/// log₂ of the ratio of successive differences: the order for steps that are halved.
double observed_order(double coarse, double middle, double fine) {
  return std::log2(std::abs(coarse - middle) / std::abs(middle - fine));
}

TEST(RodImpact, TendsToTheExactOneAtFirstOrderInTheCutoff) {
  std::vector<double> restitution_error;
  for (const double cutoff : {50.0, 100.0, 200.0, 400.0, 800.0}) {
    const Impact result = impact(rod(cutoff), HardWall{}, 0.1);
    EXPECT_EQ(result.contacts, 1);
    restitution_error.push_back(std::abs(result.restitution - 1.0));
    EXPECT_NEAR(result.contact_time, 2.0, result.resolution.step);
    EXPECT_NEAR(result.max_compression, 0.05, 0.01 / cutoff);  // half of v L/c: it stops in the middle
  }
  for (std::size_t i = 1; i < restitution_error.size(); ++i) {
    EXPECT_GE(std::log2(restitution_error[i - 1] / restitution_error[i]), 0.95);
  }
  EXPECT_LT(restitution_error.back(), 1e-3);
}

TEST(RodImpact, TendsToTheExactOneWithTheStaticTailToo) {
  for (const double cutoff : {50.0, 100.0, 200.0, 400.0, 800.0}) {
    const Impact result = impact(rod(cutoff), HardWall{}, 0.1, {.resolution = {.tail = Tail::quasistatic}});
    // It rings at the cutoff, so the error depends on its phase; the envelope falls with the cutoff.
    EXPECT_NEAR(result.restitution, 1.0, 1.2 / cutoff) << cutoff;
    EXPECT_NEAR(result.contact_time, 2.0, 2.0 / cutoff) << cutoff;
  }
}

TEST(RodImpact, HasTheConstantForceOfTheExactOne) {
  double before = 1.0;
  for (const double cutoff : {100.0, 400.0, 1600.0}) {
    double deviation = 0.0;
    int count = 0;
    const ImpactObserver observer = [&](const Snapshot& now) {
      // First contact is at time 0 but for a step.
      if (now.time < 0.2 || now.time > 1.8) return;
      deviation += std::abs(now.force / 0.1 - 1.0);
      ++count;
    };
    (void)impact(rod(cutoff), HardWall{}, 0.1, {}, {observer});
    deviation /= count;
    EXPECT_LT(deviation, 0.5 * before) << cutoff;
    before = deviation;
  }
  EXPECT_LT(before, 5e-3);
}

TEST(RodImpact, DoesNotDependOnTheSpeed) {
  const Impact fast = impact(rod(100.0), HardWall{}, 0.1, {.resolution = {.step = 0.002}});
  for (const double speed : {1e-6, 1e-3, 0.3}) {
    const Impact other = impact(rod(100.0), HardWall{}, speed, {.resolution = {.step = 0.002}});
    EXPECT_NEAR(other.restitution, fast.restitution, 1e-9);
    EXPECT_NEAR(other.max_force / speed, fast.max_force / 0.1, 1e-8);
  }
}

TEST(StepOrder, IsTwoForADiskAtTheExponentialWall) {
  const Body body = disk(0.33, 25.0);
  std::vector<double> restitution, force;
  for (const double step : {0.004, 0.002, 0.001, 0.0005}) {
    const Impact result =
        impact(body, ExponentialWall{100.0, 1.0}, 0.1, {.resolution = {.step = step, .tail = Tail::none}});
    restitution.push_back(result.restitution);
    EXPECT_NEAR(result.energy_error, 0.0, 1e-10);
  }
  EXPECT_NEAR(observed_order(restitution[0], restitution[1], restitution[2]), 2.0, 0.05);
  EXPECT_NEAR(observed_order(restitution[1], restitution[2], restitution[3]), 2.0, 0.05);
}

TEST(StepOrder, IsTwoForARodAtTheExponentialWall) {
  const Body body = rod(50.0);
  std::vector<double> restitution;
  for (const double step : {0.004, 0.002, 0.001, 0.0005}) {
    restitution.push_back(
        impact(body, ExponentialWall{100.0, 1.0}, 0.1, {.resolution = {.step = step, .tail = Tail::none}}).restitution);
  }
  EXPECT_NEAR(observed_order(restitution[0], restitution[1], restitution[2]), 2.0, 0.05);
  EXPECT_NEAR(observed_order(restitution[1], restitution[2], restitution[3]), 2.0, 0.05);
}

TEST(StepOrder, OfTheVelocityInsideAContactIsTwo) {
  // Not only at the end: the velocity in the middle of the contact converges too.
  const Body body = rod(40.0);
  std::vector<double> velocity;
  for (const int per_unit : {400, 800, 1600, 3200, 6400}) {
    double found = 0.0;
    const double step = 1.0 / per_unit;
    const ImpactObserver observer = [&](const Snapshot& now) {
      if (std::lround(now.time * per_unit) == per_unit) found = now.velocity;
    };
    (void)impact(body, ExponentialWall{200.0, 1.0}, 0.1, {.resolution = {.step = step, .tail = Tail::none}},
                 {observer});
    velocity.push_back(found);
  }
  for (std::size_t i = 3; i < velocity.size(); ++i) {
    EXPECT_NEAR(observed_order(velocity[i - 2], velocity[i - 1], velocity[i]), 2.0, 0.1);
  }
}

TEST(SmallSteps, LeaveTheRadiatingTailStable) {
  const Body body = disk(0.33, 12.5);
  const double expected = impact(body, HardWall{}, 0.1, {.resolution = {.step = 1e-4}}).lost_fraction;
  for (const double step : {4e-5, 1e-5}) {
    const Impact result = impact(body, HardWall{}, 0.1, {.resolution = {.step = step}});
    EXPECT_NEAR(result.lost_fraction, expected, 1e-6) << step;
    EXPECT_NEAR(result.energy_error, 0.0, 1e-9) << step;
  }
}

TEST(CutoffConvergence, OfTheRadiatingTailIsFasterThanOfTheStaticOne) {
  for (const double speed : {0.02, 0.1, 0.3}) {
    const double converged = impact(disk(0.33, 100.0), HardWall{}, speed).lost_fraction;
    double radiating = 0.0, fixed = 0.0;  // errors, summed over cutoffs because the static tail's changes its sign
    for (const double cutoff : {12.5, 25.0, 50.0}) {
      const Body body = disk(0.33, cutoff);
      radiating += std::abs(impact(body, HardWall{}, speed).lost_fraction - converged);
      fixed += std::abs(impact(body, HardWall{}, speed, {.resolution = {.tail = Tail::quasistatic}}).lost_fraction -
                        converged);
    }
    EXPECT_LT(radiating, 0.5 * fixed) << speed;
    EXPECT_LT(radiating, 0.02 * converged) << speed;
  }
}

}  // namespace
}  // namespace stoss

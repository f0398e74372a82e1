// Impacts of lossy bodies (docs/theory/loss.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/replay.hpp"
#include "stoss/restitution/ladder.hpp"

namespace stoss {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Contact lossy_sphere(double loss_time, double cutoff) {
  return contact(sphere(Sphere{.poisson = 0.3, .loss_time = loss_time}, cutoff));
}

double restitution_with(double loss_time, double speed, double cutoff, int nodes) {
  const Resolution resolution{.step = 0.5 / cutoff, .nodes = nodes};
  return impact(lossy_sphere(loss_time, cutoff), speed, {.resolution = resolution}).restitution;
}

}  // namespace

// Values of an independent program for ν = 0.3.
TEST(LossySphere, LosesWhatAnIndependentProgramSays) {
  EXPECT_NEAR(restitution_with(0.1, 0.01, 32.0, 128), 0.95074, 1.5e-5);
  EXPECT_NEAR(restitution_with(0.3, 0.01, 32.0, 128), 0.86565, 2e-5);
  EXPECT_NEAR(restitution_with(1.0, 0.01, 32.0, 128), 0.64929, 2e-5);
  EXPECT_NEAR(restitution_with(1.0, 1e-8, 16.0, 128), 0.9720963, 2e-6);
  EXPECT_NEAR(restitution_with(3.0, 1e-8, 16.0, 128), 0.9199665, 1e-6);
  EXPECT_NEAR(restitution_with(10.0, 1e-6, 16.0, 128), 0.5530874, 1e-6);
}

// 1 − ε = 1.15345 βv^{1/5} − 1.08872 β²v^{2/5}, β = (3/2) η (k/m)^{2/5}, k = (4/3) E*√R, of a point that obeys Hertz'
// law with this loss and, in the second order, Ting's: a ball of finite size loses more, by a share that falls with its
// speed.
TEST(LossySphere, TendsToTheFirstOrderLaw) {
  const double eta = 0.01, stiffness = 4.0 / 3.0 / (1.0 - 0.09), mass = 4.0 / 3.0 * std::acos(-1.0);
  const auto excess = [&](double speed) {
    const double x = 1.5 * eta * std::pow(stiffness / mass, 0.4) * std::pow(speed, 0.2);
    return (1.0 - restitution_with(eta, speed, 16.0, 128)) / (1.15345 * x - 1.08872 * x * x) - 1.0;
  };
  const double slow = excess(1e-8), faster = excess(1e-6);
  EXPECT_GT(slow, -1e-3);
  EXPECT_LT(slow, 1.5e-3);
  EXPECT_GT(faster, 1.5e-3);
  EXPECT_LT(faster, 4e-3);
}

TEST(LossyBodies, LoseNothingWithoutALossTime) {
  const Impact without = impact(contact(sphere(0.3, 20.0)), 0.1), with = impact(lossy_sphere(0.0, 20.0), 0.1);
  EXPECT_EQ(with.restitution, without.restitution);
  EXPECT_EQ(with.final_state.coordinate, without.final_state.coordinate);
  EXPECT_EQ(with.energy.dissipated, 0.0);
  // A small loss time has effects of first order; in addition, what kicks leave out is no longer in the springs.
  const double least = impact(lossy_sphere(1e-8, 20.0), 0.1).restitution;
  EXPECT_NEAR(least, without.restitution, 1e-5);
  const double small = impact(lossy_sphere(1e-4, 20.0), 0.1).restitution - least;
  const double smaller = impact(lossy_sphere(1e-5, 20.0), 0.1).restitution - least;
  EXPECT_LT(small, -1e-5);
  EXPECT_NEAR(smaller / small, 0.1, 0.01);
}

TEST(LossyBodies, KeepTheModesThatStepsResolve) {
  EXPECT_EQ(kept_cutoff(32.0, 0.0), 32.0);
  EXPECT_EQ(kept_cutoff(32.0, 0.03), 32.0);
  EXPECT_DOUBLE_EQ(kept_cutoff(32.0, 0.5), 8.0);
  for (const Body& body : {sphere(Sphere{.poisson = 0.3, .loss_time = 0.5}, 32.0),
                           disk(Disk{.poisson = 0.3, .loss_time = 0.5}, 32.0), rod(Rod{.loss_time = 0.5}, 32.0)}) {
    double highest = 0.0;
    for (const ModeGroup& group : body.groups) highest = std::max(highest, group.omega.back());
    EXPECT_GT(highest, 6.0) << body.name;
    EXPECT_LE(highest, kept_cutoff(body)) << body.name;
    EXPECT_EQ(body.cutoff, 32.0);
    EXPECT_EQ(body.loss_time, 0.5);
  }
  EXPECT_EQ(mode_count(sphere(Sphere{.poisson = 0.3, .loss_time = 100.0}, 32.0)), 0U);
  EXPECT_GT(impact(lossy_sphere(100.0, 32.0), 0.01).restitution, 0.0);
}

TEST(LossyBodies, DissipateMoreAndMore) {
  for (const double loss_time : {0.01, 0.3, 10.0}) {
    std::vector<double> dissipated;
    const auto observer = [&](const Snapshot& now) {
      dissipated.push_back(now.dissipated);
      EXPECT_NEAR(now.translation + now.vibration + now.dissipated + now.stored + now.unresolved, 1.0, 2e-2);
    };
    const Impact result = impact(lossy_sphere(loss_time, 25.0), 0.03, {}, {observer});
    EXPECT_EQ(dissipated.front(), 0.0);
    EXPECT_EQ(dissipated.back(), result.energy.dissipated);
    for (std::size_t i = 1; i < dissipated.size(); ++i) EXPECT_GE(dissipated[i], dissipated[i - 1] - 1e-6) << i;
    EXPECT_NEAR(result.energy.lost_to_first, result.lost_fraction, 2e-4);
  }
}

TEST(LossyBodies, LoseAsMuchWithEitherTail) {
  const Contact meeting = lossy_sphere(0.3, 40.0);
  const Impact radiating = impact(meeting, 0.01, {.resolution = {.nodes = 64}});
  const Impact fixed = impact(meeting, 0.01, {.resolution = {.nodes = 64, .tail = Tail::quasistatic}});
  EXPECT_NEAR(fixed.restitution, radiating.restitution, 2e-4);
  EXPECT_NEAR(fixed.energy.dissipated, radiating.energy.dissipated, 1e-3);
  EXPECT_NEAR(fixed.energy_error, 0.0, 2e-4);
}

TEST(LossyPairs, TheLossierBodyTakesMore) {
  const auto lost = [](double first, double second) {
    const BodyMaker one = sphere(Sphere{.poisson = 0.3, .loss_time = first});
    const BodyMaker other = sphere(Sphere{.poisson = 0.3, .loss_time = second});
    return impact(contact(one, other, 25.0), 0.01).energy;
  };
  const EnergyLedger both = lost(0.1, 0.1), one = lost(0.1, 0.0), other = lost(0.03, 0.01);
  EXPECT_NEAR(both.lost_to_first, both.lost_to_second, 1e-12);
  const double none = lost(0.0, 0.0).lost_to_first;  // but for vibration
  EXPECT_GT(one.lost_to_first, 50.0 * one.lost_to_second);
  // In the first order each loses in proportion to its loss time.
  EXPECT_NEAR(one.lost_to_first / both.lost_to_first, 1.0, 0.05);
  EXPECT_NEAR((other.lost_to_first - none) / (other.lost_to_second - none), 3.0, 0.15);
}

TEST(LossyBodies, RelaxInFreeMotion) {
  const Contact meeting = lossy_sphere(0.02, 12.0);
  const State after = impact(meeting, 0.1).final_state;
  double before = infinite;
  for (const double time : {0.0, 1.0, 5.0, 200.0}) {
    double energy = 0.0;
    for (const double each : mode_energies(meeting, free_motion(meeting, after, time))) energy += each;
    EXPECT_LT(energy, before);
    before = energy;
  }
  EXPECT_LT(before, 1e-6);
  const State there = free_motion(meeting, after, 3.0), back = free_motion(meeting, there, -3.0);
  for (std::size_t k = 0; k < after.coordinate.size(); ++k) {
    EXPECT_NEAR(back.coordinate[k], after.coordinate[k], 1e-9);
  }
  EXPECT_THROW((void)free_motion(meeting, after, -1e4), InvalidInput);
}

TEST(LossyBodies, RefuseLossTimesThatAreNone) {
  EXPECT_THROW((void)sphere(Sphere{.poisson = 0.3, .loss_time = 2e5}), InvalidInput);
  Body body = rod(20.0);
  body.loss_time = 1.0;  // its modes are those up to 20, not up to √20
  EXPECT_THROW(validate(body), InvalidInput);
  body.loss_time = -1.0;
  EXPECT_THROW(validate(body), InvalidInput);
}

}  // namespace stoss
